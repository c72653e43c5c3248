// Rows of dialogs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cost.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "solids.h"

namespace fieldfab::meshlab {
namespace {

Parameter parameter(std::string name, std::string label, std::string help, Parameter::Kind kind,
                    std::variant<double, std::string> value) {
  Parameter row;
  row.name = std::move(name), row.label = std::move(label), row.help = std::move(help), row.kind = kind,
  row.value = std::move(value);
  return row;
}

}  // namespace

Parameter length_parameter(std::string name, std::string label, std::string help, double value, double least,
                           double most) {
  Parameter row = parameter(std::move(name), std::move(label), std::move(help), Parameter::Kind::length, value);
  row.least = least, row.most = most;
  return row;
}
Parameter number_parameter(std::string name, std::string label, std::string help, double value) {
  return parameter(std::move(name), std::move(label), std::move(help), Parameter::Kind::number, value);
}
Parameter whole_parameter(std::string name, std::string label, std::string help, int value) {
  return parameter(std::move(name), std::move(label), std::move(help), Parameter::Kind::whole,
                   static_cast<double>(value));
}
Parameter choice_parameter(std::string name, std::string label, std::string help, std::vector<std::string> choices,
                           int value) {
  Parameter row = parameter(std::move(name), std::move(label), std::move(help), Parameter::Kind::choice,
                            static_cast<double>(value));
  row.choices = std::move(choices);
  return row;
}
Parameter layer_parameter(std::string name, std::string label, std::string help, std::size_t value) {
  return parameter(std::move(name), std::move(label), std::move(help), Parameter::Kind::layer,
                   static_cast<double>(value));
}
Parameter text_parameter(std::string name, std::string label, std::string help, std::string value) {
  return parameter(std::move(name), std::move(label), std::move(help), Parameter::Kind::text, std::move(value));
}
Parameter flag_parameter(std::string name, std::string label, std::string help, bool value) {
  return parameter(std::move(name), std::move(label), std::move(help), Parameter::Kind::yes_no, value ? 1.0 : 0.0);
}

std::vector<Parameter> fineness_parameters(const Document& document) {
  const Document::Entry chosen = document.chosen();
  const double diagonal = chosen.bounds.valid() && chosen.triangles > 0 ? chosen.bounds.diagonal() : 100;
  const double voxel = diagonal / 150;
  std::string cost;
  if (chosen.triangles > 0)
    cost = fmt::format(" For this layer {:.3g} mm takes about {}, {:.3g} mm about {}; {} are free.", voxel,
                       as_bytes(lattice_cost(chosen.bounds, voxel)), voxel / 4,
                       as_bytes(lattice_cost(chosen.bounds, voxel / 4)),
                       as_bytes(static_cast<double>(available_memory())));
  return {
      length_parameter(
          "Voxel", "Voxel (mm)",
          "Edge of the smallest cell. Lengths are in the units of the mesh, which are taken for millimetres. "
          "Parts thinner than a voxel may be lost." +
              cost,
          voxel, 0, diagonal),
      choice_parameter("Edges", "Sharp edges",
                       "Automatic keeps sharp edges if the triangles are larger than a few voxels (designed "
                       "parts; flat faces of closed ones stay exact). For smaller triangles (scans) and thin walls "
                       "it samples distances on a lattice, which is faster. Keeping the edges of small triangles is "
                       "slow.",
                       {"automatic", "keep", "round off"})};
}

Fineness fineness_of(const Values& values) {
  const int edges = values.whole("Edges");
  if (edges < 0 || edges > 2) throw Error(ErrorKind::bad_input, "Edges", fmt::format("is 0, 1 or 2, not {}", edges));
  return {values.positive("Voxel"), static_cast<Fineness::Edges>(edges)};
}

}  // namespace fieldfab::meshlab
