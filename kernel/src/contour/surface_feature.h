/// Finding the edges and corners of a solid near a point, by asking its Field alone.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "fieldfab/field/field.h"
#include "vertex.h"

namespace fieldfab::contouring {

/// Points in a structure of arrays, and what the Field says there.
class Samples {
 public:
  void clear() { x_.clear(), y_.clear(), z_.clear(); }
  void add(const Eigen::Vector3f& p) { x_.push_back(p.x()), y_.push_back(p.y()), z_.push_back(p.z()); }
  void ask(const Field& solid);
  [[nodiscard]] std::size_t size() const { return x_.size(); }
  [[nodiscard]] Eigen::Vector3f point(std::size_t i) const { return {x_[i], y_[i], z_[i]}; }
  [[nodiscard]] Eigen::Vector3f slope(std::size_t i) const { return {dx_[i], dy_[i], dz_[i]}; }
  /// Distance from the surface to first order, mm; 0 where the Field has no usable gradient, so that nothing is tried there.
  [[nodiscard]] float distance(std::size_t i) const;
  void step(std::size_t i, const Eigen::Vector3f& by) { x_[i] += by.x(), y_[i] += by.y(), z_[i] += by.z(); }

 private:
  std::vector<float> x_, y_, z_, value_, dx_, dy_, dz_;
};

/// The solid's sharpest feature within each of `reaches` mm of `centre`: the surface is looked for in all directions around, and
/// the planes that touch it there say whether they meet in a corner, an edge, or are one surface. Only what is found in `known`,
/// where the Field may be asked, counts. `scratch` is for the asking.
std::vector<PlacedVertex> features_near(const Field& solid, const Box& known, const Eigen::Vector3f& centre,
                                        std::span<const float> reaches, Samples& scratch);

}  // namespace fieldfab::contouring
