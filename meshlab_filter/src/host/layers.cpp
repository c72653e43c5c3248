#include "layers.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "fieldfab/core/error.h"
#include "meshlab.h"

namespace fieldfab::meshlab {
namespace {

std::string utf8(const QString& text) { return text.toUtf8().toStdString(); }

vcg::Color4b colour_of(Colour colour) { return {colour.red, colour.green, colour.blue, 255}; }

}  // namespace

Layer layer_from(const MeshModel& model) {
  Layer layer;
  layer.name = utf8(model.label());
  const CMeshO& mesh = model.cm;
  std::vector<std::uint32_t> name(mesh.vert.size(), 0);
  layer.mesh.vertices.reserve(static_cast<std::size_t>(mesh.vn));
  for (std::size_t i = 0; i < mesh.vert.size(); ++i) {
    if (mesh.vert[i].IsD()) continue;
    name[i] = static_cast<std::uint32_t>(layer.mesh.vertices.size());
    const auto place = mesh.Tr * mesh.vert[i].cP();
    layer.mesh.vertices.push_back({place[0], place[1], place[2]});
  }
  layer.mesh.triangles.reserve(static_cast<std::size_t>(mesh.fn));
  for (const CFaceO& face : mesh.face) {
    if (face.IsD()) continue;
    std::array<std::uint32_t, 3> triangle{};
    for (int corner = 0; corner < 3; ++corner)
      triangle[static_cast<std::size_t>(corner)] = name[vcg::tri::Index(mesh, face.cV(corner))];
    layer.mesh.triangles.push_back(triangle);
  }
  return layer;
}

Document document_from(const MeshDocument& document) {
  Document seen;
  for (const MeshModel* model : layers_of(document)) {
    if (model == document.mm()) seen.current = seen.layers.size();
    const Layer layer = layer_from(*model);
    constexpr double inf = std::numeric_limits<double>::infinity();
    Document::Entry entry{layer.name, {Vec3::Constant(inf), Vec3::Constant(-inf)}, layer.mesh.triangles.size(), 0};
    for (const auto& t : layer.mesh.triangles) {
      std::array<Vec3, 3> corner;
      for (std::size_t i = 0; i < 3; ++i)
        corner[i] = Vec3(layer.mesh.vertices[t[i]][0], layer.mesh.vertices[t[i]][1], layer.mesh.vertices[t[i]][2]);
      const double area = 0.5 * (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm();
      if (!std::isfinite(area)) continue;
      entry.area += area;
      for (const Vec3& p : corner) entry.bounds = hull(entry.bounds, {p, p});
    }
    seen.layers.push_back(std::move(entry));
  }
  return seen;
}

void write_layer(const Layer& layer, MeshModel& model) {
  CMeshO& mesh = model.cm;
  auto vertex = vcg::tri::Allocator<CMeshO>::AddVertices(mesh, layer.mesh.vertices.size());
  for (std::size_t i = 0; i < layer.mesh.vertices.size(); ++i, ++vertex) {
    const auto& p = layer.mesh.vertices[i];
    vertex->P() = {p[0], p[1], p[2]};
    if (!layer.colours.empty()) vertex->C() = colour_of(layer.colours[i]);
  }
  auto face = vcg::tri::Allocator<CMeshO>::AddFaces(mesh, layer.mesh.triangles.size());
  for (const auto& t : layer.mesh.triangles) {
    for (int corner = 0; corner < 3; ++corner) face->V(corner) = &mesh.vert[t[static_cast<std::size_t>(corner)]];
    ++face;
  }
  update_box_and_normals(model);
  model.updateDataMask(MeshModel::MM_VERTNORMAL | MeshModel::MM_FACENORMAL |
                       (layer.colours.empty() ? MeshModel::MM_NONE : MeshModel::MM_VERTCOLOR));
}

void write_colours(const Result& result, MeshModel& model) {
  CMeshO& mesh = model.cm;
  if (result.quality.size() != static_cast<std::size_t>(mesh.vn) || result.colours.size() != result.quality.size())
    throw Error(ErrorKind::internal, "filter", "has not a quality and a colour for each vertex");
  std::size_t n = 0;
  for (CVertexO& vertex : mesh.vert) {
    if (vertex.IsD()) continue;
    vertex.Q() = result.quality[n];
    vertex.C() = colour_of(result.colours[n]);
    ++n;
  }
  model.updateDataMask(MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR);
}

}  // namespace fieldfab::meshlab
