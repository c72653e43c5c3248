/// Settings that jobs, machines, materials and tools give: declared once with type, unit, default and limits, checked, and looked
/// up by name.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace fieldfab::cam {

/// A value of a setting.
using Value = std::variant<bool, double, std::string, std::vector<double>>;

/// A setting: its meaning and what it may be.
struct Setting {
  std::string name, help, unit;
  Value standard;  ///< the default, whose type is the setting's
  double lower = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
  bool lower_open = false;           ///< must be above `lower`, not equal
  bool required = false;             ///< has no default
  bool whole = false;                ///< a whole number
  std::vector<std::string> choices;  ///< where not empty, the texts allowed
  /// The setting beside it without which this one means nothing, and the values which that one must then have; none: any but 0
  /// and false.
  std::string needs;
  std::vector<std::string> needs_values;
};
using Settings = std::vector<Setting>;

/// What a number is where nobody says: it then follows from other things.
constexpr double unset = -987654321.0;

/// Where a value comes from, for --plan.
struct Given {
  Value value;
  std::string from;   ///< "job", "tool", "material wax", "machine", "default"
  std::string place;  ///< FILE:LINE where known
};

/// Values by name. Getters throw internal for a name that was never declared.
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
inline bool is_set(const Values& values, const std::string& name) { return values.number(name) != unset; }

/// Checks a value against its setting and returns it with the setting's type (a whole number is a number). Throws bad_input at
/// `place`.
Value checked(const Setting& setting, const Value& value, const std::string& place);

/// The names nearest to a mistyped one, as ", did you mean 'x'?", or nothing.
std::string suggestion(const std::string& wrong, const std::vector<std::string>& known);

}  // namespace fieldfab::cam
