#include "stroke_log.h"

#include <algorithm>

namespace fieldfab::cam {
namespace {

bool same(const ToolPiece& one, const ToolPiece& other) {
  return std::equal(one.zones.begin(), one.zones.end(), other.zones.begin(), other.zones.end(),
                    [](const Zone& a, const Zone& b) {
                      return a.shape == b.shape && a.z0 == b.z0 && a.z1 == b.z1 && a.r0 == b.r0 && a.r1 == b.r1 &&
                             a.lower_edge == b.lower_edge && a.upper_edge == b.upper_edge;
                    });
}

double upper_end(const Zone& zone) { return std::max(zone.z0, zone.z1); }

}  // namespace

void StrokeLog::add(const Stroke& stroke, const Vec3& origin) {
  const auto pose = [&](const ToolPose& at) {
    const Eigen::Vector3f tip = (at.tip - origin).cast<float>(), axis = at.axis.cast<float>();
    return Pose{tip.x(), tip.y(), tip.z(), axis.x(), axis.y(), axis.z()};
  };
  // Several pieces of one tool move alike; and a stroke begins where the one before has ended.
  const Pose from = pose(stroke.from), to = pose(stroke.to);
  const bool moves = from != to;
  const std::size_t count = poses_.size();
  const bool known =
      moves ? count > 1 && poses_[count - 2] == from && poses_[count - 1] == to : count && poses_.back() == to;
  if (!known && (!count || poses_.back() != from)) poses_.push_back(from);
  if (!known && moves) poses_.push_back(to);
  auto piece = pieces_.size();
  while (piece > 0 && !same(pieces_[piece - 1].piece, *stroke.piece)) --piece;
  if (piece == 0) {
    double radius = 0, low = stroke.piece->zones.front().z0, high = low;
    for (const Zone& zone : stroke.piece->zones)
      radius = std::max(radius, widest(zone)), low = std::min(low, zone.z0), high = std::max(high, upper_end(zone));
    pieces_.push_back({*stroke.piece, static_cast<float>(radius), static_cast<float>(low), static_cast<float>(high)});
    piece = pieces_.size();
  }
  strokes_.push_back({stroke.cut, static_cast<std::uint32_t>(poses_.size() - (moves ? 2 : 1)),
                      static_cast<std::uint16_t>(piece - 1), moves});
}

std::uint64_t StrokeLog::bytes() const {
  std::uint64_t sum = 0;
  for (const StrokeLog* part = this; part; part = part->before_.get())
    sum += sizeof(StrokeLog) + part->poses_.capacity() * sizeof(Pose) + part->strokes_.capacity() * sizeof(Record);
  return sum;
}

std::vector<StrokeLog::Ref> StrokeLog::all() const {
  std::size_t count = 0;
  for (const StrokeLog* part = this; part; part = part->before_.get()) count += part->strokes_.size();
  std::vector<Ref> refs;
  refs.reserve(count);
  for (const StrokeLog* part = this; part; part = part->before_.get())
    for (std::uint32_t i = 0; i < part->strokes_.size(); ++i) refs.push_back({part, i, part->strokes_[i].cut});
  return refs;
}

StrokeLog::Entry StrokeLog::at(const Ref& ref) {
  const auto pose = [](const Pose& at) { return ToolPose{Vec3(at[0], at[1], at[2]), Vec3(at[3], at[4], at[5])}; };
  const Record& record = ref.part->strokes_[ref.index];
  const Piece& piece = ref.part->pieces_[record.piece];
  return {piece.piece,
          pose(ref.part->poses_[record.from]),
          pose(ref.part->poses_[record.from + (record.moves ? 1 : 0)]),
          piece.radius,
          piece.low,
          piece.high};
}

}  // namespace fieldfab::cam
