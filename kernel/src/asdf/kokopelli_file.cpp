// kokopelli's .asdf files, version 2.0 (layout: shared/data/SOURCES.txt, docs/asdf-format.md).
#include <bit>
#include <map>

#include "asdf_file.h"
#include "byte_reader.h"

namespace fieldfab {
namespace {

/// Reads kokopelli's tree, depth first. The distance of a corner is stored with the first cell that
/// has the corner; later cells look it up by position.
class KokopelliReader {
 public:
  KokopelliReader(ByteReader& reader, float scale, const std::filesystem::path& path)
      : reader_(reader), scale_(scale), path_(path) {}

  BuildCell cell(const LatticeRange& range) {
    BuildCell made;
    const auto kind = reader_.take<char>();
    if (kind == 'F' || kind == 'E' || kind == 'L') {
      made.kind = kind == 'F' ? CellKind::filled : kind == 'E' ? CellKind::empty : CellKind::leaf;
      for (unsigned corner = 0; corner < 8; ++corner) {
        // kokopelli numbers corners with x as 4, y as 2, z as 1; here x is 1, y is 2, z is 4.
        const unsigned ours = (corner >> 2 & 1U) | (corner & 2U) | (corner & 1U) << 2;
        made.corners[ours] = distance({range.first[0] + static_cast<int>(corner >> 2 & 1U) * range.count[0],
                                       range.first[1] + static_cast<int>(corner >> 1 & 1U) * range.count[1],
                                       range.first[2] + static_cast<int>(corner & 1U) * range.count[2]});
      }
      return made;
    }
    if (kind != 'B') damaged(path_, "an unknown kind of cell");
    const auto children = reader_.take<std::uint8_t>();
    unsigned axes = 0;
    for (unsigned child = 0; child < 8; ++child)
      if ((children >> child & 1U) != 0) axes |= (child >> 2 & 1U) | (child & 2U) | (child & 1U) << 2;
    std::uint8_t expected = 0;
    for (unsigned child = 0; child < 8; ++child)
      if ((((child >> 2 & 1U) | (child & 2U) | (child & 1U) << 2) & ~axes) == 0)
        expected = static_cast<std::uint8_t>(expected | 1U << child);
    if (children != expected || axes == 0 || (axes & ~range.divisible()) != 0)
      damaged(path_, "a branch with children that do not fit it");
    made.kind = CellKind::branch;
    made.axes = axes;
    made.children.resize(std::size_t{1} << std::popcount(axes));
    for (unsigned child = 0; child < 8; ++child) {
      if ((children >> child & 1U) == 0) continue;
      unsigned number = 0, bit = 0;
      for (unsigned axis = 0; axis < 3; ++axis)
        if ((axes >> axis & 1U) != 0) number |= (child >> (2 - axis) & 1U) << bit++;
      made.children[number] = cell(range.child(axes, number));
    }
    return made;
  }

 private:
  float distance(const std::array<int, 3>& corner) {
    const auto [at, is_new] = known_.try_emplace(corner, 0.0F);
    if (is_new) at->second = static_cast<float>(reader_.take<std::int16_t>()) / scale_;
    return at->second;
  }

  ByteReader& reader_;
  float scale_;
  const std::filesystem::path& path_;
  std::map<std::array<int, 3>, float> known_;
};

}  // namespace

AsdfFile::Contents AsdfFile::from_kokopelli(std::string_view bytes, const std::filesystem::path& path) {
  ByteReader reader(bytes, path);
  reader.take<std::array<char, 4>>();
  if (reader.take<std::uint8_t>() != 2 || reader.take<std::uint8_t>() != 0)
    damaged(path, "not version 2.0 of kokopelli's format");
  Box region;
  for (int axis = 0; axis < 3; ++axis) {
    region.lower[axis] = reader.take<float>();
    region.upper[axis] = reader.take<float>();
  }
  const auto lattice = reader.take<std::array<int, 3>>();
  const auto scale = reader.take<float>();
  if (!region.valid() || !std::isfinite(scale) || scale <= 0) damaged(path, "its region or scale is not a number");
  for (const int n : lattice)
    if (n < 0 || n > 1 << 24) damaged(path, "its lattice is not possible");
  const LatticeRange all{{0, 0, 0}, {std::max(lattice[0], 1), std::max(lattice[1], 1), std::max(lattice[2], 1)}};
  const BuildCell root = KokopelliReader(reader, scale, path).cell(all);
  if (reader.left() != 0) damaged(path, "bytes follow the last cell");
  return {region, lattice, 0, Eigen::Affine3d::Identity(), packed(root)};
}

}  // namespace fieldfab
