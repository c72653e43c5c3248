/// What a simulation did, so that any moment of it can be shown again.
#pragma once

#include <memory>
#include <vector>

#include "fieldfab/cam/gcode/motion.h"
#include "fieldfab/cam/stock/stock.h"

namespace fieldfab::cam {

/// The moves of a program as they were carried out, with copies of the stock from time to time: any moment is as near as the last
/// copy before it. A Playhead goes there.
class Playback {
 public:
  struct Move {
    int line = 0;  ///< of the program
    int tool = 0;  ///< its number
    bool rapid = false;
    double seconds = 0;  ///< on the machine, from the program's beginning to this move's end
    AxisValues axes{};   ///< where the machine's axes stand at its end
    int program = 0;     ///< of several in a row
  };
  /// What the machine does at a moment.
  struct Moment {
    std::size_t move = 0;  ///< the move that is going on; after the last one, that
    double share = 1;      ///< how much of it is done, from 0 to 1
    ToolPose pose;         ///< part coordinates
    AxisValues axes;       ///< on an arc while rotary axes are turned: as if it were straight
  };

  /// Begins with a stock that nothing has cut yet. Copies take up to `most_bytes` besides.
  explicit Playback(const Stock& stock, std::uint64_t most_bytes = 512 << 20);

  [[nodiscard]] std::size_t moves() const { return moves_.size(); }
  [[nodiscard]] const Move& move(std::size_t index) const { return moves_.at(index); }
  /// How many moves are done after so many seconds, and after a program's last word of a line; where it has no moves, of the one
  /// before it.
  [[nodiscard]] std::size_t done_after_seconds(double seconds) const;
  [[nodiscard]] std::size_t done_after_line(int line, int program = 0) const;
  /// The poses that a move's tool passes, evenly from one to the next; the first one is where it comes from, where that is known.
  [[nodiscard]] std::span<const ToolPose> poses(std::size_t index) const;
  /// The whole tool of a move.
  [[nodiscard]] const ToolSolid& tool(std::size_t index) const { return *tools_[strokes_.at(index).tool]; }

  /// Where the tool and the axes are so many seconds after the program's beginning. There has to be a move.
  [[nodiscard]] Moment at(double seconds) const;

  /// A stock as it was when so many moves were done.
  struct Copy {
    std::size_t moves = 0;
    Stock stock;
  };
  /// The last copy that is no later.
  [[nodiscard]] const Copy& nearest(std::size_t moves) const;
  /// Adds the strokes that take material away while the tool of a move goes along `way`.
  void add_removing(std::size_t index, std::span<const ToolPose> way, std::vector<Stroke>& strokes) const;

  /// Remembers a move that is carried out now. `tip`: the number of its cut by the tool's cutting part.
  void add(const Move& move, const std::shared_ptr<const ToolSolid>& tool, std::uint32_t tip, std::span<const ToolPose> poses);
  /// Tells how the stock looks after all moves so far.
  void keep(const Stock& stock);

 private:
  struct Strokes {
    std::size_t first_pose = 0, poses = 0;
    std::uint32_t tool = 0, tip = 0;
  };
  void thin_out();

  std::vector<Move> moves_;
  std::vector<Strokes> strokes_;  ///< of each move
  std::vector<ToolPose> poses_;
  std::vector<std::shared_ptr<const ToolSolid>> tools_;
  std::vector<Copy> copies_;  ///< by rising moves; the first one is the blank
  std::size_t apart_ = 0;     ///< moves between copies, at least
  std::uint64_t most_bytes_;
};

/// A place in a playback, from where the next moment is not far.
class Playhead {
 public:
  explicit Playhead(std::shared_ptr<const Playback> playback) : playback_(std::move(playback)), shown_(playback_->nearest(0)) {}
  [[nodiscard]] const Playback& playback() const { return *playback_; }

  /// The stock when so many moves are done; it stays until the next call. Throws cancelled.
  const Stock& stock_after(std::size_t moves, Progress& progress = Progress::none());
  /// The stock at a moment, in the middle of a move mostly. Throws cancelled.
  Stock stock_at(double seconds, Progress& progress = Progress::none());

 private:
  std::shared_ptr<const Playback> playback_;
  Playback::Copy shown_;
};

/// Adds the strokes of a tool's pieces with one role between two poses. They point into the tool. `tip`: the number of the cut by
/// its cutting part.
void add_strokes(const ToolSolid& tool, ToolRole role, const ToolPose& from, const ToolPose& to, std::uint32_t tip, bool removes,
                 std::vector<Stroke>& strokes);

}  // namespace fieldfab::cam
