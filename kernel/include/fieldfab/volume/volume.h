/// Volumes: densities on a lattice, such as CT scans (Keeter chapter 5).
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

/// Sample type of a file.
enum class SampleType : std::uint8_t { uint8, int8, uint16, int16, uint32, int32, float32, float64 };
/// Returns the number of bytes per sample.
std::size_t size_of(SampleType type);
/// Returns the name in file names and options: uint8, int16, float32 and so on.
std::string_view name(SampleType type);
/// Returns the type of a name, including u8, ushort, float and double; std::nullopt for an unknown name.
std::optional<SampleType> sample_type(std::string_view name);

/// Positions of samples: sample (i, j, k) is at origin + axes * (i, j, k) * spacing.
struct SampleLattice {
  std::array<int, 3> size{};    ///< number of samples along each axis, at least 2
  Vec3 spacing = Vec3::Ones();  ///< spacing along each axis, mm
  Vec3 origin = Vec3::Zero();   ///< position of the first sample, mm
  /// unit direction vectors as columns, not necessarily orthogonal
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();

  /// Number of samples in one slice of constant z.
  [[nodiscard]] std::size_t slice() const {
    return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]);
  }
  /// Number of samples.
  [[nodiscard]] std::size_t count() const { return slice() * static_cast<std::size_t>(size[2]); }
  /// Extent of the samples along the lattice's own axes, mm; in model space if the lattice is straight().
  [[nodiscard]] Box box() const;
  /// Map from the coordinates of box() to model space.
  [[nodiscard]] Eigen::Affine3d placement() const;
  /// Whether the axes are x, y and z, so that placement() is the identity.
  [[nodiscard]] bool straight() const { return axes.isIdentity(0); }
};

/// A volume readable by slices: in memory, memory-mapped, or in its own files. Several threads may read at the same
/// time.
class Volume {
 public:
  virtual ~Volume() = default;
  [[nodiscard]] const SampleLattice& lattice() const { return lattice_; }
  [[nodiscard]] SampleType type() const { return type_; }
  /// Threshold stated by the file, such as 0 for a level set; std::nullopt: none.
  [[nodiscard]] std::optional<double> own_threshold() const { return own_threshold_; }

  /// Writes the densities of `count` slices from `first` on: x fastest, then y, then z. Throws Error(io), or
  /// Error(bad_input) for a damaged file.
  virtual void read(int first, int count, float* out) const = 0;

 protected:
  Volume(SampleLattice lattice, SampleType type, std::optional<double> own_threshold = {})
      : lattice_(std::move(lattice)), type_(type), own_threshold_(own_threshold) {}
  SampleLattice lattice_;
  SampleType type_;
  std::optional<double> own_threshold_;
};
using VolumePtr = std::shared_ptr<const Volume>;

/// Returns a volume in memory; `type` states the sample type of its origin. Throws Error(bad_input) for an invalid
/// lattice or a wrong number of densities.
VolumePtr volume_of(std::vector<float> densities, const SampleLattice& lattice,
                    std::optional<double> own_threshold = {}, SampleType type = SampleType::float32);
/// Returns the samples first .. first + count - 1 along each axis.
VolumePtr cropped(VolumePtr volume, const std::array<int, 3>& first, const std::array<int, 3>& count);
/// Returns the samples reordered so that the axes become x, y and z, if possible; otherwise `volume` itself.
VolumePtr straightened(VolumePtr volume);
/// Returns the next coarser level: every second sample along each axis, smoothed with weights 1 2 1 along each axis.
VolumePtr halved(VolumePtr volume);
/// Returns the same samples with another spacing, mm.
VolumePtr respaced(VolumePtr volume, const Vec3& spacing);

/// Returns all densities, x fastest. Throws Error(too_large) if they exceed the memory, Error(cancelled).
std::vector<float> read_all(const Volume& volume, Progress& progress = Progress::none());

/// Parts that for_slices() makes at most.
inline constexpr std::size_t most_slice_parts = 64;
/// Calls body(part, k, densities) for each slice k: parts, of slices that follow each other, in parallel, and the
/// slices of a part one after the other. Each part has one slice in memory, and all together at most `bytes` bytes, but
/// there is at least one part. `what` describes the work in progress reports. Throws Error(cancelled).
void for_slices(const Volume& volume, std::size_t bytes, Progress& progress, const std::string& what,
                const std::function<void(std::size_t part, std::size_t k, const float* densities)>& body);

}  // namespace fieldfab
