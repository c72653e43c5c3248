#include "fieldfab/contour/detail.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fieldfab/contour/contour.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab {

struct DetailMesh::Node {
  Box box;
  int level = 0;
  FieldPtr solid;                            ///< restricted to the box and its margin
  std::shared_ptr<const TriangleMesh> mesh;  ///< null until it is made
  std::vector<Node> children;                ///< eight, or none

  [[nodiscard]] bool children_are_there() const {
    return !children.empty() &&
           std::all_of(children.begin(), children.end(), [](const Node& child) { return child.mesh != nullptr; });
  }
};

namespace {

constexpr std::size_t parts_at_a_time = 8;

/// Returns for each triangle whether it closes the mesh at the sides of its region, a cell beyond
/// the part's box: it lies in one of those sides as a whole, or has a corner out there that is not
/// on the solid's surface.
std::vector<bool> find_caps(const TriangleMesh& mesh, const Field& solid, const Box& part, const Box& bounds,
                            double cell) {
  const std::size_t count = mesh.vertices.size();
  std::vector<float> x(count), y(count), z(count), value(count), dx(count), dy(count), dz(count);
  for (std::size_t i = 0; i < count; ++i)
    x[i] = mesh.vertices[i][0], y[i] = mesh.vertices[i][1], z[i] = mesh.vertices[i][2];
  solid.gradients({x.data(), y.data(), z.data(), count}, value.data(), {dx.data(), dy.data(), dz.data()});
  std::vector<unsigned> sides(count);  // one bit per side of the region, set if the vertex lies on it
  std::vector<bool> stray(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 p(x[i], y[i], z[i]);
    for (int axis = 0; axis < 3; ++axis) {
      if (part.lower[axis] > bounds.lower[axis] && p[axis] < part.lower[axis] - 0.9 * cell)
        sides[i] |= 1U << (2 * axis);
      if (part.upper[axis] < bounds.upper[axis] && p[axis] > part.upper[axis] + 0.9 * cell)
        sides[i] |= 2U << (2 * axis);
    }
    const double slope = Vec3(dx[i], dy[i], dz[i]).norm();
    stray[i] = !part.contains(p) && std::isfinite(slope) && std::abs(value[i]) > 0.15 * cell * slope;
  }
  std::vector<bool> caps;
  caps.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles)
    caps.push_back((sides[a] & sides[b] & sides[c]) != 0 || stray[a] || stray[b] || stray[c]);
  return caps;
}

TriangleMesh without(const std::vector<bool>& unwanted, const TriangleMesh& whole) {
  TriangleMesh rest;
  std::vector<std::uint32_t> place(whole.vertices.size(), ~0U);
  for (std::size_t i = 0; i < whole.triangles.size(); ++i) {
    if (unwanted[i]) continue;
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex = whole.triangles[i][corner];
      if (place[vertex] == ~0U) {
        place[vertex] = static_cast<std::uint32_t>(rest.vertices.size());
        rest.vertices.push_back(whole.vertices[vertex]);
      }
      corners[corner] = place[vertex];
    }
    rest.triangles.push_back(corners);
  }
  return rest;
}

}  // namespace

DetailMesh::DetailMesh(FieldPtr solid, const Box& bounds, const DetailSettings& settings) : settings_(settings) {
  if (!bounds.valid() || bounds.size().minCoeff() <= 0)
    throw Error(ErrorKind::bad_input, "bounds", "a region must be finite and have a positive size along x, y and z");
  if (settings.cells < 4 || settings.cells > 256 || settings.deepest < 0 || settings.deepest > 20 ||
      !(settings.angle > 0))
    throw Error(ErrorKind::bad_input, "detail", "cells are from 4 to 256, levels from 0 to 20, the angle above 0");
  root_ = std::make_unique<Node>();
  root_->box = bounds;
  root_->solid = std::move(solid);
}

DetailMesh::~DetailMesh() = default;

/// Factor by which a node's cells appear too large.
double DetailMesh::coarseness(const Node& node, const Vec3& eye) const {
  const Vec3 nearest = eye.cwiseMax(node.box.lower).cwiseMin(node.box.upper);
  const double cell = node.box.size().maxCoeff() / settings_.cells;
  return cell / std::max((eye - nearest).norm(), cell) / settings_.angle;
}

