// Python bindings of the design language: library functions, texts, files.
#include <fmt/format.h>

#include "bindings.h"
#include "fieldfab/core/angle.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/text.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/text.h"
#include "fieldfab/openscad/design.h"

namespace fieldfab::python {
namespace {

using frep::Expression;
using frep::Value;

OpenSettings settings_for(Scripts scripts, bool opens_others) {
  OpenSettings settings;
  settings.scripts = scripts;
  settings.opens_others = opens_others;
  settings.formats = &openscad::all_formats();
  return settings;
}

/// A part of a model as Python's Solid, with its metadata.
SolidValue as_value(Solid solid) { return SolidValue(std::move(solid)); }

/// Appends numbers that are single or in (nested) lists: outline([(0, 0), (1, 0), (0, 1)]).
void add_numbers(const py::handle& item, std::vector<std::optional<Value>>& to) {
  if (py::isinstance<SolidValue>(item) || !py::isinstance<py::iterable>(item)) {
    to.emplace_back(item.cast<SolidValue>().value);
    return;
  }
  for (const py::handle inner : item) add_numbers(inner, to);
}

/// Python's arguments in the order of the function's parameters.
SolidValue call_library(const frep::LibraryFunction& function, const py::args& args, const py::kwargs& kwargs) {
  std::vector<std::optional<Value>> given;
  std::string text;
  const auto takes_text = [&](std::size_t place) {
    return place < function.parameters.size() && function.parameters[place].quantity == frep::Quantity::text;
  };
  for (const py::handle item : args) {
    if (takes_text(given.size())) {
      text = item.cast<std::string>();
      given.emplace_back(Value{0.0});
    } else if (function.any_number) {
      add_numbers(item, given);
    } else {
      given.emplace_back(item.cast<SolidValue>().value);
    }
  }
  if (!function.any_number && given.size() > function.parameters.size())
    throw py::type_error(fmt::format("{}() takes at most {} arguments", function.name, function.parameters.size()));
  for (const auto& [key, value] : kwargs) {
    const auto name = key.cast<std::string>();
    std::size_t place = 0;
    while (place < function.parameters.size() && function.parameters[place].name != name) ++place;
    if (place == function.parameters.size())
      throw py::type_error(fmt::format("{}() has no argument '{}'", function.name, name));
    if (given.size() <= place) given.resize(place + 1);
    if (given[place]) throw py::type_error(fmt::format("{}() got '{}' twice", function.name, name));
    if (takes_text(place)) text = value.cast<std::string>();
    given[place] = takes_text(place) ? Value{0.0} : value.cast<SolidValue>().value;
  }
  return frep::call(function, given, text);
}

/// "name(a, b=1): description; exact."
std::string documentation(const frep::LibraryFunction& function) {
  std::string parameters;
  for (const frep::Parameter& parameter : function.parameters) {
    parameters += fmt::format("{}{}", parameters.empty() ? "" : ", ", parameter.name);
    const double unit = parameter.quantity == frep::Quantity::angle ? radians_per_degree : 1;
    if (parameter.fallback) parameters += fmt::format("={:.4g}", *parameter.fallback * unit);
  }
  if (function.any_number) parameters += ", ...";
  const char* const value = function.distance == "exact"   ? "its value is the exact distance"
                            : function.distance == "bound" ? "its value is a bound of the distance"
                                                           : "its value is neither the distance nor a bound of it";
  return fmt::format("{}({})\n\n{}{}{}", function.name, parameters, function.meaning,
                     function.meaning.empty() || function.distance.empty() ? "" : "; ",
                     function.distance.empty() ? "" : value);
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
    about["signature"] = frep::signature(function);
    about["help"] = frep::meaning(function);
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

/// Options of open() from Python's keywords: booleans become numbers, sequences become numbers
/// separated by commas.
std::vector<frep::OpenOption> options_of(const py::kwargs& keywords) {
  std::vector<frep::OpenOption> options;
  for (const auto& [key, given] : keywords) {
    const auto name = key.cast<std::string>();
    if (py::isinstance<py::str>(given)) {
      options.push_back({name, given.cast<std::string>()});
    } else if (py::isinstance<py::sequence>(given)) {
      std::string text;
      for (const py::handle item : given) text += (text.empty() ? "" : ",") + py::str(item).cast<std::string>();
      options.push_back({name, text});
    } else {
      options.push_back({name, given.cast<double>()});
    }
  }
  return options;
}

/// Opens a file as open() of .frep text does: all parts as one solid, or the named part.
SolidValue open_file(const std::filesystem::path& path, const py::kwargs& keywords) {
  const std::vector<frep::OpenOption> options = options_of(keywords);
  const OpenSettings settings = settings_for(Scripts::refused, true);
  return as_value(long_work(py::none(), [&](Progress& p) { return open_solid(path, options, settings, p); }));
}

/// The parts that part() has made in this process.
std::vector<frep::TextPart>& parts_made() {
  static auto* parts = new std::vector<frep::TextPart>;
  return *parts;
}

SolidValue make_part(const SolidValue& shape, const std::string& name, const py::object& colour) {
  if (name.empty()) throw py::value_error("a part needs a name");
  for (const frep::TextPart& part : parts_made())
    if (part.name == name) throw Error(ErrorKind::bad_input, "", fmt::format("two parts are called '{:.60}'", name));
  parts_made().push_back({shape.value.expression, name, colour_of(colour), {}});
  return Value{shape.value.expression, true};
}

py::list parts_to_python() {
  py::list parts;
  for (const frep::TextPart& part : parts_made())
    parts.append(py::make_tuple(SolidValue(Value{part.shape, true}), part.name,
                                part.colour ? py::object(py::str(text_of(*part.colour))) : py::none()));
  return parts;
}

/// A model in Python: [(solid, name or None, colour or None), ...].
py::list parts_of(Model model) {
  py::list parts;
  for (Solid& part : model.parts) {
    py::object name = part.name.empty() ? py::object(py::none()) : py::object(py::str(printable(part.name)));
    py::object colour = part.colour ? py::object(py::str(text_of(*part.colour))) : py::object(py::none());
    parts.append(py::make_tuple(as_value(std::move(part)), name, colour));
  }
  return parts;
}

/// Infix .frep text; if that fails, a prefix math string. If both fail, the error of the infix text
/// is thrown.
SolidValue parse_any(const std::string& text, const std::optional<std::filesystem::path>& folder) {
  const OpenSettings settings = settings_for(Scripts::refused, folder.has_value());
  try {
    return as_value(united(parse_model(text, "expression", folder.value_or(""), settings)));
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_input) throw;
    try {
      return Value{frep::parse_math(text, "expression"), true};
    } catch (const Error&) {
    }
    throw;
  }
}

template <class Function>
void define_number(py::module_& module, const char* name, Function function) {
  module.def(
      name, [function](const SolidValue& value) { return SolidValue(Value{function(value.value.expression)}); },
      py::arg("value"));
}

/// Content of a file, with its reader's metadata.
struct OpenedModel {
  Model model;
  std::vector<std::filesystem::path> files;
};

OpenedModel open_all(const std::filesystem::path& path, Progress& progress) {
  OpenedModel opened;
  OpenSettings settings = settings_for(Scripts::refused, true);
  settings.files_read = &opened.files;
  opened.model = open_model(path, settings, progress);
  return opened;
}

py::list describe_formats() {
  py::list all;
  for (const Format& format : openscad::all_formats().rows()) {
    py::dict about;
    about["extensions"] = format.extensions;
    about["kind"] = std::string(name_of(format.kind));
    about["reads"] = format.read != nullptr;
    about["writes"] = format.written.has_value();
    about["parts"] = format.parts;
    about["help"] = format.help;
    all.append(about);
  }
  return all;
}

}  // namespace

std::optional<Colour> colour_of(const py::object& given) {
  if (given.is_none()) return std::nullopt;
  if (py::isinstance<py::str>(given)) return colour_named(given.cast<std::string>());
  const auto numbers = given.cast<std::array<double, 3>>();
  Colour colour;
  for (const auto& [number, to] :
       {std::pair(numbers[0], &colour.red), {numbers[1], &colour.green}, {numbers[2], &colour.blue}}) {
    if (!(number >= 0 && number <= 255)) throw py::value_error("the numbers of a colour are 0 to 255");
    *to = static_cast<std::uint8_t>(number + 0.5);
  }
  return colour;
}

std::vector<PythonPart> parts_given(const py::iterable& parts) {
  std::vector<PythonPart> all;
  for (const py::handle part : parts) {
    auto [what, name, colour] = part.cast<std::tuple<py::object, std::optional<std::string>, py::object>>();
    all.push_back({std::move(what), name.value_or(""), colour_of(colour)});
  }
  return all;
}

void bind_language(py::module_& module) {
  module.attr("X") = SolidValue(Value{Expression::x()});
  module.attr("Y") = SolidValue(Value{Expression::y()});
  module.attr("Z") = SolidValue(Value{Expression::z()});
  module.def("parse", parse_any, py::arg("text"), py::arg("folder") = py::none(),
             "Reads .frep text or a prefix math string; several parts as one solid. open() in it takes names relative "
             "to `folder`, "
             "and is refused without one.");
  module.def(
      "parse_parts",
      [](const std::string& text, const std::optional<std::filesystem::path>& folder) {
        return parts_of(
            parse_model(text, "text", folder.value_or(""), settings_for(Scripts::refused, folder.has_value())));
      },
      py::arg("text"), py::arg("folder") = py::none(),
      "The parts of .frep text: (solid, name, colour) each; one without a name and a colour where it names none.");
  module.def(
      "parse_math",
      [](const std::string& text) {
        return SolidValue(Value{frep::parse_math(text), true});
      },
      py::arg("text"));
  module.def(
      "parse_vm",
      [](const std::string& text) {
        return SolidValue(Value{frep::parse_vm(text), true});
      },
      py::arg("text"));
  module.def(
      "parse_infix",
      [](const std::string& text) {
        return SolidValue(Value{frep::parse_infix(text), true});
      },
      py::arg("text"));
  module.def(
      "open", open_file, py::arg("filename"),
      "The solid of a file of any kind, to be used like any shape. Options by name: threshold = 300, part = \"lid\", "
      "smooth = True ... (docs/frep-language.md). Scripts are refused.");
  module.def("part", make_part, py::arg("shape"), py::arg("name"), py::arg("colour") = py::none(),
             "Makes a solid one of the named parts of the script's model; the colour is a CSS name, \"#rrggbb\" or "
             "three numbers "
             "from 0 to 255. Returns the solid.");
  module.def("parts_made", parts_to_python, "The parts that part() has made so far: (solid, name, colour) each.");
  module.def(
      "load",
      [](const std::filesystem::path& path) {
        return as_value(united(open_model(path, settings_for(Scripts::refused, true))));
      },
      py::arg("filename"),
      "The solid of a file of any kind; scripts are refused, several parts are one solid. See open() for options.");
  module.def(
      "load_parts",
      [](const std::filesystem::path& path, const py::object& progress) {
        return parts_of(long_work(
            progress, [&](Progress& p) { return open_model(path, settings_for(Scripts::refused, true), p); }));
      },
      py::arg("filename"), py::arg("progress") = py::none(), "The parts of a file: (solid, name, colour) each.");
  py::class_<OpenedModel>(module, "Model", "What a file holds: one solid, or several parts.")
      .def_property_readonly(
          "parts", [](const OpenedModel& opened) { return parts_of(opened.model); }, "(solid, name, colour) each.")
      .def_property_readonly(
          "notes", [](const OpenedModel& opened) { return opened.model.notes; },
          "What of the file was left out or mended, one line each.")
      .def_readonly("files", &OpenedModel::files, "The files that were read: itself, and those that it opens.")
      .def(
          "part",
          [](const OpenedModel& opened, const std::string& name) {
            return as_value(part_of(opened.model, name, opened.files.front().string()));
          },
          py::arg("name"), "The part of that name; names that are near are told where there is none.")
      .def(
          "united", [](const OpenedModel& opened) { return as_value(united(opened.model)); },
          "All parts as one solid.");
  module.def(
      "open_model",
      [](const std::filesystem::path& path, const py::object& progress) {
        return long_work(progress, [&](Progress& p) { return open_all(path, p); });
      },
      py::arg("filename"), py::arg("progress") = py::none(), "The model of a file of any kind; scripts are refused.");
  module.def(
      "frep_text",
      [](const py::iterable& parts, const std::filesystem::path& folder) {
        std::vector<frep::TextPart> texts;
        for (const PythonPart& part : parts_given(parts))
          texts.push_back({part.what.cast<SolidValue>().value.expression, part.name, part.colour, {}});
        return python_text(frep::print_parts(texts, folder));
      },
      py::arg("parts"), py::arg("folder") = "",
      "Parts, (solid, name, colour) each, as .frep text, which parse_parts() reads back; files are named as by "
      "Solid.frep().");
  module.def(
      "formats", describe_formats,
      "The table of file formats: a dict each with its extensions (\".stl\", ...), its kind (formula, script, design, "
      "distances, mesh or volume), whether it is read and written and keeps parts apart, and a line of help.");
  module.def(
      "run_model",
      [](const std::filesystem::path& path, const py::object& progress) {
        return as_value(long_work(
            progress, [&](Progress& p) { return united(open_model(path, settings_for(Scripts::run, true), p)); }));
      },
      py::arg("filename"), py::arg("progress") = py::none(),
      "load(), and scripts (.py .ko), too: they are run, in a process of their own, and can do whatever their user "
      "can.");

  module.def(
      "set_evaluator", [](const std::string& name) { frep::set_default_evaluator(frep::evaluator_named(name)); },
      py::arg("name"),
      "How formulas are evaluated from now on: automatic, reference, portable, avx2, avx512, jit, jit-avx2 or "
      "jit-avx512.");

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
    define_number(module, name, function);
  module.def(
      "value", [](const SolidValue& solid) { return SolidValue(Value{solid.value.expression}); }, py::arg("solid"),
      "The value of a solid at each point, as a number to reckon with.");
  using Binary = Expression (*)(const Expression&, const Expression&);
  for (const auto& [name, function] : std::initializer_list<std::pair<const char*, Binary>>{
           {"minimum", frep::min}, {"maximum", frep::max}, {"atan2", frep::atan2}, {"compare", frep::compare}}) {
    const bool keeps = function == static_cast<Binary>(frep::min) || function == static_cast<Binary>(frep::max);
    module.def(
        name,
        [function, keeps](const SolidValue& a, const SolidValue& b) {
          return SolidValue(
              Value{function(a.value.expression, b.value.expression), keeps && a.value.solid && b.value.solid});
        },
        py::arg("a"), py::arg("b"));
  }

  module.def("library", describe_library,
             "The functions of the design language, with their parameters, meanings and examples.");
  bind_library(module.def_submodule(
      "shapes", "Shapes and what is done with them. Lengths in mm, angles in radians. See docs/shapes.md."));
}

}  // namespace fieldfab::python
