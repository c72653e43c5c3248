#include "fieldfab/cam/simulate/playback.h"

#include <algorithm>

#include "fieldfab/cam/stock/cuts.h"

namespace fieldfab::cam {

void add_strokes(const ToolSolid& tool, ToolRole role, const ToolPose& from, const ToolPose& to, std::uint32_t tip,
                 bool removes, std::vector<Stroke>& strokes) {
  for (const ToolPiece& piece : tool.pieces)
    if (piece.role == role) strokes.push_back({&piece, from, to, cut_number(tip, role), removes});
}

Playback::Playback(const Stock& stock, std::uint64_t most_bytes) : copies_{{0, stock}}, most_bytes_(most_bytes) {}

std::size_t Playback::done_after_seconds(double seconds) const {
  const auto later = [](double s, const Move& move) { return s < move.seconds; };
  return static_cast<std::size_t>(std::upper_bound(moves_.begin(), moves_.end(), seconds, later) - moves_.begin());
}

std::size_t Playback::done_after_line(int line, int program) const {
  int nearest = 0;
  const auto earlier = [&](const Move& move) { return move.program < program; };
  auto done = static_cast<std::size_t>(std::count_if(moves_.begin(), moves_.end(), earlier));
  for (std::size_t i = 0; i < moves_.size(); ++i)
    if (moves_[i].program == program && moves_[i].line <= line && moves_[i].line >= nearest)
      nearest = moves_[i].line, done = i + 1;
  return done;
}

std::span<const ToolPose> Playback::poses(std::size_t index) const {
  const Strokes& strokes = strokes_.at(index);
  return std::span(poses_).subspan(strokes.first_pose, strokes.poses);
}

void Playback::add(const Move& move, const std::shared_ptr<const ToolSolid>& tool, std::uint32_t tip,
                   std::span<const ToolPose> poses) {
  if (tools_.empty() || tools_.back() != tool) tools_.push_back(tool);
  moves_.push_back(move);
  strokes_.push_back({poses_.size(), poses.size(), static_cast<std::uint32_t>(tools_.size() - 1), tip});
  poses_.insert(poses_.end(), poses.begin(), poses.end());
}

void Playback::keep(const Stock& stock) {
  if (moves_.size() < copies_.back().moves + std::max<std::size_t>(apart_, 1)) return;
  copies_.push_back({moves_.size(), stock});
  thin_out();
}

void Playback::thin_out() {
  constexpr std::size_t most = 64;
  const auto bytes = [&] {
    std::uint64_t sum = 0;
    for (std::size_t i = 1; i < copies_.size(); ++i) sum += copies_[i - 1].stock.bytes_unlike(copies_[i].stock);
    return sum;
  };
  while (copies_.size() > 2 && (copies_.size() > most || bytes() > most_bytes_)) {
    // Drops every second copy except the initial stock.
    std::vector<Copy> left;
    for (std::size_t i = 0; i < copies_.size(); i += 2) left.push_back(std::move(copies_[i]));
    copies_ = std::move(left);
    apart_ = std::max(2 * apart_, copies_.back().moves / copies_.size());
  }
}

Playback::Moment Playback::at(double seconds) const {
  Moment moment;
  moment.move = std::min(done_after_seconds(seconds), moves_.size() - 1);
  const Move &move = moves_.at(moment.move), &before = moves_[moment.move > 0 ? moment.move - 1 : 0];
  const double begin = moment.move > 0 ? before.seconds : 0;
  if (move.seconds > begin) moment.share = std::clamp((seconds - begin) / (move.seconds - begin), 0.0, 1.0);
  const std::span<const ToolPose> way = poses(moment.move);
  const double place = moment.share * static_cast<double>(way.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(place), way.size() - 1), next = std::min(i + 1, way.size() - 1);
  const double rest = place - static_cast<double>(i);
  moment.pose = {way[i].tip + rest * (way[next].tip - way[i].tip),
                 (way[i].axis + rest * (way[next].axis - way[i].axis)).normalized()};
  bool straight = false;
  for (std::size_t a = 0; a < 9; ++a) {
    moment.axes.at[a] = before.axes.at[a] + moment.share * (move.axes.at[a] - before.axes.at[a]);
    straight |= a >= 3 && a < 6 && (before.axes.at[a] != 0 || move.axes.at[a] != 0);
  }
  if (straight || way.size() < 3) return moment;
  // On an arc the axes deviate from the straight line as the tip does.
  const Vec3 off = moment.pose.tip - way.front().tip - moment.share * (way.back().tip - way.front().tip);
  for (std::size_t a = 0; a < 3; ++a) moment.axes.at[a] += off[static_cast<Eigen::Index>(a)];
  return moment;
}

void Playback::add_removing(std::size_t index, std::span<const ToolPose> way, std::vector<Stroke>& strokes) const {
  for (std::size_t k = 0; k < way.size(); ++k) {
    if (k + 1 == way.size() && k > 0) break;
    const ToolPose &from = way[k], &to = way[std::min(k + 1, way.size() - 1)];
    add_strokes(tool(index), ToolRole::cutting, from, to, strokes_[index].tip, true, strokes);
    add_strokes(tool(index), ToolRole::shank, from, to, strokes_[index].tip, true, strokes);
  }
}

const Playback::Copy& Playback::nearest(std::size_t moves) const {
  const auto later = [](std::size_t m, const Copy& copy) { return m < copy.moves; };
  return *(std::upper_bound(copies_.begin(), copies_.end(), moves, later) - 1);
}

const Stock& Playhead::stock_after(std::size_t moves, Progress& progress) {
  moves = std::min(moves, playback_->moves());
  const Playback::Copy& nearest = playback_->nearest(moves);
  if (shown_.moves > moves || shown_.moves < nearest.moves) shown_ = nearest;
  constexpr std::size_t most_at_once = 4096;
  std::vector<Stroke> strokes;
  const std::size_t begin = shown_.moves;
  try {
    for (std::size_t i = begin; i < moves; ++i) {
      playback_->add_removing(i, playback_->poses(i), strokes);
      if (strokes.size() < most_at_once && i + 1 < moves) continue;
      shown_.stock.cut(strokes, progress);
      shown_.moves = i + 1;
      strokes.clear();
      progress.report(static_cast<double>(i + 1 - begin) / static_cast<double>(moves - begin),
                      "going to another moment");
    }
  } catch (...) {
    shown_ = nearest;  // strokes may have been executed partly
    throw;
  }
  return shown_.stock;
}

Stock Playhead::stock_at(double seconds, Progress& progress) {
  const std::size_t done = playback_->done_after_seconds(seconds);
  Stock stock = stock_after(done, progress);
  if (done >= playback_->moves()) return stock;
  const Playback::Moment moment = playback_->at(seconds);
  const std::span<const ToolPose> whole = playback_->poses(moment.move);
  const auto passed = static_cast<std::ptrdiff_t>(moment.share * static_cast<double>(whole.size() - 1)) + 1;
  std::vector<ToolPose> way(whole.begin(), whole.begin() + passed);
  way.push_back(moment.pose);
  std::vector<Stroke> strokes;
  playback_->add_removing(moment.move, way, strokes);
  stock.cut(strokes, progress);
  return stock;
}

}  // namespace fieldfab::cam
