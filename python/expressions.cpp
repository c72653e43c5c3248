#include <pybind11/operators.h>

#include <fmt/format.h>
#include "bindings.h"

#include <numbers>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/library.h"
#include "fieldfab/frep/text.h"

namespace fieldfab::python {
namespace {

using frep::Expression;

/// Infix .frep text, or a prefix math string where it reads as one and not as infix.
Expression parse_any(const std::string& text) {
  try {
    return frep::parse_infix(text, "expression");
  } catch (const Error&) {
    try {
      return frep::parse_math(text, "expression");
    } catch (const Error&) {
    }
    throw;
  }
}

using Floats = py::array_t<float, py::array::c_style | py::array::forcecast>;

/// Values at points given by coordinates that broadcast against each other; a number where all three are.
py::object evaluate(const Expression& expression, const py::object& x, const py::object& y, const py::object& z) {
  const py::module_ numpy = py::module_::import("numpy");
  const py::sequence broadcast = numpy.attr("broadcast_arrays")(x, y, z);
  const Floats xs(broadcast[0]), ys(broadcast[1]), zs(broadcast[2]);  // laid out and rounded to float
  Floats out(std::vector<py::ssize_t>(xs.shape(), xs.shape() + xs.ndim()));
  float* to = out.mutable_data();
  const Points points{xs.data(), ys.data(), zs.data(), static_cast<std::size_t>(xs.size())};
  {
    py::gil_scoped_release release;
    frep::make_field(expression)->values(points, to);
  }
  if (out.ndim() == 0) return py::float_(*to);
  return out;
}

/// Numbers given one by one or in (nested) lists: outline([(0, 0), (1, 0), (0, 1)]).
void add_numbers(const py::handle& item, std::vector<std::optional<Expression>>& to) {
  if (py::isinstance<Expression>(item) || !py::isinstance<py::iterable>(item)) {
    to.push_back(item.cast<Expression>());
    return;
  }
  for (const py::handle inner : item) add_numbers(inner, to);
}

/// Python's arguments in the order of the function's parameters.
Expression call_library(const frep::LibraryFunction& function, const py::args& args, const py::kwargs& kwargs) {
  std::vector<std::optional<Expression>> given;
  std::string text;
  const auto takes_text = [&](std::size_t place) {
    return place < function.parameters.size() && function.parameters[place].quantity == frep::Quantity::text;
  };
  for (const py::handle item : args) {
    if (takes_text(given.size())) {
      text = item.cast<std::string>();
      given.emplace_back(Expression(0.0));
    } else if (function.any_number) {
      add_numbers(item, given);
    } else {
      given.emplace_back(item.cast<Expression>());
    }
  }
  if (!function.any_number && given.size() > function.parameters.size())
    throw py::type_error(fmt::format("{}() takes at most {} arguments", function.name, function.parameters.size()));
  for (const auto& [key, value] : kwargs) {
    const auto name = key.cast<std::string>();
    std::size_t place = 0;
    while (place < function.parameters.size() && function.parameters[place].name != name) ++place;
    if (place == function.parameters.size()) throw py::type_error(fmt::format("{}() has no argument '{}'", function.name, name));
    if (given.size() <= place) given.resize(place + 1);
    if (given[place]) throw py::type_error(fmt::format("{}() got '{}' twice", function.name, name));
    if (takes_text(place)) text = value.cast<std::string>();
    given[place] = takes_text(place) ? Expression(0.0) : value.cast<Expression>();
  }
  return frep::call(function, given, text);
}

/// "name(a, b=1): what it is; exact."
std::string documentation(const frep::LibraryFunction& function) {
  std::string parameters;
  for (const frep::Parameter& parameter : function.parameters) {
    parameters += fmt::format("{}{}", parameters.empty() ? "" : ", ", parameter.name);
    const double unit = parameter.quantity == frep::Quantity::angle ? std::numbers::pi / 180 : 1;
    if (parameter.fallback) parameters += fmt::format("={:.4g}", *parameter.fallback * unit);
  }
  if (function.any_number) parameters += ", ...";
  const char* const value = function.distance == "exact"   ? "its value is the exact distance"
                            : function.distance == "bound" ? "its value is a bound of the distance"
                                                           : "its value is neither the distance nor a bound of it";
  return fmt::format("{}({})\n\n{}{}{}", function.name, parameters, function.meaning,
                     function.meaning.empty() || function.distance.empty() ? "" : "; ", function.distance.empty() ? "" : value);
}

py::list describe_library() {
  py::list all;
  for (const frep::LibraryFunction& function : frep::library()) {
    py::list parameters;
    for (const frep::Parameter& parameter : function.parameters) {
      constexpr const char* kinds[] = {"expression", "angle", "number", "whole", "text"};
      py::dict about;
      about["name"] = std::string(parameter.name);
      about["kind"] = kinds[static_cast<int>(parameter.quantity)];
      about["default"] = parameter.fallback ? py::object(py::float_(*parameter.fallback)) : py::none();
      parameters.append(about);
    }
    py::dict about;
    about["name"] = std::string(function.name);
    about["group"] = std::string(function.group);
    about["parameters"] = parameters;
    about["any_number"] = function.any_number;
    about["distance"] = std::string(function.distance);
    about["meaning"] = std::string(function.meaning);
    about["example"] = std::string(function.example);
    all.append(about);
  }
  return all;
}

void bind_library(py::module_ shapes) {
  py::options options;
  options.disable_function_signatures();
  for (const frep::LibraryFunction& function : frep::library())
    if (function.group != "numbers")
      shapes.def(
          std::string(function.name).c_str(),
          [&function](const py::args& args, const py::kwargs& kwargs) { return call_library(function, args, kwargs); },
          documentation(function).c_str());
}

/// Without the newline that ends a file.
std::string text_of(const Expression& expression) {
  std::string text = frep::print_infix(expression);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

}  // namespace

void bind_expressions(py::module_& module) {
  py::class_<Expression> expression(module, "Expression", "A formula over x, y and z. Equal formulas are one object inside.");
  expression.def(py::init<double>(), py::arg("value"))
      .def(py::init<const Expression&>(), py::arg("value"))
      .def(py::self + py::self)
      .def(py::self - py::self)
      .def(py::self * py::self)
      .def(py::self / py::self)
      .def(-py::self)
      .def(
          "__radd__", [](const Expression& a, double b) { return Expression(b) + a; }, py::is_operator())
      .def(
          "__rsub__", [](const Expression& a, double b) { return Expression(b) - a; }, py::is_operator())
      .def(
          "__rmul__", [](const Expression& a, double b) { return Expression(b) * a; }, py::is_operator())
      .def(
          "__rtruediv__", [](const Expression& a, double b) { return Expression(b) / a; }, py::is_operator())
      .def(
          "__pow__", [](const Expression& a, const Expression& b) { return frep::pow(a, b); }, py::is_operator())
      .def(
          "__rpow__", [](const Expression& a, double b) { return frep::pow(Expression(b), a); }, py::is_operator())
      .def(
          "__mod__", [](const Expression& a, const Expression& b) { return frep::mod(a, b); }, py::is_operator())
      .def("__abs__", [](const Expression& a) { return frep::abs(a); })
      .def(
          "__or__", [](const Expression& a, const Expression& b) { return frep::min(a, b); }, py::is_operator(), "union")
      .def(
          "__and__", [](const Expression& a, const Expression& b) { return frep::max(a, b); }, py::is_operator(), "intersection")
      .def(
          "__invert__", [](const Expression& a) { return -a; }, "complement")
      .def(
          "__eq__", [](const Expression& a, const Expression& b) { return a == b; }, py::is_operator(),
          "Whether both are the same formula, node for node.")
      .def("__hash__", [](const Expression& a) { return std::hash<const void*>{}(a.id()); })
      .def("__str__", text_of)
      .def("__repr__",
           [](const Expression& a) { return "<fieldfab.Expression of " + std::to_string(frep::node_count(a)) + " nodes>"; })
      .def(
          "math", [](const Expression& a) { return frep::print_math(a); }, "The formula as a prefix math string.")
      .def(
          "vm", [](const Expression& a) { return frep::print_vm(a); }, "The formula as a .vm program.")
      .def(
          "save_dot", [](const Expression& a, const std::filesystem::path& path) { write_file(path, frep::print_dot(a)); },
          py::arg("filename"), "Writes the formula as a graph for Graphviz.")
      .def("simplified", [](const Expression& a) { return frep::simplify(a); })
      .def("node_count", [](const Expression& a) { return frep::node_count(a); })
      .def(
          "map",
          [](const Expression& a, std::optional<Expression> x, std::optional<Expression> y, std::optional<Expression> z) {
            return frep::remap(a, x.value_or(Expression::x()), y.value_or(Expression::y()), z.value_or(Expression::z()));
          },
          py::arg("x") = py::none(), py::arg("y") = py::none(), py::arg("z") = py::none(),
          "The formula with x, y and z replaced; None leaves a coordinate as it is.")
      .def("__call__", evaluate, py::arg("x"), py::arg("y"), py::arg("z"),
           "Values at points, in single precision; arrays broadcast as NumPy's do.");
  py::implicitly_convertible<double, Expression>();
  py::implicitly_convertible<int, Expression>();

  module.attr("X") = Expression::x();
  module.attr("Y") = Expression::y();
  module.attr("Z") = Expression::z();
  module.def("parse", parse_any, py::arg("text"), "Reads .frep text or a prefix math string.");
  module.def(
      "parse_math", [](const std::string& text) { return frep::parse_math(text); }, py::arg("text"));
  module.def(
      "parse_vm", [](const std::string& text) { return frep::parse_vm(text); }, py::arg("text"));
  module.def(
      "parse_infix", [](const std::string& text) { return frep::parse_infix(text); }, py::arg("text"));

  module.def(
      "set_evaluator", [](const std::string& name) { frep::set_default_evaluator(frep::evaluator_named(name)); }, py::arg("name"),
      "How formulas are evaluated from now on: automatic, reference, portable, avx2, avx512, jit, jit-avx2 or jit-avx512.");

  using Unary = Expression (*)(const Expression&);
  for (const auto& [name, function] : std::initializer_list<std::pair<const char*, Unary>>{{"sin", frep::sin},
                                                                                           {"cos", frep::cos},
                                                                                           {"tan", frep::tan},
                                                                                           {"asin", frep::asin},
                                                                                           {"acos", frep::acos},
                                                                                           {"atan", frep::atan},
                                                                                           {"sqrt", frep::sqrt},
                                                                                           {"square", frep::square},
                                                                                           {"exp", frep::exp},
                                                                                           {"ln", frep::ln},
                                                                                           {"floor", frep::floor},
                                                                                           {"ceil", frep::ceil}})
    module.def(name, function, py::arg("value"));
  using Binary = Expression (*)(const Expression&, const Expression&);
  for (const auto& [name, function] : std::initializer_list<std::pair<const char*, Binary>>{
           {"minimum", frep::min}, {"maximum", frep::max}, {"atan2", frep::atan2}, {"compare", frep::compare}})
    module.def(name, function, py::arg("a"), py::arg("b"));

  module.def("library", describe_library, "The functions of the design language, with their parameters, meanings and examples.");
  bind_library(module.def_submodule(
      "shapes", "Shapes and what is done with them, as expressions. Lengths in mm, angles in radians. See docs/shapes.md."));
}

}  // namespace fieldfab::python
