/// The strokes that a stock was cut with, from which the exact surface at a sample follows.
#pragma once

#include <memory>
#include <vector>

#include "fieldfab/cam/stock/stock.h"

namespace fieldfab::cam {

/// A part of a stock's strokes: 12 bytes a stroke, and 24 bytes a pose, which consecutive strokes share. A log is a
/// chain of these, the last part first. Copies of a stock share the parts that were complete when it was copied.
class StrokeLog {
 public:
  explicit StrokeLog(std::shared_ptr<const StrokeLog> before) : before_(std::move(before)) {}
  StrokeLog(const StrokeLog&) = delete;
  StrokeLog& operator=(const StrokeLog&) = delete;

  /// Whether a new part should follow.
  [[nodiscard]] bool full() const { return strokes_.size() >= 4096; }
  /// Adds a stroke; `origin` is the corner of the stock's box.
  void add(const Stroke& stroke, const Vec3& origin);
  /// Bytes of this part and all parts before it.
  [[nodiscard]] std::uint64_t bytes() const;

  /// A stroke's place in the log, and the cut that it belongs to.
  struct Ref {
    const StrokeLog* part;
    std::uint32_t index, cut;
  };
  /// All strokes, in no order.
  [[nodiscard]] std::vector<Ref> all() const;

  /// A stroke, relative to the corner of the stock's box.
  struct Entry {
    const ToolPiece& piece;
    ToolPose from, to;
    float radius, low, high;  ///< of the piece: greatest radius, ends of its axis
  };
  [[nodiscard]] static Entry at(const Ref& ref);

 private:
  using Pose = std::array<float, 6>;  // tip and axis
  struct Piece {
    ToolPiece piece;
    float radius, low, high;
  };
  struct Record {
    std::uint32_t cut, from;
    std::uint16_t piece;
    bool moves;  ///< whether the stroke ends at the pose after `from`
  };

  std::shared_ptr<const StrokeLog> before_;
  std::vector<Piece> pieces_;
  std::vector<Pose> poses_;
  std::vector<Record> strokes_;
};

}  // namespace fieldfab::cam