void DetailMesh::divide(Node& node) {
  std::array<Box, 8> box, reached;
  std::array<Restriction, 8> here;
  const double cell = node.box.size().maxCoeff() / settings_.cells / 2;
  for (unsigned i = 0; i < 8; ++i) {
    box[i] = node.box;
    for (int axis = 0; axis < 3; ++axis)
      ((i >> axis & 1U) != 0 ? box[i].lower : box[i].upper)[axis] = node.box.centre()[axis];
    reached[i] = intersection(box[i].grown(2 * cell), root_->box);
  }
  node.solid->restrict_all(reached, Purpose::value, here);
  for (unsigned i = 0; i < 8; ++i) {
    Node child;
    child.box = box[i];
    child.level = node.level + 1;
    child.solid = std::move(here[i].field);
    if (here[i].range.decided()) child.mesh = std::make_shared<const TriangleMesh>();
    node.children.push_back(std::move(child));
  }
}

void DetailMesh::mesh(const std::vector<Node*>& nodes, Progress& progress) {
  parallel_for(nodes.size(), [&](std::size_t i) {
    Node& node = *nodes[i];
    const double cell = node.box.size().maxCoeff() / settings_.cells;
    const Box reached = node.level == 0 ? node.box : intersection(node.box.grown(cell), root_->box);
    const TriangleMesh whole = contour(*node.solid, reached, {cell, -1, true, 0}, progress);
    node.mesh =
        std::make_shared<const TriangleMesh>(without(find_caps(whole, *node.solid, node.box, root_->box, cell), whole));
  });
  for (const Node* node : nodes) triangles_ += node->mesh->triangles.size();
}

bool DetailMesh::refine(const Vec3& eye, Progress& progress) {
  if (!root_->mesh) {
    mesh({root_.get()}, progress);
    return true;
  }
  if (triangles_ > settings_.most_triangles) forget(*root_, eye);
  std::vector<std::pair<double, Node*>> missing;  // with the coarseness of the ancestor shown instead
  std::vector<Node*> open{root_.get()};
  while (!open.empty()) {
    Node& node = *open.back();
    open.pop_back();
    const double coarse = coarseness(node, eye);
    if (coarse <= 1 || node.level >= settings_.deepest || node.mesh->triangles.empty()) continue;
    if (node.children.empty()) divide(node);
    for (Node& child : node.children)
      if (child.mesh)
        open.push_back(&child);
      else
        missing.emplace_back(coarse, &child);
  }
  if (missing.empty()) return false;
  std::stable_sort(missing.begin(), missing.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Node*> next;
  for (std::size_t i = 0; i < std::min(missing.size(), parts_at_a_time); ++i) next.push_back(missing[i].second);
  mesh(next, progress);
  return true;
}

/// Drops the descendants of nodes that are fine enough.
void DetailMesh::forget(Node& node, const Vec3& eye) {
  if (coarseness(node, eye) > 1) {
    for (Node& child : node.children) forget(child, eye);
    return;
  }
  std::vector<Node> dropped = std::move(node.children);
  node.children.clear();
  while (!dropped.empty()) {
    Node last = std::move(dropped.back());
    dropped.pop_back();
    if (last.mesh) triangles_ -= last.mesh->triangles.size();
    for (Node& child : last.children) dropped.push_back(std::move(child));
  }
}

std::vector<DetailMesh::Part> DetailMesh::parts(const Vec3& eye) const {
  std::vector<Part> shown;
  std::vector<const Node*> open{root_.get()};
  while (!open.empty()) {
    const Node& node = *open.back();
    open.pop_back();
    if (!node.mesh) continue;
    if (coarseness(node, eye) > 1 && node.children_are_there())
      for (const Node& child : node.children) open.push_back(&child);
    else if (!node.mesh->triangles.empty())
      shown.push_back({node.box, node.level, node.mesh});
  }
  return shown;
}

}  // namespace fieldfab
