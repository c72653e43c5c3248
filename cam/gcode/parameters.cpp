#include "parameters.h"

#include <cmath>

#include "refusal.h"

namespace fieldfab::cam::gcode {
namespace {

// limits the memory that a program's own names take, far above the number in any real program
constexpr std::size_t most_names = 100'000;

bool computed(int parameter) { return parameter >= number::tool && parameter <= 5428; }

void check_number(int parameter) {
  if (parameter < 1 || parameter >= number::count)
    refuse("there is no parameter #{}: they go from #1 to #{}", parameter, number::count - 1);
}

}  // namespace

double Parameters::get(int parameter) const {
  check_number(parameter);
  return computed(parameter) ? predefined_.numbered(parameter) : stored(parameter);
}

void Parameters::set(int parameter, double value) {
  check_number(parameter);
  if (computed(parameter)) refuse("parameter #{} cannot be set: it follows from the machine's state", parameter);
  if (!std::isfinite(value)) refuse("parameter #{} would be no finite number", parameter);
  stored(parameter) = value;
}

std::optional<double> Parameters::find(std::string_view name) const {
  if (name.starts_with('_')) {
    if (const auto found = predefined_.named(name)) return found;
    const auto found = globals_.find(name);
    return found == globals_.end() ? std::nullopt : std::optional(found->second);
  }
  const auto found = locals_.find(name);
  return found == locals_.end() ? std::nullopt : std::optional(found->second);
}

double Parameters::get(std::string_view name) const {
  const auto found = find(name);
  if (!found) refuse("#<{}> has no value yet", shown(name));
  return *found;
}

void Parameters::set(std::string_view name, double value) {
  if (name.empty()) refuse("a parameter between < and > needs a name");
  if (!std::isfinite(value)) refuse("#<{}> would be no finite number", shown(name));
  const bool global = name.starts_with('_');
  if (global && predefined_.named(name))
    refuse("#<{}> cannot be set: it follows from the machine's state", shown(name));
  Names& names = global ? globals_ : locals_;
  const auto found = names.find(name);
  if (found != names.end()) {
    found->second = value;
    return;
  }
  if (names.size() >= most_names) refuse("more than {} parameters with names", most_names);
  names.emplace(std::string(name), value);
}

void Parameters::enter(const std::vector<double>& arguments, bool numbered) {
  Frame frame;
  std::copy_n(numbered_.begin(), frame.numbered.size(), frame.numbered.begin());
  frame.names = std::move(locals_);
  locals_.clear();
  frames_.push_back(std::move(frame));
  if (!numbered) return;
  for (std::size_t i = 0; i < 30; ++i) numbered_[i + 1] = i < arguments.size() ? arguments[i] : 0;
}

void Parameters::leave(bool numbered) {
  Frame& frame = frames_.back();
  if (numbered) std::copy(frame.numbered.begin(), frame.numbered.end(), numbered_.begin());
  locals_ = std::move(frame.names);
  frames_.pop_back();
}

}  // namespace fieldfab::cam::gcode
