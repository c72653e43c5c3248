// The graph of stages and the machines, as data from which panels are generated.
#include <cmath>

#include "bindings.h"
#include "fieldfab/cam/base/tool_library.h"
#include "fieldfab/cam/job/stage.h"
#include "fieldfab/cam/machine/machine.h"
#include "fieldfab/core/angle.h"
#include "fieldfab/core/error.h"

namespace fieldfab::python {
namespace {

py::object limit(double value) { return std::isfinite(value) ? py::object(py::float_(value)) : py::none(); }

py::dict dict_of(const cam::Setting& s) {
  py::dict d;
  const double* const number = std::get_if<double>(&s.standard);
  d["name"] = s.name, d["help"] = s.help, d["unit"] = s.unit;
  d["default"] = number != nullptr && *number == cam::unset ? py::object(py::none()) : py::cast(s.standard);
  d["kind"] = std::vector<std::string>{"flag", "number", "text", "list"}[s.standard.index()];
  d["lower"] = limit(s.lower), d["upper"] = limit(s.upper), d["lower_open"] = s.lower_open, d["whole"] = s.whole;
  d["choices"] = s.choices, d["needs"] = s.needs, d["needs_values"] = s.needs_values;
  return d;
}

py::list list_of(const cam::Settings& settings) {
  py::list out;
  for (const cam::Setting& s : settings) out.append(dict_of(s));
  return out;
}

py::dict dict_of(const cam::Stage& stage) {
  py::dict d;
  d["name"] = stage.name, d["help"] = stage.help, d["operation"] = stage.operation;
  d["takes"] = cam::name_of(stage.takes), d["makes"] = cam::name_of(stage.makes),
  d["settings"] = list_of(stage.settings);
  return d;
}

py::dict dict_of(const cam::Machine& m) {
  py::dict d;
  d["id"] = m.id, d["name"] = m.name, d["description"] = m.description, d["extension"] = m.extension,
  d["takes"] = cam::name_of(m.takes);
  d["unit"] = m.unit, d["travel"] = m.travel, d["max_feed"] = m.max_feed, d["max_spindle"] = m.max_spindle;
  d["rapid"] = m.dynamics.rapid, d["kinematics"] = cam::name_of(m.kinematics.kind),
  d["default_operation"] = m.default_operation;
  py::list axes;
  for (const cam::RotaryAxis& axis : m.kinematics.axes) axes.append(std::string(1, axis.letter));
  d["axes"] = axes, d["settings"] = list_of(m.settings);
  py::dict materials;
  for (const auto& [name, values] : m.materials) materials[py::str(name)] = values;
  d["materials"] = materials;
  return d;
}

cam::Kind kind_of(const std::string& name) {
  for (const cam::Stage& stage : cam::stages())
    if (name == cam::name_of(stage.takes)) return stage.takes;
  throw Error(ErrorKind::bad_input, "kind", "nothing in the workflow is called " + name);
}

/// A tool with the keys of job files (docs/cam.md); what is not known is left out.
py::dict dict_of(const cam::Tool& tool) {
  py::dict d;
  d["number"] = tool.number, d["name"] = tool.name, d["shape"] = cam::name_of(tool.shape), d["flutes"] = tool.flutes;
  const auto add = [&](const char* key, double value) {
    if (value > 0) d[key] = value;
  };
  add("diameter", tool.diameter), add("corner_radius", tool.corner_radius), add("angle", to_degrees(tool.angle));
  add("tip_diameter", tool.tip_diameter), add("flute", tool.flute), add("length", tool.length);
  add("shank", tool.shank), add("holder_diameter", tool.holder_diameter), add("holder_length", tool.holder_length);
  add("feed", tool.feed), add("plunge", tool.plunge), add("spindle", tool.spindle);
  return d;
}

}  // namespace

void bind_workflow(py::module_& module) {
  module.def(
      "stages",
      [] {
        py::list out;
        for (const cam::Stage& stage : cam::stages()) out.append(dict_of(stage));
        return out;
      },
      "All stages of the workflow: name, help, what each takes and makes, whether it is an operation, and its "
      "settings. Of a "
      "setting: "
      "name, help, unit, kind, default (None: it follows from other things), lower, upper, lower_open, whole, choices; "
      "and "
      "`needs`, "
      "the setting without which it means nothing, with the values that one must have.");
  module.def(
      "read_tools",
      [](const std::filesystem::path& path) {
        py::list tools;
        for (const cam::Tool& tool : cam::read_tool_library(path)) tools.append(dict_of(tool));
        return tools;
      },
      py::arg("path"),
      "Returns the tools of a library or a tool bit of FreeCAD's (.fctl, .fctb), or of Fusion's library (.json), each "
      "as "
      "a dict with the keys of job files. Kinds of tools that are not known are left out.");
  module.def(
      "chain",
      [](const std::string& kind, const std::string& operation) {
        std::vector<std::string> names;
        for (const cam::Stage* stage : cam::chain(kind_of(kind), cam::operation(operation, "operation")))
          names.push_back(stage->name);
        return names;
      },
      py::arg("kind"), py::arg("operation"),
      "The names of the stages that lead from a solid or an image to an operation's paths.");
  module.def(
      "joining_settings", [] { return list_of(cam::joining_settings()); },
      "What all operations can be told besides: how their paths are joined to moves.");
  module.def(
      "machine", [](const std::string& id) { return dict_of(cam::load_machine(id)); }, py::arg("id"),
      "A machine by its id or file: what it takes, its limits (mm, mm/min; 0: none known), settings, materials and "
      "rotary axes. A material without values has those of cutting_values().");
  module.def(
      "cutting_values",
      [](const std::string& machine, const std::string& material, double diameter, int flutes, double spindle) {
        cam::Tool tool;
        tool.diameter = diameter, tool.flutes = flutes, tool.spindle = spindle;
        py::dict d;
        if (const auto values = cam::cutting_values_of(cam::load_machine(machine), material, tool))
          d["feed"] = values->feed, d["plunge"] = values->plunge, d["spindle"] = values->spindle;
        return d;
      },
      py::arg("machine"), py::arg("material"), py::arg("diameter"), py::arg("flutes") = 2, py::arg("spindle") = 0,
      "Starting values of feed and plunge, mm/min, and of the spindle speed, rpm, for a tool in a material on a "
      "machine: those that follow from the material's chip load (docs/cam.md). `diameter`: mm. `spindle`: the tool's "
      "own speed; 0: the fastest that material and machine allow. Empty where no chip load is known or the machine has "
      "values of its own.");
}

}  // namespace fieldfab::python
