/// Search for edges and corners of a solid near a point, by evaluation of its Field only.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "fieldfab/field/field.h"
#include "vertex.h"

namespace fieldfab::contouring {

/// Points as a structure of arrays, with the value and gradient of the Field at each.
class Samples {
 public:
  void clear() { x_.clear(), y_.clear(), z_.clear(); }
  void add(const Eigen::Vector3f& p) { x_.push_back(p.x()), y_.push_back(p.y()), z_.push_back(p.z()); }
  void ask(const Field& solid);
  [[nodiscard]] std::size_t size() const { return x_.size(); }
  [[nodiscard]] Eigen::Vector3f point(std::size_t i) const { return {x_[i], y_[i], z_[i]}; }
  [[nodiscard]] Eigen::Vector3f slope(std::size_t i) const { return {dx_[i], dy_[i], dz_[i]}; }
  /// Returns the distance from the surface to first order, mm; 0 if the Field has no usable
  /// gradient, so that no step is tried there.
  [[nodiscard]] float distance(std::size_t i) const;
  void step(std::size_t i, const Eigen::Vector3f& by) { x_[i] += by.x(), y_[i] += by.y(), z_[i] += by.z(); }

 private:
  std::vector<float> x_, y_, z_, value_, dx_, dy_, dz_;
};

/// Working memory of feature_near().
struct FeatureSearch {
  Samples around;
  std::vector<SurfacePoint> found;  ///< by the last search

  /// Returns the cosine of the greatest angle between the first normal found and another.
  [[nodiscard]] float least_cosine() const;
};

/// Returns the sharpest feature of the solid within `reach` mm of `centre`. Searches the surface in
/// all directions around the centre; the tangent planes found decide between a corner, an edge and
/// one smooth surface. Only points in `known`, in which the Field may be evaluated, count.
PlacedVertex feature_near(const Field& solid, const Box& known, const Eigen::Vector3f& centre, float reach,
                          FeatureSearch& search);

}  // namespace fieldfab::contouring
