/// Declared settings of jobs, machines, materials and tools: type, unit, default and limits, with validation and lookup
/// by name.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace fieldfab::cam {

/// Value of a setting.
using Value = std::variant<bool, double, std::string, std::vector<double>>;

/// Declaration of a setting.
struct Setting {
  std::string name, help, unit;
  Value standard;  ///< the default; its type is the type of the setting
  double lower = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
  bool lower_open = false;           ///< whether the value must exceed `lower` strictly
  bool required = false;             ///< whether a value is required: there is no default
  bool whole = false;                ///< whether the value must be a whole number
  std::vector<std::string> choices;  ///< permitted texts; empty: any
  /// Name of another setting that enables this one, and the values of it that do so; no values: any except 0 and false.
  /// Empty: always enabled.
  std::string needs;
  std::vector<std::string> needs_values;
};
using Settings = std::vector<Setting>;

/// Marker of an absent number, whose value is then derived from other settings.
constexpr double unset = -987654321.0;

/// A value with its origin, for --plan.
struct Given {
  Value value;
  std::string from;   ///< origin: "job", "tool", "material wax", "machine" or "default"
  std::string place;  ///< FILE:LINE if known, otherwise empty
};

/// Values by name. Getters throw Error(internal) for an undeclared name or a value of another type.
class Values {
 public:
  std::map<std::string, Given> given;
  [[nodiscard]] double number(const std::string& name) const;
  [[nodiscard]] bool flag(const std::string& name) const;
  [[nodiscard]] const std::string& text(const std::string& name) const;
  [[nodiscard]] const std::vector<double>& list(const std::string& name) const;
  [[nodiscard]] bool has(const std::string& name) const { return given.contains(name); }
  [[nodiscard]] const std::string& place(const std::string& name) const;
};
/// Whether a number was given, that is, differs from `unset`.
inline bool is_set(const Values& values, const std::string& name) { return values.number(name) != unset; }

/// Validates a value against its declaration and returns it in the declared type (whole numbers are doubles). Throws
/// Error(bad_input) at `place`.
Value checked(const Setting& setting, const Value& value, const std::string& place);

/// Returns "; did you mean 'x'?" with the known name of least edit distance from a misspelled one, or an empty string
/// if none is similar.
std::string suggestion(const std::string& wrong, const std::vector<std::string>& known);

}  // namespace fieldfab::cam
