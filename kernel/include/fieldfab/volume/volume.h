/// Densities on a lattice: what CT scanners give (Keeter chapter 5).
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fieldfab/core/geometry.h"
#include "fieldfab/core/progress.h"

namespace fieldfab {

/// How a file keeps a density.
enum class SampleType : std::uint8_t { uint8, int8, uint16, int16, uint32, int32, float32, float64 };
/// Bytes a sample.
std::size_t size_of(SampleType type);
/// As in file names and options: uint8, int16, float32, ...
std::string_view name(SampleType type);
/// The type of that name; also u8, ushort, float, double and their like. Nothing where there is none.
std::optional<SampleType> sample_type(std::string_view name);

/// Where the samples are: sample (i, j, k) is at origin + axes * (i, j, k) * spacing.
struct SampleLattice {
  std::array<int, 3> size{};                           ///< samples along each axis, 2 or more
  Vec3 spacing = Vec3::Ones();                         ///< mm between samples along each axis
  Vec3 origin = Vec3::Zero();                          ///< the first sample's place, mm
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns: directions of length 1, not always at right angles

  [[nodiscard]] std::size_t slice() const { return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]); }
  [[nodiscard]] std::size_t count() const { return slice() * static_cast<std::size_t>(size[2]); }
  /// The samples' extent along the lattice's own axes; with its place in space where these are x, y and z.
  [[nodiscard]] Box box() const;
  /// From the coordinates of box() to space.
  [[nodiscard]] Eigen::Affine3d placement() const;
  /// Whether the axes are x, y and z, so that the placement changes nothing.
  [[nodiscard]] bool straight() const { return axes.isIdentity(0); }
};

/// A volume that can be read slice by slice: in memory, mapped, or in files of its own. Many threads may read at once.
class Volume {
 public:
  virtual ~Volume() = default;
  [[nodiscard]] const SampleLattice& lattice() const { return lattice_; }
  [[nodiscard]] SampleType type() const { return type_; }
  /// What separates solid from nothing where the file tells (a level set's 0).
  [[nodiscard]] std::optional<double> own_threshold() const { return own_threshold_; }

  /// Writes the densities of `count` slices from `first` on: x fastest, then y, then z. Throws io, or bad_input for damaged
  /// files.
  virtual void read(int first, int count, float* out) const = 0;

 protected:
  Volume(SampleLattice lattice, SampleType type, std::optional<double> own_threshold = {})
      : lattice_(std::move(lattice)), type_(type), own_threshold_(own_threshold) {}
  SampleLattice lattice_;
  SampleType type_;
  std::optional<double> own_threshold_;
};
using VolumePtr = std::shared_ptr<const Volume>;

/// Densities in memory, that were of some type where they come from. Throws bad_input where their number or the lattice is not
/// possible.
VolumePtr volume_of(std::vector<float> densities, const SampleLattice& lattice, std::optional<double> own_threshold = {},
                    SampleType type = SampleType::float32);
/// The samples first .. first + count - 1 along each axis.
VolumePtr cropped(VolumePtr volume, const std::array<int, 3>& first, const std::array<int, 3>& count);
/// The same samples in another order and lattice, if that makes its axes x, y and z; itself otherwise.
VolumePtr straightened(VolumePtr volume);
/// Every second sample along each axis, each the mean of its neighbourhood (weights 1 2 1 along each axis): the next coarser
/// level.
VolumePtr halved(VolumePtr volume);
/// The same samples at other distances.
VolumePtr respaced(VolumePtr volume, const Vec3& spacing);

/// All densities, x fastest. Throws too_large where they do not fit into memory, cancelled.
std::vector<float> read_all(const Volume& volume, Progress& progress = Progress::none());

/// Calls body(first, count, densities) for parts of the slices, in order, none larger than `bytes` of floats (one slice at
/// least); a part begins with the slice that the part before it ended with where `shared` is set. Stops when `progress` says so.
void for_slabs(const Volume& volume, std::size_t bytes, bool shared, Progress& progress, const std::string& what,
               const std::function<void(int first, int count, const float* densities)>& body);

}  // namespace fieldfab
