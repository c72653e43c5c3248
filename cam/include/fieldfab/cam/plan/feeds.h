/// Feeds by the material that each move removes: slower in corners, faster where there is little of it or none.
#pragma once

#include <string>
#include <vector>

#include "fieldfab/cam/plan/planes.h"
#include "fieldfab/cam/plan/program.h"
#include "fieldfab/cam/stock/stock.h"

namespace fieldfab::cam {

class TomlTable;

/// How far feeds may be changed, in parts of the planned feed.
struct FeedLimits {
  double least = 0.4, most = 2.5;
};

/// Returns the limits of a job's table [feeds]. Throws Error(bad_input) at the key.
FeedLimits feed_limits_of(const TomlTable& table);

/// Throws Error(bad_input) for limits that mean nothing.
void require_possible(const FeedLimits& limits, const std::string& place_of_least = "feeds",
                      const std::string& place_of_most = "feeds");

/// Material that an operation removes.
struct FeedReport {
  /// Cross-section of the removed material at which the planned feed stays: nine tenths of the way in material have at
  /// most that, mm^2.
  double usual = 0;
  double rate_before = 0, rate_after = 0;  ///< greatest removal rate with planned and with adjusted feeds, mm^3/min
};

/// The stock of a job, cut as the simulation cuts it, so that what each move removes is known. (Tools cut PlannedStock
/// thinner than they are.)
class MeasuredStock {
 public:
  explicit MeasuredStock(Stock start) : stock_(std::move(start)) {}

  /// Executes moves in a plane's coordinates and returns them with other feeds, along the same way; long moves are
  /// divided where the material changes. `width`: width of cut that the operation is planned for, mm. Chips become as
  /// thick as they are at that width: a narrower cut has thinner ones, and a wider one removes no more per minute than
  /// usual. Descents keep their feeds in material. Throws cancelled.
  std::vector<Move> adjust(const std::vector<Move>& moves, const Tool& tool, const Plane& plane, double width,
                           const FeedLimits& limits, FeedReport& report, Progress& progress = Progress::none());

 private:
  struct Piece;
  std::vector<Piece> measure(const std::vector<Move>& moves, const Tool& tool, const Plane& plane, Progress& progress);

  Stock stock_;
};

}  // namespace fieldfab::cam
