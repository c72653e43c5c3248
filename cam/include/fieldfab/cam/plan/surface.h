/// The surface of a solid as a cutter from above meets it, and the reachable positions of the cutter's tip.
#pragma once

#include <memory>
#include <optional>

#include "fieldfab/cam/base/tool.h"
#include "fieldfab/cam/plan/path.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab::cam {

struct SurfaceSettings {
  double cell = 0.1;        ///< sample spacing, mm
  double tolerance = 0.01;  ///< permitted deviation of the sampled surface, mm
};

/// The upper surface of a solid over a rectangle, as a height map, bilinear between samples. Squares with a deviation
/// above the tolerance (walls, edges, thin ribs) have a finer lattice, with samples at most about one tolerance apart.
/// A part between fine samples raises the neighbouring ones, so that it is kept, widened by that spacing. The height is
/// the floor where there is no solid. (Keeter's height map of 6.2 with a tolerance.)
class Surface {
 public:
  /// Samples the solid inside `bounds`; the lower z is the floor. If the Field has bounds of its slopes, or is a mesh,
  /// no part that rises more than four tolerances above the samples is missed, however thin. For other Fields (distance
  /// fields of scans) a part may be missed if it is thinner than a square and rises less than three squares above its
  /// corners, or is thinner than the fine spacing. Throws Error(bad_input), Error(too_large), Error(cancelled).
  static std::shared_ptr<const Surface> of(const Field& field, const Box& bounds, const SurfaceSettings& settings,
                                           Progress& progress = Progress::none());
  /// Wraps a height map unchanged; `floor` is the height outside, mm.
  static std::shared_ptr<const Surface> of(HeightMap heights, double floor);

  /// Returns the height at a point, mm; the floor outside.
  [[nodiscard]] double height(const Vec2& p) const;
  [[nodiscard]] const HeightMap& samples() const { return heights_; }
  [[nodiscard]] double floor() const { return floor_; }
  [[nodiscard]] double top() const { return top_; }
  /// Positions whose height is raised to that of a possible thin part, because its absence is not proved.
  struct Doubtful {
    std::size_t count = 0;
    Vec3 place = Vec3::Zero();  ///< the first of them, mm
  };
  [[nodiscard]] const Doubtful& doubtful() const { return doubtful_; }
  /// Number of squares with a finer lattice, and of samples along a side of one.
  [[nodiscard]] std::size_t fine_squares() const { return fine_.size(); }
  [[nodiscard]] int fine_side() const { return fine_side_; }

  /// Returns the fine samples of a square (given by column and row of its lower left sample), row by row, or nullptr.
  /// Owned by this object.
  [[nodiscard]] const float* fine(int column, int row) const {
    const std::int32_t i = fine_index_.empty() ? -1 : fine_index_[heights_.index(column, row)];
    return i < 0 ? nullptr : fine_[static_cast<std::size_t>(i)].data();
  }

 private:
  friend class SurfaceSampler;
  HeightMap heights_;
  double floor_ = 0, top_ = 0;
  Doubtful doubtful_;
  int fine_side_ = 0;
  std::vector<std::int32_t> fine_index_;  // per square; -1: none
  std::vector<std::vector<float>> fine_;
};

/// The configuration space of a cutter with a fixed axis: the lowest tip position without a gouge (the
/// pseudo-convolution of Keeter 6.8, at any position instead of at pixels).
class TipSurface {
 public:
  /// Keeps the tool `allowance` mm away from the surface. Shares ownership of `surface`.
  TipSurface(std::shared_ptr<const Surface> surface, const Profile& profile, double allowance = 0);

  struct Contact {
    double tip;  ///< z of the tip, mm; the floor where there is no contact
    Vec2 place;  ///< point of contact, mm
  };
  /// Returns the contact at a position. Exact for the sampled surface. O(squares under the tool) at worst, usually far
  /// less.
  [[nodiscard]] Contact contact(const Vec2& p) const { return contact(p, p); }
  /// Returns the contact at a position, starting the search at a likely point of contact.
  [[nodiscard]] Contact contact(const Vec2& p, const Vec2& guess) const;
  /// Returns the surface normal at a contact with the round corner of the tool at `p`; on a convex edge it lies between
  /// the normals of both sides. std::nullopt for a contact elsewhere on the tool.
  [[nodiscard]] std::optional<Vec3> corner_normal(const Vec2& p, const Contact& touched) const;
  [[nodiscard]] double tip(const Vec2& p) const { return contact(p).tip; }
  /// Bounds of tip() over a rectangle.
  [[nodiscard]] Interval range(const Rectangle& area) const;

  [[nodiscard]] const Surface& surface() const { return *surface_; }
  [[nodiscard]] const Profile& profile() const { return profile_; }
  [[nodiscard]] double allowance() const { return allowance_; }

  /// Samples along a side of the blocks that are searched together.
  static constexpr int block_side = 8;

  /// Returns -tip() as a Field of x and y. Its contours at level -z are waterlines: the positions with the tip at z. On
  /// the left of the loops the tip cannot be as low. Shares ownership of `tips`.
  static FieldPtr field(std::shared_ptr<const TipSurface> tips);

 private:
  struct Search;
  /// Lower bound of the profile's height at distances from the axis with a square of at least `squared`.
  [[nodiscard]] double least_height(double squared) const {
    return least_heights_[static_cast<std::size_t>(squared * per_square_)];
  }
  void edge_contacts(const Vec2& p, double around, Contact& best) const;

  std::shared_ptr<const Surface> surface_;
  Profile profile_;  // offset by the allowance
  double allowance_;
  FlatCornerCone closed_form_;
  std::vector<double> least_heights_;  // indexed by the squared distance from the axis
  double per_square_ = 0;
  static constexpr std::size_t block_level = 3;  // level of tops_ with the squares that are blocks
  [[nodiscard]] std::size_t block_index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(blocks_wide_) + static_cast<std::size_t>(column);
  }
  [[nodiscard]] const float* block(int column, int row) const {
    return blocks_.data() + block_index(column, row) * block_side * block_side;
  }
  [[nodiscard]] bool has_fine(int column, int row) const { return has_fine_[block_index(column, row)] != 0; }
  void lay_out_blocks();
  int blocks_wide_ = 0;
  std::vector<float> blocks_;  // samples by blocks
  std::vector<std::uint8_t> has_fine_;
  std::vector<HeightMap> tops_;  // greatest heights in squares of 1, 2, 4 and so on cells
};

}  // namespace fieldfab::cam
