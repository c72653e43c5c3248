/// The function library of the design language. .frep text calls these functions, Python's fieldfab.shapes offers the
/// same, and docs/shapes.md shows them.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fieldfab/frep/expression.h"

namespace fieldfab::frep {

/// Type of a function argument.
enum class Quantity {
  expression,  ///< a shape or a number; may depend on x, y and z
  angle,       ///< an angle, which may depend on x, y and z: degrees in .frep text, radians in Python and in `make`
  number,      ///< a constant number
  whole,       ///< a constant whole number
  text,        ///< a quoted text
};

/// A parameter of a library function.
struct Parameter {
  std::string_view name;
  Quantity quantity = Quantity::expression;
  /// default value, degrees for an angle; std::nullopt: the argument is required
  std::optional<double> fallback = std::nullopt;
};

/// Arguments in the order of the parameters, checked against their types. Further arguments have the type of the last
/// one.
struct Arguments {
  std::vector<Expression> values;  ///< one entry per argument; 0 for a text
  std::string text;

  const Expression& operator[](std::size_t i) const { return values[i]; }
  [[nodiscard]] double number(std::size_t i) const { return values[i].constant(); }
  [[nodiscard]] int whole(std::size_t i) const { return static_cast<int>(values[i].constant()); }
  /// Returns the constants from index `first` on.
  [[nodiscard]] std::vector<double> numbers(std::size_t first) const;
};

/// A function of the design language.
struct LibraryFunction {
  std::string_view name;
  std::string_view group;  ///< heading in docs/shapes.md
  std::vector<Parameter> parameters;
  std::string_view distance;  ///< distance property of a shape: "exact", "bound" or "neither"; "" for operations
  std::string_view meaning;   ///< description, one line
  std::string_view example;   ///< example in .frep text
  std::function<Expression(const Arguments&)> make;
  bool any_number = false;  ///< whether further arguments of the last type are accepted (union, outline)
};

/// Returns all functions, group by group.
const std::vector<LibraryFunction>& library();
/// Returns the function of that name, or null. The pointer stays valid until the process ends.
const LibraryFunction* find_function(std::string_view name);

/// Returns the call notation in .frep text, such as "rotate_z(shape, angle°)" or "sphere(r = 1)".
std::string signature(const LibraryFunction& function);
/// Returns the description and the distance property in one line.
std::string meaning(const LibraryFunction& function);

/// A named constant, available in each text.
struct Constant {
  std::string_view name;
  std::string_view meaning;
  Expression value;
};
const std::vector<Constant>& constants();
/// Returns the constant of that name, or null.
const Constant* find_constant(std::string_view name);

/// A value of the design language: a number, which may depend on x, y and z, or a solid (the result of shapes, sets and
/// open()). Arithmetic applies to numbers; `-` between two solids is the set difference. A number converts to a solid
/// where one is expected.
struct Value {
  Expression expression;
  bool solid = false;
};

/// Applies an operator + - * / ^ | &, exactly as written or folded as the operators of expression.h fold. Throws
/// Error(bad_input) for arithmetic with two solids.
enum class Making { as_written, folded };
Value joined(char sign, const Value& a, const Value& b, Making making = Making::as_written);

/// Calls a function with values. The result is a solid, except for functions of numbers; min, max and map keep the type
/// of their arguments. Throws as the other call().
Value call(const LibraryFunction& function, std::span<const std::optional<Value>> given, std::string_view text = {});

/// Calls a function with arguments in the order of its parameters (angles in radians, 0 for a text). Inserts defaults
/// for std::nullopt and checks constants. Throws Error(bad_input) for a missing or wrong argument.
Expression call(const LibraryFunction& function, const std::vector<std::optional<Expression>>& given,
                std::string_view text = {});

}  // namespace fieldfab::frep
