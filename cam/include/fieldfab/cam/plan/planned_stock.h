/// The stock of a job while it is planned: the one model of what is left, for all planes and set-ups.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "fieldfab/cam/plan/material.h"
#include "fieldfab/cam/plan/planes.h"
#include "fieldfab/cam/plan/program.h"
#include "fieldfab/cam/stock/stock.h"
#include "fieldfab/core/progress.h"

namespace fieldfab::cam {

/// How an operation's moves became higher than planned, in its plane's coordinates.
struct BackedOut {
  double length = 0;  ///< of the way along which they did, mm
  double most = 0;    ///< the greatest rise, mm
  /// Box of the planned places of the tip there; not valid() where there are none.
  Box places{Vec3::Constant(1e300), Vec3::Constant(-1e300)};
  double left = 0;             ///< volume that stays because of it, mm^3
  std::optional<Vec3> holder;  ///< place of the tip where the holder meets material; the moves are then of no use
};

/// The stock that operations cut one after the other, on the lattice of the simulation. Tools cut it thinner, across
/// their axes, by half a lattice cell's diagonal, so that what stands between two passes is never lost between lattice
/// lines; their floors are exact.
class PlannedStock {
 public:
  /// A full box, with cells of edge `cell`, mm.
  PlannedStock(const Box& box, double cell);
  /// What an earlier job left, on its own lattice.
  explicit PlannedStock(Stock start);

  /// Executes the feeds of moves in a plane's coordinates. Throws cancelled.
  void cut(const std::vector<Move>& moves, const Tool& tool, const Plane& plane, Progress& progress = Progress::none());
  /// Executes moves whose tool is orthogonal to the plane. Where the shank would meet material, the tip goes only as
  /// deep as the flutes allow; `plunge` is the speed at which it comes down again, mm/min. Passes that then cut only
  /// air are omitted. Shanks keep a lattice cell away from material, so that a finer simulation finds them clear, too.
  /// A box with cells larger than a simulation's is cut anew with those of a simulation first. Throws cancelled.
  std::vector<Move> back_out(const std::vector<Move>& moves, const Tool& tool, const Plane& plane, double plunge,
                             BackedOut& report, Progress& progress = Progress::none());

  /// Returns the material as seen from a plane. Heights are never too low, except over material between cuts from
  /// different directions that is thinner than a lattice cell.
  [[nodiscard]] Material seen_from(const Plane& plane, Progress& progress = Progress::none()) const;
  [[nodiscard]] const Stock& stock() const { return stock_; }

 private:
  struct Done {
    std::vector<Move> moves;
    Tool tool;
    Plane plane;
  };
  std::uint32_t next_cut(const std::vector<Move>& moves, const Plane& plane);
  void refine(Progress& progress);

  Stock stock_;
  bool saved_ = false;
  std::vector<Done> done_;  // to cut it anew with smaller cells; empty once that is done
  std::vector<Vec3> axes_;  // of each cut's tool; zero if it changes
};

/// Whether shank or holder come into a stock's box at all; without sizes of them they do not.
bool may_be_too_deep(const std::vector<Move>& moves, const Tool& tool, const Plane& plane, const Box& stock);

}  // namespace fieldfab::cam
