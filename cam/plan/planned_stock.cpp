#include "fieldfab/cam/plan/planned_stock.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "deep_cuts.h"
#include "strokes.h"

namespace fieldfab::cam {

PlannedStock::PlannedStock(const Box& box, double cell) : stock_(box, {.cell = cell}) {}

PlannedStock::PlannedStock(Stock start) : stock_(std::move(start)), saved_(true) { stock_.forget_cuts(); }

/// The number of the next cut, by moves with these axes.
std::uint32_t PlannedStock::next_cut(const std::vector<Move>& moves, const Plane& plane) {
  const bool turns = std::any_of(moves.begin(), moves.end(), [](const Move& m) { return m.axis != Vec3::UnitZ(); });
  axes_.push_back(turns ? Vec3::Zero() : Vec3(plane.axes.col(2)));
  return static_cast<std::uint32_t>(axes_.size());
}

void PlannedStock::cut(const std::vector<Move>& moves, const Tool& tool, const Plane& plane, Progress& progress) {
  const std::uint32_t number = next_cut(moves, plane);
  const StockLattice& lattice = stock_.lattice();
  // Slightly longer than the flutes, so that a cut as deep as they are leaves no skin at the top.
  constexpr double longer = 0.01;
  const double length = tool.flute > 0 ? tool.flute + longer : 2 * lattice.box().diagonal() + tool.length,
               by = half_diagonal(lattice, axes_.back());
  const std::vector<ToolPiece> pieces = thinned(tool, by, length);
  std::vector<Stroke> strokes;
  for (std::size_t k = 1; k < moves.size(); ++k) {
    if (moves[k].rapid()) continue;
    const auto pose = [&](const Vec3& tip, const Vec3& axis) { return ToolPose{plane.out_of(tip), plane.axes * axis}; };
    ToolPose from = pose(moves[k - 1].to, moves[k - 1].axis);
    for (const Vec3& end : segments(moves[k - 1].to, moves[k], std::numeric_limits<double>::infinity())) {
      const ToolPose to = pose(end, moves[k].axis);
      for (const ToolPiece& piece : pieces) strokes.push_back({&piece, from, to, number, true});
      from = to;
    }
  }
  stock_.cut(strokes, progress);
  if (!saved_ && stock_.settings().cell > StockSettings::usual_cell(lattice.box()))
    done_.push_back({moves, tool, plane});
}

/// Cuts a box anew with the cells of a simulation, if they are smaller.
void PlannedStock::refine(Progress& progress) {
  const Box box = stock_.lattice().box();
  const double usual = StockSettings::usual_cell(box);
  if (saved_ || stock_.settings().cell <= usual) return;
  stock_ = Stock(box, {.cell = usual});
  axes_.clear();
  for (const Done& done : std::exchange(done_, {})) cut(done.moves, done.tool, done.plane, progress);
}

std::vector<Move> PlannedStock::back_out(const std::vector<Move>& moves, const Tool& tool, const Plane& plane,
                                         double plunge, BackedOut& report, Progress& progress) {
  refine(progress);
  return cam::back_out(stock_, next_cut(moves, plane), moves, tool, plane, plunge, report, progress);
}

Material PlannedStock::seen_from(const Plane& plane, Progress& progress) const {
  if (axes_.empty() && !saved_) {
    const Box box = plane.into(stock_.lattice().box());
    return {Rectangle::of(box), box.upper.z(), stock_.settings().cell};
  }
  const Vec3 view = plane.axes.col(2);
  std::vector<double> slack{0};  // the first surface is exact
  bool whole = true;             // between cuts along the view nothing is missed
  for (const Vec3& axis : axes_) {
    const double across = axis.isZero() ? 1 : axis.cross(view).norm();
    whole = whole && across <= 1e-9;
    slack.push_back(across > 1e-9 ? across * half_diagonal(stock_.lattice(), axis) : 0);
  }
  return {stock_, plane, [&](std::uint32_t cut) { return slack[cut]; }, whole, progress};
}

}  // namespace fieldfab::cam
