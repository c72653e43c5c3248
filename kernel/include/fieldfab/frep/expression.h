/// Expressions: immutable graphs of operations in which equal parts are one part (hash-consing; Keeter 3.4, 3.5).
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fieldfab/field/field.h"
#include "fieldfab/frep/opcode.h"

namespace fieldfab::frep {

struct Node;

/// A solid that is no formula (a scan, a mesh, a design), made usable in formulas: its Field, and how a text names it.
struct Source : std::enable_shared_from_this<Source> {
  FieldPtr field;
  std::filesystem::path path;  ///< absolute; empty for what was made in memory, which no text can name
  std::string options;         ///< how it was opened, as open() of .frep text has it: "threshold = 300, smooth = 1"
  virtual ~Source() = default;
};
using SourcePtr = std::shared_ptr<const Source>;

/// A node of an expression graph, held by reference count. Two expressions of the same form are the same node, so == is one
/// comparison and costs nothing. Safe to make, copy and drop from many threads. Any depth: nothing here recurses.
class Expression {
 public:
  /// A constant. Throws Error(bad_input) where `value` is NaN or infinite. -0 becomes 0.
  Expression(double value);  // NOLINT(google-explicit-constructor): numbers are expressions
  Expression(const Expression& other) noexcept;
  Expression(Expression&& other) noexcept;
  Expression& operator=(Expression other) noexcept;
  ~Expression();

  static Expression x();
  static Expression y();
  static Expression z();
  /// op(a), op(a, b): exactly this node, deduplicated, with nothing folded or simplified.
  static Expression make(Opcode op, const Expression& a);
  static Expression make(Opcode op, const Expression& a, const Expression& b);
  /// The value of an opened Field at (x, y, z).
  static Expression opened(const SourcePtr& source, const Expression& x, const Expression& y, const Expression& z);

  [[nodiscard]] Opcode opcode() const noexcept;
  /// The value of a constant; 0 for any other node.
  [[nodiscard]] double constant() const noexcept;
  /// One of the arguments (index below arity()).
  [[nodiscard]] Expression argument(int index) const;
  [[nodiscard]] int arity() const noexcept { return info(opcode()).arity; }
  /// The Field of an `opened` node, else null.
  [[nodiscard]] SourcePtr source() const;

  /// Two names of one node.
  bool operator==(const Expression& other) const noexcept { return node_ == other.node_; }
  /// An address for hashing; the same for equal expressions while any of them lives.
  [[nodiscard]] const Node* id() const noexcept { return node_; }

 private:
  explicit Expression(const Node* node) noexcept : node_(node) {}
  const Node* node_;
};

/// Every node once, each after its arguments (a topological order, the same for the same expression): `order.back()` is the root.
struct Flat {
  struct Entry {
    Opcode op;
    double constant;     ///< where op is constant
    std::uint32_t a, b;  ///< indices of the arguments; 0 where there is none
    std::uint32_t c = 0;
    const Source* source = nullptr;  ///< where op is `opened`; lives as long as the expression
  };
  std::vector<Entry> order;
};
Flat flatten(const Expression& root);

/// The node of an entry, over arguments that were made before it (by their places); x, y and z as they are.
Expression made_again(const Flat::Entry& entry, std::span<const Expression> made);

/// Whether an opened Field occurs in it.
bool has_opened(const Expression& root);

/// An opened Field in an expression, and where it is asked.
struct PlacedLeaf {
  SourcePtr source;
  std::optional<Eigen::Affine3d> to_inner;  ///< from space to its coordinates; empty where that is no invertible affine map
};
/// All of them, in topological order.
std::vector<PlacedLeaf> leaves_of(const Expression& root);

/// Nodes of the graph, with x, y, z and constants where they occur.
std::size_t node_count(const Expression& root);

/// The expression with x, y and z replaced (the map operation of Appendix A). Shared parts are rewritten once.
Expression remap(const Expression& root, const Expression& x, const Expression& y, const Expression& z);

/// An expression with the same value wherever the original and every step of it is a finite number: constants folded (in double
/// precision), identities (a+0, a*1, --a, min(a,a), square(-a), a-a ...) removed. Folding may change the last bits and the sign
/// of a zero (which shows only where it is divided by); no constant becomes NaN or infinite by it.
Expression simplify(const Expression& root);

// The operators of arithmetic, simplified as they are made where both sides are constants or one is a neutral element.
Expression operator+(const Expression& a, const Expression& b);
Expression operator-(const Expression& a, const Expression& b);
Expression operator*(const Expression& a, const Expression& b);
Expression operator/(const Expression& a, const Expression& b);
Expression operator-(const Expression& a);
Expression min(const Expression& a, const Expression& b);
Expression max(const Expression& a, const Expression& b);
Expression pow(const Expression& a, const Expression& b);
Expression atan2(const Expression& y, const Expression& x);
Expression mod(const Expression& a, const Expression& b);
Expression compare(const Expression& a, const Expression& b);
Expression sin(const Expression& a);
Expression cos(const Expression& a);
Expression tan(const Expression& a);
Expression asin(const Expression& a);
Expression acos(const Expression& a);
Expression atan(const Expression& a);
Expression abs(const Expression& a);
Expression square(const Expression& a);
Expression sqrt(const Expression& a);
Expression exp(const Expression& a);
Expression ln(const Expression& a);
Expression floor(const Expression& a);
Expression ceil(const Expression& a);

}  // namespace fieldfab::frep
