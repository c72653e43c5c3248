/// Simulated stock: a multidirectional height map (a generalized dexel model; Hahn 2010) from which tools remove
/// material.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fieldfab/cam/base/tool_solid.h"
#include "fieldfab/cam/stock/lattice.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab::cam {

/// A criterion for the choice of a split plane (Hahn 3.3 and 6.2).
enum class SplitRule : std::uint8_t {
  closest_toolcut_direction,  ///< CTD: the plane nearest to the tool's direction
  split_plane_type,           ///< SPT: complete planes first, then single direct ones, then others
  furthest_from_side,         ///< FFS: the plane farthest from the nearest side of the cell
  far_enough_from_side,       ///< FEFS: planes farther from both sides than the tool's radius
  far_enough_then_furthest,   ///< FEFS-FFS: FEFS, then FFS on a tie
  random_selection,           ///< RS: a random choice
};
/// Parses a list such as "FEFS-FFS, CTD, SPT, RS". Throws Error(bad_input).
std::vector<SplitRule> parse_split_rules(const std::string& text);

/// Parameters of simulated stock.
struct StockSettings {
  double cell = 0.1;       ///< sample spacing, mm
  double cell_height = 0;  ///< sample spacing along z if larger, mm: for sheets with vertical cuts only
  double tolerance = 0;    ///< tolerance of swept surfaces, mm; 0: a fiftieth of a cell
  /// edge of the bricks into which the stock is divided, in lattice points; 0: one brick
  int brick = 64;
  /// whether columns may vary at their lower ends as well (Hahn 7.4); otherwise conflicts of sign split cells
  bool both_ends = true;
  std::vector<SplitRule> rules{SplitRule::far_enough_then_furthest, SplitRule::closest_toolcut_direction,
                               SplitRule::split_plane_type, SplitRule::random_selection};

  /// A cell for a box: a fifth of a millimetre, or less where that leaves fewer than 300 cells along its longest side.
  [[nodiscard]] static double usual_cell(const Box& box) { return std::clamp(box.size().maxCoeff() / 300, 0.005, 0.2); }
};

/// A linear motion of a tool piece between two poses, in part coordinates.
struct Stroke {
  const ToolPiece* piece = nullptr;
  ToolPose from, to;
  std::uint32_t cut = 1;  ///< number that samples store, chosen by the caller, above 0
  bool removes = true;    ///< true: removes material; false: only measures what would be removed
};

/// Result of a stroke.
struct StrokeResult {
  double volume = 0;          ///< volume of material removed or met, mm^3
  std::uint64_t points = 0;   ///< number of lattice points in that volume
  Vec3 place = Vec3::Zero();  ///< a place in that volume, one of these points if there are any; part coordinates, mm
};

/// A place where the surface crosses an edge of the lattice, from a solid point to one of air. Part coordinates, mm.
struct StockCrossing {
  Vec3 solid = Vec3::Zero();  ///< the solid point
  Vec3 place = Vec3::Zero();  ///< the crossing, on the edge; at the stock's box the solid point itself
  int axis = 0;               ///< axis of the edge
  bool upwards = false;       ///< whether the air lies in the axis's positive direction
  std::uint32_t cut = 0;      ///< number of the cut that made it; 0: the first surface
};

/// Statistics of a stock's structure.
struct StockStatistics {
  /// numbers of cells, of splits, and of splits by kind
  std::uint64_t cells = 0, splits = 0, direct = 0, indirect = 0, conflict = 0, halved = 0;
  std::uint64_t column_samples = 0, embedded_samples = 0;
  std::uint64_t bytes = 0;
};

/// What a mesh has where surfaces of two cuts meet, or two facets of one.
enum class StockEdges : std::uint8_t {
  sharp,    ///< vertices on the edge and in its corners
  sampled,  ///< only vertices at samples, which cut edges off by less than a cell: for pictures of a playback
};

class Brick;
class StockBytes;
class StrokeLog;
class Sweep;
struct Region;

