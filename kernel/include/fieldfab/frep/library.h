/// The functions of the design language: .frep text calls them, Python's fieldfab.shapes has the same, docs/shapes.md shows them.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fieldfab/frep/expression.h"

namespace fieldfab::frep {

/// What a number of a library function is.
enum class Quantity {
  expression,  ///< a shape, or any number that may depend on x, y and z
  angle,       ///< the same, an angle: degrees in .frep text, radians in Python and in `make`
  number,      ///< a plain number
  whole,       ///< a plain whole number
  text,        ///< words in quotes
};

struct Parameter {
  std::string_view name;
  Quantity quantity = Quantity::expression;
  std::optional<double> fallback = std::nullopt;  ///< in degrees for an angle
};

/// Arguments in the order of the parameters, checked against their quantities; those beyond are like the last one.
struct Arguments {
  std::vector<Expression> values;  ///< 0 in place of words
  std::string text;

  const Expression& operator[](std::size_t i) const { return values[i]; }
  [[nodiscard]] double number(std::size_t i) const { return values[i].constant(); }
  [[nodiscard]] int whole(std::size_t i) const { return static_cast<int>(values[i].constant()); }
  /// The numbers from `first` on.
  [[nodiscard]] std::vector<double> numbers(std::size_t first) const;
};

struct LibraryFunction {
  std::string_view name;
  std::string_view group;  ///< a heading of docs/shapes.md
  std::vector<Parameter> parameters;
  std::string_view distance;  ///< "exact", "bound" or "neither" for shapes; "" for what is done with them
  std::string_view meaning;   ///< one line
  std::string_view example;   ///< .frep text of something to look at
  std::function<Expression(const Arguments&)> make;
  bool any_number = false;  ///< takes further arguments like the last one (union, outline ...)
};

/// All functions, group by group.
const std::vector<LibraryFunction>& library();
/// The function of that name, or null.
const LibraryFunction* find_function(std::string_view name);

/// "rotate_z(shape, angle°)", "sphere(r = 1)": how a function is called in .frep text.
std::string signature(const LibraryFunction& function);
/// What it makes, and what its value is good for, in one line.
std::string meaning(const LibraryFunction& function);

/// A name that has a value in every text.
struct Constant {
  std::string_view name;
  std::string_view meaning;
  Expression value;
};
const std::vector<Constant>& constants();
/// The constant of that name, or null.
const Constant* find_constant(std::string_view name);

/// A value of the design language: a number that may depend on x, y and z, or a solid, which is what shapes, sets and open()
/// give. Numbers have arithmetic; `-` of two solids is their set difference. A number is a solid where one is needed.
struct Value {
  Expression expression;
  bool solid = false;
};

/// `a SIGN b` for the signs + - * / ^ | &, exactly as it is written, or folded as the operators of expression.h do. Throws
/// bad_input for arithmetic with two solids.
enum class Making { as_written, folded };
Value joined(char sign, const Value& a, const Value& b, Making making = Making::as_written);

/// Calls a function with values: what it gives is a solid, but for functions of numbers; min, max and map keep what they are
/// given. Throws as call() does.
Value call(const LibraryFunction& function, std::span<const std::optional<Value>> given, std::string_view text = {});

/// Calls a function with what is given, in the order of its parameters (angles in radians, 0 in place of words): fills in what is
/// missing and checks what must be a plain number. Throws bad_input with what is wrong.
Expression call(const LibraryFunction& function, const std::vector<std::optional<Expression>>& given, std::string_view text = {});

}  // namespace fieldfab::frep
