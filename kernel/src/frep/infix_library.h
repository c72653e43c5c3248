/// The functions that .frep text may call: their names, parameters and defaults.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fieldfab/frep/expression.h"

namespace fieldfab::frep {

/// A built-in function of the language.
struct Function {
  struct Parameter {
    std::string_view name;
    std::optional<double> fallback;
  };
  std::string_view name;
  std::vector<Parameter> parameters;
  std::function<Expression(std::span<const Expression>)> make;
  bool any_number = false;  ///< takes further arguments like the last one (min, max, union ...)
};

/// The function of that name, or null.
const Function* find_function(std::string_view name);
/// Every name, for suggestions.
const std::vector<Function>& all_functions();

}  // namespace fieldfab::frep