/// A block of material. Copies share unchanged bricks, so that a copy is a cheap checkpoint.
class Stock {
 public:
  /// A solid box.
  explicit Stock(const Box& box, const StockSettings& settings = {});
  /// The part of a Field inside a box. Throws Error(cancelled).
  Stock(const Field& field, const Box& box, const StockSettings& settings = {}, Progress& progress = Progress::none());
  Stock(const Stock&);
  Stock(Stock&&) noexcept;
  Stock& operator=(const Stock&);
  Stock& operator=(Stock&&) noexcept;
  ~Stock();

  [[nodiscard]] const StockLattice& lattice() const { return lattice_; }
  [[nodiscard]] const StockSettings& settings() const { return settings_; }
  /// Tolerance of swept surfaces, mm.
  [[nodiscard]] double tolerance() const {
    return settings_.tolerance > 0 ? settings_.tolerance : lattice_.spacing().minCoeff() / 50;
  }

  /// Executes strokes in order, on all cores. Returns one result per stroke. Throws Error(cancelled) with some strokes
  /// executed in part.
  std::vector<StrokeResult> cut(std::span<const Stroke> strokes, Progress& progress = Progress::none());
  /// Whether a lattice point is solid.
  [[nodiscard]] bool solid(const Index3& point) const;
  /// Returns all crossings of the surface with edges of the lattice, by brick; outside of the box everything is air.
  /// O(points of the bricks that contain surface).
  [[nodiscard]] std::vector<std::vector<StockCrossing>> crossings(Progress& progress = Progress::none()) const;
  /// Volume by integration of the columns, mm^3.
  [[nodiscard]] double volume() const;
  /// Has no sample remember a cut: all of it is a first surface, the same otherwise.
  void forget_cuts();
  [[nodiscard]] StockStatistics statistics() const;
  /// Returns the memory that this stock does not share with another stock of the same lattice, bytes.
  [[nodiscard]] std::uint64_t bytes_unlike(const Stock& other) const;

  /// Returns the surface: closed and oriented outward. Axis-aligned flat areas made by one cut are merged: squares of
  /// up to 32 x 32 cells have one vertex. If `cuts` is not null, it receives the number of the cut that made each
  /// vertex. Edges are sharp where a stroke made at least one side, and the other side is that of a stroke or of
  /// the Field; not where it comes from a file.
  /// Throws Error(cancelled), Error(too_large).
  [[nodiscard]] TriangleMesh mesh(std::vector<std::uint32_t>* cuts = nullptr, Progress& progress = Progress::none(),
                                  StockEdges edges = StockEdges::sharp) const;

 private:
  friend class CutSurfaces;
  friend class SurfacePieces;
  friend class StockBytes;
  Stock(const StockLattice& lattice, const StockSettings& settings);
  [[nodiscard]] std::size_t brick_index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(bricks_along_[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(bricks_along_[0]) +
           static_cast<std::size_t>(x);
  }
  void divide_into_bricks();
  [[nodiscard]] std::vector<std::size_t> bricks_near(const Sweep& sweep) const;
  [[nodiscard]] Region brick_region(const Index3& brick) const;

  StockSettings settings_;
  StockLattice lattice_;
  int brick_ = 64;
  Index3 bricks_along_{1, 1, 1};
  std::vector<std::shared_ptr<Brick>> bricks_;
  FieldPtr first_;                      ///< the solid that the stock was made of; null: its box, or a file
  std::shared_ptr<StrokeLog> strokes_;  ///< that removed material; null: none
};

/// Writes a stock without loss (.fieldstock; docs/simulation.md): a stock that is read again is cut to the same bits.
/// Throws io, too_large.
void write_stock(const Stock& stock, const std::filesystem::path& path);
/// Throws io; bad_input with the path for a file that is damaged or none of these; too_large.
Stock read_stock(const std::filesystem::path& path);

}  // namespace fieldfab::cam
