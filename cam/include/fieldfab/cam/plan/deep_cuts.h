/// Tools that are too short for a cut (Keeter 6.9): how far they go, and what stays.
#pragma once

#include <optional>
#include <utility>
#include <vector>

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

/// The stock while a job is planned, cut as the simulation cuts it. Shanks keep a lattice cell away from material, so
/// that a finer simulation finds them clear, too.
class DeepCuts {
 public:
  explicit DeepCuts(Stock stock) : stock_(std::move(stock)) {}
  /// A full box, with cells as a simulation has them where nothing else is asked for.
  explicit DeepCuts(const Box& stock) : DeepCuts(Stock(stock, {.cell = StockSettings::usual_cell(stock)})) {}

  /// Carries out moves in a plane's coordinates as they are.
  void cut(const std::vector<Move>& moves, const Tool& tool, const Plane& plane, Progress& progress = Progress::none());
  /// Executes moves whose tool is orthogonal to the plane. Where the shank would meet material, the tip goes only as
  /// deep as the flutes allow; `plunge` is the speed at which it comes down again, mm/min. Passes that then cut only
  /// air are omitted. Throws cancelled.
  std::vector<Move> back_out(const std::vector<Move>& moves, const Tool& tool, const Plane& plane, double plunge,
                             BackedOut& report, Progress& progress = Progress::none());

  [[nodiscard]] const Stock& stock() const { return stock_; }

 private:
  Stock stock_;
};

/// Whether shank or holder come into a stock's box at all; without sizes of them they do not.
bool may_be_too_deep(const std::vector<Move>& moves, const Tool& tool, const Plane& plane, const Box& stock);

}  // namespace fieldfab::cam
