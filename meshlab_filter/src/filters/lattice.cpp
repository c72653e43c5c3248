// Wall filled with a lattice.
#include <fmt/format.h>

#include <array>

#include "../solids.h"
#include "all.h"
#include "fieldfab/core/error.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"

namespace fieldfab::meshlab {
namespace {

struct Lattice {
  const char* name;
  frep::Expression (*of_period)(const frep::Expression&);
};

constexpr std::array<Lattice, 9> lattices{{{"gyroid", frep::shapes::gyroid},
                                           {"Schwarz P", frep::shapes::schwarz_p},
                                           {"diamond", frep::shapes::diamond},
                                           {"spinodal", frep::shapes::spinodal},
                                           {"cubic struts", frep::shapes::cubic_struts},
                                           {"BCC struts", frep::shapes::bcc_struts},
                                           {"FCC struts", frep::shapes::fcc_struts},
                                           {"octet struts", frep::shapes::octet_struts},
                                           {"honeycomb", frep::shapes::honeycomb_walls}}};

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const Lattice& lattice : lattices) all.emplace_back(lattice.name);
  return all;
}

std::vector<Parameter> lattice_parameters(const Document& document) {
  const double diagonal = document.chosen().bounds.valid() ? document.chosen().bounds.diagonal() : 100;
  std::vector<Parameter> rows{
      choice_parameter("Lattice", "Lattice", "Kind of lattice: walls along a surface, or struts.", names()),
      length_parameter("Period", "Period (mm)", "Edge length of a lattice cell.", diagonal / 10, 0, diagonal),
      length_parameter("Strut", "Lattice thickness (mm)", "Thickness of the lattice's walls or struts.", diagonal / 60,
                       0, diagonal),
      length_parameter("Wall", "Outer wall (mm)",
                       "Thickness of the wall around it, inwards from the surface; 0 leaves the lattice bare.",
                       diagonal / 60, 0, diagonal)};
  for (Parameter& row : fineness_parameters(document)) rows.push_back(std::move(row));
  return rows;
}

frep::Expression surface(int lattice, double period) {
  if (lattice < 0 || static_cast<std::size_t>(lattice) >= lattices.size())
    throw Error(ErrorKind::bad_input, "Lattice", fmt::format("is 0 to {}, not {}", lattices.size() - 1, lattice));
  return lattices[static_cast<std::size_t>(lattice)].of_period(period);
}

Result run_lattice(const Values& values, Progress& progress) {
  Result result;
  Fineness fineness = fineness_of(values);
  // The walls of the lattice are thin, so a search for edges is slow; it is done on demand only.
  if (fineness.edges == Fineness::Edges::automatic) fineness.edges = Fineness::Edges::rounded;
  const double period = values.positive("Period"), strut = values.positive("Strut"), wall = values.not_negative("Wall");
  const FieldPtr lattice =
      frep::make_field(frep::simplify(frep::shapes::shell(surface(values.whole("Lattice"), period), strut)));
  const Layer& layer = values.layer();
  const Solid solid = solid_of(layer, fineness, wall, result.log, progress);
  FieldPtr filled = intersect(solid.field, lattice);
  if (wall > 0) filled = unite(subtract(solid.field, offset(solid.field, -wall)), filled);
  result.add(
      layer_of(filled, *solid.bounds, fineness, is_sharp(solid), layer.name + " with lattice", result.log, progress));
  if (strut < 2 * fineness.voxel)
    result.log.push_back(
        fmt::format("the lattice's wall is {:.2g} voxels: below 2 it may have holes", strut / fineness.voxel));
  return result;
}

}  // namespace

Filter lattice_infill() {
  return {"Fieldfab: Lattice infill",
          "Makes the solid lighter: a wall of constant thickness, filled with a lattice of walls (gyroid, Schwarz P, "
          "diamond, spinodal, honeycomb) or struts (cubic, BCC, FCC, octet). The result is a new layer.",
          Filter::Group::remeshing,
          true,
          false,
          lattice_parameters,
          run_lattice};
}

}  // namespace fieldfab::meshlab
