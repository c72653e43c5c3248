// Volumes of OpenVDB.
#include <fmt/format.h>
#include <openvdb/io/Archive.h>
#include <openvdb/io/GridDescriptor.h>
#include <openvdb/io/io.h>
#include <openvdb/tools/Dense.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fieldfab/core/file.h"
#include "volume/openvdb/float_grid.h"
#include "volume/parts.h"
#include "volume/read_in_copy.h"

namespace fieldfab {
namespace {

/// Returns how many samples a file of so many bytes may span: those of a gigabyte, or 4096 for each byte.
double most_samples(std::uintmax_t bytes) { return std::max(0x1p28, 4096.0 * static_cast<double>(bytes)); }

/// Positions of a grid's samples in a box of indices.
SampleLattice lattice_of(const openvdb::FloatGrid& grid, const openvdb::CoordBBox& box, const Path& path) {
  const openvdb::Coord dim = box.dim();
  SampleLattice lattice;
  const std::size_t samples = sample_count({dim.x(), dim.y(), dim.z()}, path);
  if (static_cast<double>(samples) > most_samples(std::filesystem::file_size(path)))
    refuse(path,
           fmt::format("its samples span {} x {} x {}, too many for a file of its size", dim.x(), dim.y(), dim.z()));
  lattice.size = {dim.x(), dim.y(), dim.z()};
  require_memory(lattice.count() * sizeof(float), path.string());
  const auto place = [&](const openvdb::Vec3d& at) {
    const openvdb::Vec3d world = grid.transform().indexToWorld(at);
    return Vec3(world.x(), world.y(), world.z());
  };
  const openvdb::Vec3d low(box.min().x(), box.min().y(), box.min().z());
  lattice.origin = place(low);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    openvdb::Vec3d next = low;
    next[static_cast<int>(axis)] += 1;
    const Vec3 step = place(next) - lattice.origin;
    lattice.spacing[axis] = step.norm();
    if (!(lattice.spacing[axis] > 0)) refuse(path, "holds a grid with an impossible transform");
    lattice.axes.col(axis) = step / lattice.spacing[axis];
  }
  if (lattice.axes.isIdentity(1e-12)) lattice.axes.setIdentity();
  return lattice;
}

struct Damaged : std::exception {};

/// Reads the first grid of 32-bit floats of a file. OpenVDB allocates what the lengths in a header ask for before it
/// reads; they are compared with the size of the file first.
class GridReader : openvdb::io::Archive {
 public:
  explicit GridReader(const Path& path) : size_(static_cast<std::streamoff>(std::filesystem::file_size(path))) {
    // A stream that throws at its end. OpenVDB continues beyond it and allocates memory for missing data.
    file_.exceptions(std::ios::failbit | std::ios::badbit | std::ios::eofbit);
    file_.open(path, std::ios::binary);
  }

  /// Returns null if there is no such grid.
  openvdb::FloatGrid::Ptr read() {
    ahead([&] {  // of a later version OpenVDB prints a warning
      skip(sizeof(std::int64_t));
      if (number() > openvdb::OPENVDB_FILE_VERSION) throw Damaged();
    });
    readHeader(file_);
    auto stream = std::make_shared<openvdb::io::StreamMetadata>();
    openvdb::io::setStreamMetadataPtr(file_, stream, false);
    openvdb::io::setVersion(file_, libraryVersion(), fileVersion());
    setDataCompression(file_);
    // Descriptors and transforms of earlier files, from 2012, have other places.
    if (fileVersion() < openvdb::OPENVDB_FILE_VERSION_NEW_TRANSFORM) throw Damaged();
    skip_metadata();
    for (auto left = number(); left > 0; --left) {
      ahead([&] { skip_texts(3); });
      openvdb::io::GridDescriptor descriptor;
      const openvdb::GridBase::Ptr grid = descriptor.read(file_);
      auto floats = openvdb::gridPtrCast<openvdb::FloatGrid>(grid);
      if (!floats && inputHasGridOffsets()) {
        go_on_to(descriptor.getEndPos());
        continue;
      }
      ahead([&] { check_grid(); });
      grids_.push_back(grid);
      readGrid(grid, descriptor, file_);
      if (floats && !descriptor.isInstance()) return floats;  // an instance has the samples of another grid
    }
    return nullptr;
  }

 private:
  template <class Check>
  void ahead(const Check& check) {
    const auto here = file_.tellg();
    check();
    file_.seekg(here);
  }
  void go_on_to(std::streamoff place) {
    if (place < file_.tellg() || place > size_) throw Damaged();
    file_.seekg(place);
  }
  std::uint32_t number() {
    std::uint32_t value = 0;
    file_.read(reinterpret_cast<char*>(&value), sizeof value);
    return value;
  }
  void skip(std::uint32_t bytes) { go_on_to(file_.tellg() + std::streamoff{bytes}); }
  void skip_texts(int count) {
    for (; count > 0; --count) skip(number());
  }
  std::string text() {
    const std::uint32_t length = number();
    ahead([&] { skip(length); });
    std::string value(length, ' ');
    file_.read(value.data(), length);
    return value;
  }
  /// Names, types and values; each value has its length before it.
  void skip_metadata() {
    for (auto left = number(); left > 0; --left) {
      skip_texts(1);
      // A table of sizes of leaves, of which each takes a mask of 64 bytes elsewhere in the file.
      if (text() == "__delayedload")
        ahead([&] {
          if (number() > 0 && number() > size_ / 64) throw Damaged();
        });
      skip_texts(1);
    }
  }
  void check_grid() {
    if (fileVersion() >= openvdb::OPENVDB_FILE_VERSION_NODE_MASK_COMPRESSION) skip(sizeof(std::uint32_t));
    skip_metadata();
    if (text() == openvdb::math::NonlinearFrustumMap::mapType()) throw Damaged();  // it holds more texts
  }

  std::streamoff size_;
  std::ifstream file_;
  std::vector<openvdb::GridBase::Ptr> grids_;  ///< all that were read: destruction of a grid uses threads
};

constexpr const char* library = "OpenVDB";

VolumePtr open(const Path& path, Progress& progress) {
  openvdb::initialize();
  std::optional<GridReader> file;  // out here, because destruction of a grid uses threads
  openvdb::FloatGrid::Ptr grid;
  const auto read = [&](const Room& room) {
    try {
      grid = file.emplace(path).read();
    } catch (const std::exception&) {
      refuse(path, "is no .vdb file, or a damaged one, or of a later version");
    }
    if (!grid) refuse(path, "holds no grid of 32-bit real numbers");
    const openvdb::CoordBBox active = grid->evalActiveVoxelBoundingBox();
    if (active.empty()) refuse(path, "holds a grid without samples");
    if (!grid->transform().isLinear()) refuse(path, "holds a grid that is not linear");
    // One sample of background on all sides, which is not solid; the surface of a level set may end
    // there.
    openvdb::CoordBBox box = active;
    box.expand(1);
    Samples samples{lattice_of(*grid, box, path)};
    float* const densities = room(samples.lattice.count());
    openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ> dense(box, densities);
    openvdb::tools::copyToDense(*grid, dense, true);  // without threads
    if (grid->getGridClass() == openvdb::GRID_LEVEL_SET) {
      std::transform(densities, densities + samples.lattice.count(), densities, std::negate());
      samples.own_threshold = 0;
    }
    return samples;
  };
  return volume_read_in_copy(path, library, read, progress);
}

}  // namespace

extern "C" const VdbVolumePart fieldfab_vdb_volume = {open};

}  // namespace fieldfab
