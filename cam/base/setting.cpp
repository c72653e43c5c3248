#include "fieldfab/cam/base/setting.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "fieldfab/core/error.h"

namespace fieldfab::cam {
namespace {

const Given& find(const Values& values, const std::string& name) {
  const auto it = values.given.find(name);
  if (it == values.given.end())
    throw Error(ErrorKind::internal, "setting", fmt::format("'{}' was never declared", name));
  return it->second;
}

template <class T>
const T& get(const Values& values, const std::string& name) {
  const T* const value = std::get_if<T>(&find(values, name).value);
  if (value == nullptr) throw Error(ErrorKind::internal, "setting", fmt::format("'{}' has another type", name));
  return *value;
}

/// Levenshtein distance.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

const char* type_name(const Value& value) {
  constexpr const char* names[] = {"true or false", "a number", "a text", "a list of numbers"};
  return names[value.index()];
}

}  // namespace

double Values::number(const std::string& name) const { return get<double>(*this, name); }
bool Values::flag(const std::string& name) const { return get<bool>(*this, name); }
const std::string& Values::text(const std::string& name) const { return get<std::string>(*this, name); }
const std::vector<double>& Values::list(const std::string& name) const { return get<std::vector<double>>(*this, name); }
const std::string& Values::place(const std::string& name) const { return find(*this, name).place; }

Value checked(const Setting& setting, const Value& value, const std::string& place) {
  const auto refuse = [&](const std::string& what) {
    throw Error(ErrorKind::bad_input, place, fmt::format("{} {}", setting.name, what));
  };
  if (value.index() != setting.standard.index())
    refuse(fmt::format("must be {}, not {}", type_name(setting.standard), type_name(value)));
  const auto check_number = [&](double d) {
    const bool low = setting.lower_open ? !(d > setting.lower) : !(d >= setting.lower);
    if (!std::isfinite(d)) refuse("must be finite");
    if (setting.whole && d != std::round(d)) refuse(fmt::format("is {:.6g}; it must be a whole number", d));
    if (low)
      refuse(fmt::format("is {:.6g}; it must be {} {:.6g}{}", d, setting.lower_open ? "above" : "at least",
                         setting.lower, setting.unit.empty() ? "" : " " + setting.unit));
    if (!(d <= setting.upper))
      refuse(fmt::format("is {:.6g}; it must be at most {:.6g}{}", d, setting.upper,
                         setting.unit.empty() ? "" : " " + setting.unit));
  };
  if (const double* number = std::get_if<double>(&value)) check_number(*number);
  if (const auto* list = std::get_if<std::vector<double>>(&value))
    for (const double d : *list) check_number(d);
  if (const auto* text = std::get_if<std::string>(&value);
      text != nullptr && !setting.choices.empty() &&
      std::find(setting.choices.begin(), setting.choices.end(), *text) == setting.choices.end())
    refuse(fmt::format("is '{}'; it must be one of {}{}", *text, fmt::join(setting.choices, ", "),
                       suggestion(*text, setting.choices)));
  return value;
}

std::string suggestion(const std::string& wrong, const std::vector<std::string>& known) {
  const std::string* best = nullptr;
  std::size_t least = std::max<std::size_t>(2, wrong.size() / 3) + 1;
  for (const std::string& name : known)
    if (const std::size_t d = distance(wrong, name); d < least) least = d, best = &name;
  return best == nullptr ? "" : fmt::format("; did you mean '{}'?", *best);
}

}  // namespace fieldfab::cam
