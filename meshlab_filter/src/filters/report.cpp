// Report whether a layer is a valid solid.
#include <fmt/format.h>

#include "../solids.h"
#include "all.h"
#include "fieldfab/check/check.h"
#include "fieldfab/mesh/mesh_distances.h"

namespace fieldfab::meshlab {
namespace {

Result run_report(const Values& values, Progress&) {
  Result result;
  const Layer& layer = values.layer();
  std::vector<std::string> notes;
  const TriangleMesh mesh = usable_triangles(layer, notes);
  const MeshVerdict verdict = inspect(mesh);
  const Lids lids = lids_of(mesh);
  const auto row = [&](const char* what, bool good, const std::string& found) {
    result.log.push_back(fmt::format("{}  {}: {}", good ? "ok " : "BAD", what, found));
  };
  const auto yes = [](bool is) { return std::string(is ? "yes" : "no"); };
  result.log.push_back(fmt::format("Validity of '{}': {} triangles, {} vertices", layer.name, mesh.triangles.size(),
                                   mesh.vertices.size()));
  for (std::string& note : notes) result.log.push_back("BAD  " + note);
  row("manifold", verdict.manifold, yes(verdict.manifold));
  row("closed", verdict.closed && lids.triangles.empty(),
      verdict.closed ? "yes" : fmt::format("no; {} edges of {} rims", lids.edges, lids.rims));
  row("faces outwards", verdict.outward, yes(verdict.outward));
  row("self-intersections (CGAL)", verdict.self_intersections == 0,
      fmt::format("{} pairs of triangles", verdict.self_intersections));
  row("triangles without area", verdict.degenerate == 0, fmt::format("{}", verdict.degenerate));
  const Box box = mesh.bounds();
  result.log.push_back(fmt::format("     pieces: {}, volume {:.6g} mm3, area {:.6g} mm2, {:.5g} x {:.5g} x {:.5g} mm",
                                   verdict.components, verdict.volume, verdict.area, box.size().x(), box.size().y(),
                                   box.size().z()));
  result.log.push_back(verdict.valid() && notes.empty()
                           ? "It is a valid solid."
                           : "It is not a valid solid: Fieldfab: Remesh through a distance field makes one of it.");
  return result;
}

}  // namespace

Filter validity_report() {
  return {"Fieldfab: Validity report",
          "Reports in the log whether the layer is closed, manifold, oriented outwards and free of self- "
          "intersections (by CGAL, exactly). Nothing is changed.",
          Filter::Group::measure,
          true,
          false,
          [](const Document&) { return std::vector<Parameter>{}; },
          run_report};
}

}  // namespace fieldfab::meshlab
