/// A solid's surface as a cutter from above meets it, and where the cutter's tip can go.
#pragma once

#include <memory>
#include <optional>

#include "fieldfab/cam/base/tool.h"
#include "fieldfab/cam/plan/path.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab::cam {

struct SurfaceSettings {
  double cell = 0.1;        ///< distance of samples, mm
  double tolerance = 0.01;  ///< how far the surface kept may be from the true one, mm
};

/// The upper surface of a solid over a rectangle: heights on a lattice, bilinear between samples; squares where that would be off
/// by more than the tolerance (walls, edges, thin ribs) hold a finer lattice, whose samples are at most about the tolerance
/// apart. What stands between fine samples lifts them, so that it is kept, wider by that distance. Where there is nothing, the
/// surface is the floor. (Keeter's height map of 6.2, made good to a tolerance.)
class Surface {
 public:
  /// Samples the solid inside `bounds`, whose lower z is the floor. Where the Field tells its slopes, or is a mesh, nothing of it
  /// is missed that rises more than four tolerances above the samples, however thin; of other Fields (distance fields of
  /// scans) what is thinner than a square and does not rise three squares above its corners, or is thinner than a fine
  /// sample. Throws bad_input, too_large, cancelled.
  static std::shared_ptr<const Surface> of(const Field& field, const Box& bounds, const SurfaceSettings& settings,
                                           Progress& progress = Progress::none());
  /// A height map as it is.
  static std::shared_ptr<const Surface> of(HeightMap heights, double floor);

  /// Height at a point; the floor outside. mm
  [[nodiscard]] double height(const Vec2& p) const;
  [[nodiscard]] const HeightMap& samples() const { return heights_; }
  [[nodiscard]] double floor() const { return floor_; }
  [[nodiscard]] double top() const { return top_; }
  /// Places that are kept as high as a thin part could be, because it is not proved that there is none.
  struct Doubtful {
    std::size_t count = 0;
    Vec3 place = Vec3::Zero();  ///< the first of them, mm
  };
  [[nodiscard]] const Doubtful& doubtful() const { return doubtful_; }
  /// Squares with a finer lattice, and samples along one side of it.
  [[nodiscard]] std::size_t fine_squares() const { return fine_.size(); }
  [[nodiscard]] int fine_side() const { return fine_side_; }

  /// The fine samples of a square (its lower left sample's column and row), row by row, or nullptr.
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
  std::vector<std::int32_t> fine_index_;  // by square; -1: none
  std::vector<std::vector<float>> fine_;
};

/// How low a cutter's tip can go without cutting into a surface: the configuration space of a cutter that does not tilt (6.8's
/// pseudo-convolution, at any place instead of at pixels).
class TipSurface {
 public:
  /// Keeps the tool `allowance` mm off the surface all around.
  TipSurface(std::shared_ptr<const Surface> surface, const Profile& profile, double allowance = 0);

  struct Contact {
    double tip;  ///< z of the tip, mm; the floor (less nothing) where nothing is in the way
    Vec2 place;  ///< where the cutter touches, mm
  };
  /// Exact for the surface as it is kept. O(radius in squares) at worst, and far less as a rule.
  [[nodiscard]] Contact contact(const Vec2& p) const { return contact(p, p); }
  /// The same, with a place that is probably touched.
  [[nodiscard]] Contact contact(const Vec2& p, const Vec2& guess) const;
  /// The normal that the surface has for a tool at `p` which touches it with its round corner; on a sharp edge it lies between
  /// the normals of both sides. Nothing where the tool touches with something else.
  [[nodiscard]] std::optional<Vec3> corner_normal(const Vec2& p, const Contact& touched) const;
  [[nodiscard]] double tip(const Vec2& p) const { return contact(p).tip; }
  /// Bounds of tip() over a rectangle.
  [[nodiscard]] Interval range(const Rectangle& area) const;

  [[nodiscard]] const Surface& surface() const { return *surface_; }
  [[nodiscard]] const Profile& profile() const { return profile_; }
  [[nodiscard]] double allowance() const { return allowance_; }

  /// Samples a side of the blocks that are looked at together.
  static constexpr int block_side = 8;

  /// -tip as a Field of x and y: its contours at level -z are the places where the tip is at z (a waterline), the loops' left
  /// side where it cannot be as low. Keeps what it needs alive.
  static FieldPtr field(std::shared_ptr<const TipSurface> tips);

 private:
  struct Search;
  /// No more than the profile's height at any distance from the axis whose square is at least `squared`.
  [[nodiscard]] double least_height(double squared) const {
    return least_heights_[static_cast<std::size_t>(squared * per_square_)];
  }
  void edge_contacts(const Vec2& p, double around, Contact& best) const;

  std::shared_ptr<const Surface> surface_;
  Profile profile_;  // grown by the allowance
  double allowance_;
  FlatCornerCone closed_form_;
  std::vector<double> least_heights_;  // by the square of the distance from the axis
  double per_square_ = 0;
  static constexpr std::size_t block_level = 3;  // of tops_: the squares that are blocks
  [[nodiscard]] std::size_t block_index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(blocks_wide_) + static_cast<std::size_t>(column);
  }
  [[nodiscard]] const float* block(int column, int row) const {
    return blocks_.data() + block_index(column, row) * block_side * block_side;
  }
  [[nodiscard]] bool has_fine(int column, int row) const { return has_fine_[block_index(column, row)] != 0; }
  void lay_out_blocks();
  int blocks_wide_ = 0;
  std::vector<float> blocks_;  // the samples, block by block
  std::vector<std::uint8_t> has_fine_;
  std::vector<HeightMap> tops_;  // the greatest height in squares of 1, 2, 4 ... cells
};

}  // namespace fieldfab::cam
