/// Recorded simulations, for display of any moment.
#pragma once

#include <memory>
#include <vector>

#include "fieldfab/cam/gcode/motion.h"
#include "fieldfab/cam/stock/stock.h"

namespace fieldfab::cam {

/// The executed moves of a program, with checkpoints of the stock. A Playhead recomputes any moment from the last
/// checkpoint before it.
class Playback {
 public:
  struct Move {
    int line = 0;  ///< line of the program
    int tool = 0;  ///< tool number
    bool rapid = false;
    double seconds = 0;  ///< machine time from the start of the program to the end of this move, seconds
    AxisValues axes{};   ///< axis positions at the end; x, y, z from the part's zero
    int program = 0;     ///< index of the program in a sequence
  };
  /// State of the machine at a moment.
  struct Moment {
    std::size_t move = 0;  ///< the current move; the last one after the end
    double share = 1;      ///< completed fraction, from 0 to 1
    ToolPose pose;         ///< pose of the tool, part coordinates
    AxisValues axes;       ///< as in Move; linear interpolation on an arc during which rotary axes move
  };

  /// Starts with an uncut stock. Checkpoints take up to `most_bytes` of memory in addition.
  explicit Playback(const Stock& stock, std::uint64_t most_bytes = 512 << 20);

  [[nodiscard]] std::size_t moves() const { return moves_.size(); }
  [[nodiscard]] const Move& move(std::size_t index) const { return moves_.at(index); }
  /// Number of moves completed at a time, and after the last word of a line. A line without moves counts as the
  /// previous line with moves.
  [[nodiscard]] std::size_t done_after_seconds(double seconds) const;
  [[nodiscard]] std::size_t done_after_line(int line, int program = 0) const;
  /// Returns the poses of a move, with uniform motion between them. The first is the start, if known. Valid until the
  /// next add().
  [[nodiscard]] std::span<const ToolPose> poses(std::size_t index) const;
  /// Returns the tool of a move; owned by this object.
  [[nodiscard]] const ToolSolid& tool(std::size_t index) const { return *tools_[strokes_.at(index).tool]; }

  /// Returns tool pose and axis positions at a time, seconds from the start. Precondition: there is a move.
  [[nodiscard]] Moment at(double seconds) const;

  /// A checkpoint: the stock after a number of moves.
  struct Copy {
    std::size_t moves = 0;
    Stock stock;
  };
  /// Returns the last checkpoint at or before that number of moves.
  [[nodiscard]] const Copy& nearest(std::size_t moves) const;
  /// Appends the removing strokes of a move's tool along the poses `way`.
  void add_removing(std::size_t index, std::span<const ToolPose> way, std::vector<Stroke>& strokes) const;

  /// Records an executed move. `tip` is the cut number of the tool's cutting part.
  void add(const Move& move, const std::shared_ptr<const ToolSolid>& tool, std::uint32_t tip,
           std::span<const ToolPose> poses);
  /// Offers the stock after all moves so far as a checkpoint.
  void keep(const Stock& stock);

 private:
  struct Strokes {
    std::size_t first_pose = 0, poses = 0;
    std::uint32_t tool = 0, tip = 0;
  };
  void thin_out();

  std::vector<Move> moves_;
  std::vector<Strokes> strokes_;  ///< one entry per move
  std::vector<ToolPose> poses_;
  std::vector<std::shared_ptr<const ToolSolid>> tools_;
  std::vector<Copy> copies_;  ///< sorted by moves; the first is the uncut stock
  std::size_t apart_ = 0;     ///< least number of moves between checkpoints
  std::uint64_t most_bytes_;
};

/// A position in a playback. Moving forward from it is cheap.
class Playhead {
 public:
  explicit Playhead(std::shared_ptr<const Playback> playback)
      : playback_(std::move(playback)), shown_(playback_->nearest(0)) {}
  [[nodiscard]] const Playback& playback() const { return *playback_; }

  /// Returns the stock after a number of moves. The reference is valid until the next call. Throws Error(cancelled).
  const Stock& stock_after(std::size_t moves, Progress& progress = Progress::none());
  /// Returns the stock at a time, usually within a move. Throws Error(cancelled).
  Stock stock_at(double seconds, Progress& progress = Progress::none());

 private:
  std::shared_ptr<const Playback> playback_;
  Playback::Copy shown_;
};

/// Appends the strokes of a tool's pieces with one role between two poses. They refer to `tool`, which must outlive
/// them. `tip` is the cut number of the cutting part.
void add_strokes(const ToolSolid& tool, ToolRole role, const ToolPose& from, const ToolPose& to, std::uint32_t tip,
                 bool removes, std::vector<Stroke>& strokes);

}  // namespace fieldfab::cam
