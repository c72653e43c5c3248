/// Expressions: immutable graphs of operations, in which equal subexpressions are one node (hash-consing; Keeter 3.4,
/// 3.5).
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

/// A solid that is not a formula (a scan, a mesh, a design), for use in formulas: its Field and its notation in text.
struct Source : std::enable_shared_from_this<Source> {
  FieldPtr field;
  std::filesystem::path path;  ///< absolute path; empty for a solid made in memory, which no text can name
  std::string options;         ///< arguments of open() in .frep text, such as "threshold = 300, smooth = 1"
  virtual ~Source() = default;
};
using SourcePtr = std::shared_ptr<const Source>;

/// A handle of a node in an expression graph, with shared ownership by reference count. Expressions of equal structure
/// are the same node, so that == takes constant time. Expressions may be made, copied and destroyed by several threads
/// at the same time. No operation here recurses, so that the depth is not limited by the stack.
class Expression {
 public:
  /// A constant. Throws Error(bad_input) if `value` is NaN or infinite. -0 becomes 0.
  Expression(double value);  // NOLINT(google-explicit-constructor): numbers are expressions
  Expression(const Expression& other) noexcept;
  Expression(Expression&& other) noexcept;
  Expression& operator=(Expression other) noexcept;
  ~Expression();

  static Expression x();
  static Expression y();
  static Expression z();
  /// Returns the node op(a) or op(a, b), shared if it exists, without constant folding or simplification.
  static Expression make(Opcode op, const Expression& a);
  static Expression make(Opcode op, const Expression& a, const Expression& b);
  /// Returns the node for the value of an opened Field at (x, y, z).
  static Expression opened(const SourcePtr& source, const Expression& x, const Expression& y, const Expression& z);

  [[nodiscard]] Opcode opcode() const noexcept;
  /// The value of a constant node; 0 for any other node.
  [[nodiscard]] double constant() const noexcept;
  /// Returns argument `index`, which must be less than arity().
  [[nodiscard]] Expression argument(int index) const;
  [[nodiscard]] int arity() const noexcept { return info(opcode()).arity; }
  /// The source of an `opened` node; null for any other node.
  [[nodiscard]] SourcePtr source() const;

  /// Whether both are the same node. Constant time.
  bool operator==(const Expression& other) const noexcept { return node_ == other.node_; }
  /// Address of the node, for hashing. Equal expressions have equal addresses while one of them exists.
  [[nodiscard]] const Node* id() const noexcept { return node_; }

 private:
  explicit Expression(const Node* node) noexcept : node_(node) {}
  const Node* node_;
};

/// The nodes in topological order: each node once, after its arguments. `order.back()` is the root. The order depends
/// only on the expression.
struct Flat {
  struct Entry {
    Opcode op;
    double constant;     ///< value if op is `constant`
    std::uint32_t a, b;  ///< indices of the arguments in `order`; 0 if absent
    std::uint32_t c = 0;
    const Source* source = nullptr;  ///< source if op is `opened`; not owned, valid as long as the expression
  };
  std::vector<Entry> order;
};
/// Returns the nodes of an expression in topological order. Linear in their number.
Flat flatten(const Expression& root);

/// Returns the node of an entry over new arguments: `made` holds the results of the entries before it. x, y and z are
/// returned unchanged.
Expression made_again(const Flat::Entry& entry, std::span<const Expression> made);

/// Whether an opened Field occurs in the expression. Linear in the number of nodes.
bool has_opened(const Expression& root);

/// An occurrence of an opened Field in an expression, with its coordinates.
struct PlacedLeaf {
  SourcePtr source;
  /// map from model space to the Field's coordinates; std::nullopt if it is not affine or not invertible
  std::optional<Eigen::Affine3d> to_inner;
};
/// Returns all occurrences of opened Fields, in topological order.
std::vector<PlacedLeaf> leaves_of(const Expression& root);

/// Returns the number of distinct nodes, including x, y, z and constants.
std::size_t node_count(const Expression& root);

/// Substitutes expressions for x, y and z (the map operation of Appendix A). Each shared node is rewritten once.
Expression remap(const Expression& root, const Expression& x, const Expression& y, const Expression& z);

/// Simplifies an expression. The result has the same value at each point where the original and all its subexpressions
/// are finite. Folds constants in double precision and removes identities (a+0, a*1, --a, min(a,a), square(-a), a-a and
/// others). Folding may change the last bits of a value and the sign of a zero. It never makes a constant NaN or
/// infinite.
Expression simplify(const Expression& root);

// Arithmetic operators and functions. They fold two constants and remove neutral elements; see simplify().
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
