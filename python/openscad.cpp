#include "bindings.h"
#include "fieldfab/core/text.h"
#include "fieldfab/openscad/design.h"

namespace fieldfab::python {
namespace {

using openscad::NodeIndex;
using openscad::Tree;

/// A tree that is kept alive by the nodes that Python holds.
struct SharedTree {
  std::shared_ptr<const Tree> tree;
  std::shared_ptr<const std::vector<int>> dimensions;
};

/// One node of the tree.
struct SharedNode {
  SharedTree whole;
  NodeIndex index;
  [[nodiscard]] const openscad::Node& get() const { return whole.tree->nodes[index]; }
};

py::object to_python(const openscad::Value& value) {
  if (const bool* truth = value.truth()) return py::bool_(*truth);
  if (const double* number = value.number()) return py::float_(*number);
  if (const std::string* text = value.text()) return py::str(printable(*text));
  if (const openscad::List* list = value.list()) {
    py::list items;
    for (const openscad::Value& item : *list) items.append(to_python(item));
    return std::move(items);
  }
  return py::none();
}

py::dict arguments_of(const SharedNode& node) {
  py::dict arguments;
  for (const openscad::Argument& argument : node.get().arguments)
    arguments[py::str(argument.name)] = to_python(argument.value);
  return arguments;
}

SharedTree shared(Tree tree) {
  auto dimensions = std::make_shared<const std::vector<int>>(openscad::dimensions_of(tree));
  return {std::make_shared<const Tree>(std::move(tree)), std::move(dimensions)};
}

/// Result of an OpenSCAD text.
struct Design {
  std::optional<Solid> solid;  ///< a plate for a flat design; std::nullopt for an empty one
  bool flat;
  std::optional<double> voxel;
  std::vector<std::string> notes;
};

Design design_of(const std::string& text, const std::filesystem::path& folder, const std::string& name,
                 double thickness, bool smooth, Progress& progress) {
  const std::shared_ptr<const OpenedSolid> made =
      openscad::make_design(openscad::parse_csg(text, name), folder, {smooth, false}, progress);
  Design design{{}, made->flat, made->voxel, {}};
  for (const std::string& note : made->notes) design.notes.push_back(printable(note));
  if (made->field == nullptr) return design;
  design.solid = fieldfab::solid_of(made);
  if (made->flat) design.solid = plate_of(*design.solid, thickness);
  return design;
}

}  // namespace

void bind_openscad(py::module_& module) {
  py::class_<SharedNode>(module, "OpenScadNode", "A node of an OpenSCAD design's tree, as a .csg file has it.")
      .def_property_readonly(
          "name", [](const SharedNode& node) { return printable(node.get().name); }, "What it is: cube, union, ...")
      .def_property_readonly("arguments", arguments_of,
                             "{name: value}; the name of a value without one is empty, undef is None.")
      .def_property_readonly(
          "children", [](const SharedNode& node) { return node.get().children; }, "Its children's numbers in the tree.")
      .def_property_readonly(
          "line", [](const SharedNode& node) { return node.get().line; }, "Of the .csg text, from 1.")
      .def_property_readonly(
          "dimensions", [](const SharedNode& node) { return (*node.whole.dimensions)[node.index]; },
          "2 or 3; 0 where it draws nothing.")
      .def_property_readonly(
          "background", [](const SharedNode& node) { return node.get().background; },
          "%: shown, not part of the solid.")
      .def_property_readonly(
          "disabled", [](const SharedNode& node) { return node.get().disabled; }, "*: as if it were not there.")
      .def_property_readonly(
          "root", [](const SharedNode& node) { return node.get().root; }, "!: the design is this node alone.")
      .def_property_readonly(
          "highlight", [](const SharedNode& node) { return node.get().highlight; }, "#: shown in another colour.")
      .def(
          "text",
          [](const SharedNode& node) {
            return printable(print_csg(*node.whole.tree, node.index, openscad::Modifiers::kept));
          },
          "It and what is below it as .csg text, with modifiers.");
  py::class_<SharedTree>(
      module, "OpenScadTree",
      "All nodes of an OpenSCAD design; the first is a group of the whole. Children come after their parents.")
      .def("__len__", [](const SharedTree& tree) { return tree.tree->nodes.size(); })
      .def(
          "__getitem__",
          [](const SharedTree& tree, std::size_t index) {
            if (index >= tree.tree->nodes.size()) throw py::index_error("there are fewer nodes");
            return SharedNode{tree, static_cast<NodeIndex>(index)};
          },
          py::arg("index"));
  py::class_<Design>(module, "OpenScadDesign", "What OpenSCAD text makes.")
      .def_property_readonly(
          "solid",
          [](const Design& design) { return design.solid ? std::optional(SolidValue(*design.solid)) : std::nullopt; },
          "The solid, which has its own faces (see mesh()); None where the design is empty.")
      .def_readonly("voxel", &Design::voxel,
                    "Cells that do not miss its thinnest part, mm; None where nothing is known of it.")
      .def_readonly("flat", &Design::flat, "Whether the design is 2D; its solid is a plate then.")
      .def_readonly("notes", &Design::notes, "What was left out or mended, one line each, with NAME:LINE.");
  module.def(
      "read_openscad_tree",
      [](const std::filesystem::path& path, const py::object& progress) {
        return long_work(progress, [&](Progress& p) { return shared(openscad::read_tree(path, p)); });
      },
      py::arg("filename"), py::arg("progress") = py::none(),
      "The tree of a .csg file, or of a .scad file through the installed OpenSCAD.");
  module.def(
      "openscad_design",
      [](const std::string& text, const std::filesystem::path& folder, const std::string& name, double thickness,
         bool smooth, const py::object& progress) {
        return long_work(progress, [&](Progress& p) { return design_of(text, folder, name, thickness, smooth, p); });
      },
      py::arg("text"), py::arg("folder") = "", py::arg("name") = "design", py::arg("thickness") = 1.0,
      py::arg("smooth") = false, py::arg("progress") = py::none(),
      "The solid of .csg text. `folder`: where the files that it imports are; `name`: what messages call it; "
      "`thickness`: of the "
      "plate, from z = 0 on, that a flat design becomes, mm.");
}

}  // namespace fieldfab::python
