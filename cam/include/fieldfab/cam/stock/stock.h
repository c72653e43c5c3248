/// Simulated stock: a multidirectional heightmap (Hahn 2010) that tools cut.
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

/// A rule that prefers some split planes to others (Hahn 3.3 and 6.2).
enum class SplitRule : std::uint8_t {
  closest_toolcut_direction,  ///< CTD: the plane nearest to the tool's direction
  split_plane_type,           ///< SPT: complete ones, then direct ones that are alone, then the rest
  furthest_from_side,         ///< FFS: the plane whose nearest side of the cell is furthest
  far_enough_from_side,       ///< FEFS: those further from both sides than the tool's radius
  far_enough_then_furthest,   ///< FEFS-FFS: FEFS; FFS where that does not tell them apart
  random_selection,           ///< RS
};
/// "FEFS-FFS, CTD, SPT, RS" and the like. Throws bad_input.
std::vector<SplitRule> parse_split_rules(const std::string& text);

struct StockSettings {
  double cell = 0.1;       ///< distance of samples, mm
  double cell_height = 0;  ///< along z, where it is larger, mm: for sheets in which every cut is the same all through
  double tolerance = 0;    ///< of swept surfaces, mm; 0: a fiftieth of a cell
  int brick = 64;  ///< points along the edges of the cubes into which the stock is divided beforehand; 0: one for all of it
  bool both_ends = true;  ///< columns may have a varying lower end as well (Hahn 7.4); else conflicts of sign split cells
  std::vector<SplitRule> rules{SplitRule::far_enough_then_furthest, SplitRule::closest_toolcut_direction,
                               SplitRule::split_plane_type, SplitRule::random_selection};

  /// A cell for a box: a fifth of a millimetre, or less where that leaves fewer than 300 cells along its longest side.
  [[nodiscard]] static double usual_cell(const Box& box) { return std::clamp(box.size().maxCoeff() / 300, 0.005, 0.2); }
};

/// A piece of a tool moving evenly from one pose to another, in the part's coordinates.
struct Stroke {
  const ToolPiece* piece = nullptr;
  ToolPose from, to;
  std::uint32_t cut = 1;  ///< what samples remember: a number of the caller's choice, above 0
  bool removes = true;    ///< else it is only asked what it would remove
};

/// What a stroke met.
struct StrokeResult {
  double volume = 0;          ///< of material removed (or met), mm^3
  std::uint64_t points = 0;   ///< lattice points in it
  Vec3 place = Vec3::Zero();  ///< one of them
};

/// How a stock is made up.
struct StockStatistics {
  std::uint64_t cells = 0, splits = 0, direct = 0, indirect = 0, conflict = 0, halved = 0;  ///< splits in all, and by kind
  std::uint64_t column_samples = 0, embedded_samples = 0;
  std::uint64_t bytes = 0;
};

class Brick;
class StockBytes;
class Sweep;
struct Region;

/// A block of material. Copies share what they have in common: a copy is a checkpoint.
class Stock {
 public:
  /// A full box.
  explicit Stock(const Box& box, const StockSettings& settings = {});
  /// The part of a Field inside of a box. Throws cancelled.
  Stock(const Field& field, const Box& box, const StockSettings& settings = {}, Progress& progress = Progress::none());
  Stock(const Stock&);
  Stock(Stock&&) noexcept;
  Stock& operator=(const Stock&);
  Stock& operator=(Stock&&) noexcept;
  ~Stock();

  [[nodiscard]] const StockLattice& lattice() const { return lattice_; }
  [[nodiscard]] const StockSettings& settings() const { return settings_; }
  [[nodiscard]] double tolerance() const {
    return settings_.tolerance > 0 ? settings_.tolerance : lattice_.spacing().minCoeff() / 50;
  }

  /// Carries out strokes in their order, on all cores. Throws cancelled, with some of them carried out in part.
  std::vector<StrokeResult> cut(std::span<const Stroke> strokes, Progress& progress = Progress::none());
  /// Whether a lattice point is solid.
  [[nodiscard]] bool solid(const Index3& point) const;
  /// Volume by the columns, mm^3.
  [[nodiscard]] double volume() const;
  /// Has no sample remember a cut: all of it is a first surface, the same otherwise.
  void forget_cuts();
  [[nodiscard]] StockStatistics statistics() const;
  /// How much memory it takes beside another stock of the same lattice, which may share most of it.
  [[nodiscard]] std::uint64_t bytes_unlike(const Stock& other) const;

  /// The surface: closed, outwards. Flats that are level along an axis and that one cut left are merged: squares of up to 32 x 32
  /// cells have one vertex. `cuts`, where asked for, gets the cut that made each vertex. Throws cancelled, too_large.
  [[nodiscard]] TriangleMesh mesh(std::vector<std::uint32_t>* cuts = nullptr, Progress& progress = Progress::none()) const;

 private:
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
};

/// Writes a stock as it is (.fieldstock; docs/simulation.md). What is read again cuts on to the same bits. Throws io, too_large.
void write_stock(const Stock& stock, const std::filesystem::path& path);
/// Throws io; bad_input with the path for a file that is damaged or none of these; too_large.
Stock read_stock(const std::filesystem::path& path);

}  // namespace fieldfab::cam
