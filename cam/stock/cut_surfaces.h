/// The exact surfaces that cuts have made, from their strokes.
#pragma once

#include <optional>
#include <vector>

#include "stroke_log.h"

namespace fieldfab::cam {

/// Tangent planes of the volumes that cuts have swept. A swept volume is the union of the tool's poses: its distance
/// from a point outside is the least over all moments of the stroke, and the direction to the nearest point is the
/// normal there, on facets of the tool, on surfaces that its edges sweep, and on grazing curves alike. All lengths are
/// relative to the corner of the stock's box.
class CutSurfaces {
 public:
  explicit CutSurfaces(const Stock& stock);

  struct Plane {
    Vec3 place, normal;
  };
  /// The plane tangent to a cut's surface near a place on it. `inward` leads into the material that is left. Nothing if
  /// the cut's strokes are not known, or none has its surface there. Cut 0 is the Field that the stock was made of.
  [[nodiscard]] std::optional<Plane> tangent(std::uint32_t cut, const Vec3& place, const Vec3& inward) const;
  /// Whether one cut may have made both sides of an edge: the tool has edges or a point of its own.
  [[nodiscard]] bool has_edges(std::uint32_t cut) const;
  /// The axis that a cut's flat ends were perpendicular to during all of its strokes; 3: none.
  [[nodiscard]] std::size_t level_axis(std::uint32_t cut) const;
  [[nodiscard]] bool none() const { return strokes_.empty(); }
  /// Whether the stock was made of a Field, so that cut 0 has planes too.
  [[nodiscard]] bool has_first() const { return first_ != nullptr; }

 private:
  static constexpr std::uint32_t group = 16;
  struct Nearest {
    double distance;
    Vec3 outward;  ///< from the swept volume
  };
  /// The strokes of a cut.
  struct Cut {
    std::uint32_t number, first, last;
    bool edges;
    std::uint8_t level;
  };
  [[nodiscard]] const Cut* find(std::uint32_t number) const;
  [[nodiscard]] std::optional<Nearest> nearest(const Cut& cut, const Vec3& place, double within) const;

  [[nodiscard]] std::optional<Plane> tangent_to_first(const Vec3& place) const;

  FieldPtr first_;
  Vec3 origin_;
  std::shared_ptr<const StrokeLog> log_;
  std::vector<StrokeLog::Ref> strokes_;  ///< by cut
  std::vector<Box> groups_;              ///< bounds of each `group` strokes: most are far from a place
  std::vector<Cut> cuts_;                ///< by number
  double cell_;
};

}  // namespace fieldfab::cam
