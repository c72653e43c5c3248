#include "fieldfab/volume/volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/parallel.h"
#include "volume/readers.h"

namespace fieldfab {
namespace {

struct TypeName {
  std::string_view name;
  SampleType type;
};
/// The first name of a type is used in output.
constexpr std::array type_names{TypeName{"uint8", SampleType::uint8},     TypeName{"int8", SampleType::int8},
                                TypeName{"uint16", SampleType::uint16},   TypeName{"int16", SampleType::int16},
                                TypeName{"uint32", SampleType::uint32},   TypeName{"int32", SampleType::int32},
                                TypeName{"float32", SampleType::float32}, TypeName{"float64", SampleType::float64},
                                TypeName{"u8", SampleType::uint8},        TypeName{"8bit", SampleType::uint8},
                                TypeName{"uchar", SampleType::uint8},     TypeName{"byte", SampleType::uint8},
                                TypeName{"i8", SampleType::int8},         TypeName{"char", SampleType::int8},
                                TypeName{"u16", SampleType::uint16},      TypeName{"16bit", SampleType::uint16},
                                TypeName{"ushort", SampleType::uint16},   TypeName{"i16", SampleType::int16},
                                TypeName{"short", SampleType::int16},     TypeName{"u32", SampleType::uint32},
                                TypeName{"uint", SampleType::uint32},     TypeName{"i32", SampleType::int32},
                                TypeName{"int", SampleType::int32},       TypeName{"f32", SampleType::float32},
                                TypeName{"float", SampleType::float32},   TypeName{"f64", SampleType::float64},
                                TypeName{"double", SampleType::float64}};

}  // namespace

std::size_t size_of(SampleType type) {
  switch (type) {
    case SampleType::uint8:
    case SampleType::int8: return 1;
    case SampleType::uint16:
    case SampleType::int16: return 2;
    case SampleType::float64: return 8;
    default: return 4;
  }
}

std::string_view name(SampleType type) {
  return std::find_if(type_names.begin(), type_names.end(), [&](const TypeName& known) { return known.type == type; })
      ->name;
}

std::optional<SampleType> sample_type(std::string_view name) {
  const auto* const found =
      std::find_if(type_names.begin(), type_names.end(), [&](const TypeName& t) { return t.name == name; });
  return found == type_names.end() ? std::nullopt : std::optional(found->type);
}

Box SampleLattice::box() const {
  const Vec3 lower = straight() ? origin : Vec3::Zero();
  return {lower, lower + spacing.cwiseProduct(Vec3(size[0] - 1, size[1] - 1, size[2] - 1))};
}

Eigen::Affine3d SampleLattice::placement() const {
  Eigen::Affine3d placement = Eigen::Affine3d::Identity();
  if (straight()) return placement;
  placement.linear() = axes;
  placement.translation() = origin;
  return placement;
}

namespace {

class InMemory final : public Volume {
 public:
  InMemory(std::shared_ptr<const float> densities, const SampleLattice& lattice, std::optional<double> own_threshold,
           SampleType type)
      : Volume(lattice, type, own_threshold), densities_(std::move(densities)) {}
  void read(int first, int count, float* out) const override {
    const std::size_t slice = lattice_.slice();
    std::copy_n(densities_.get() + static_cast<std::size_t>(first) * slice, static_cast<std::size_t>(count) * slice,
                out);
  }

 private:
  std::shared_ptr<const float> densities_;
};

class Cropped final : public Volume {
 public:
  Cropped(VolumePtr whole, const std::array<int, 3>& first, const std::array<int, 3>& count)
      : Volume(whole->lattice(), whole->type(), whole->own_threshold()), whole_(std::move(whole)), first_(first) {
    lattice_.origin += lattice_.axes * lattice_.spacing.cwiseProduct(Vec3(first[0], first[1], first[2]));
    lattice_.size = count;
  }
  void read(int first, int count, float* out) const override {
    const auto width = static_cast<std::size_t>(whole_->lattice().size[0]);
    std::vector<float> slice(whole_->lattice().slice());
    for (int k = 0; k < count; ++k) {
      whole_->read(first_[2] + first + k, 1, slice.data());
      for (int j = 0; j < lattice_.size[1]; ++j, out += lattice_.size[0])
        std::copy_n(slice.data() + static_cast<std::size_t>(first_[1] + j) * width + first_[0], lattice_.size[0], out);
    }
  }

 private:
  VolumePtr whole_;
  std::array<int, 3> first_;
};

/// A volume with descending axes reversed.
class Flipped final : public Volume {
 public:
  explicit Flipped(VolumePtr other)
      : Volume(other->lattice(), other->type(), other->own_threshold()), other_(std::move(other)) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      backwards_[axis] = lattice_.axes(a, a) < 0;
      if (backwards_[axis]) lattice_.origin[a] -= (lattice_.size[axis] - 1) * lattice_.spacing[a];
    }
    lattice_.axes.setIdentity();
  }
  void read(int first, int count, float* out) const override {
    const auto width = static_cast<std::size_t>(lattice_.size[0]), height = static_cast<std::size_t>(lattice_.size[1]);
    other_->read(backwards_[2] ? lattice_.size[2] - first - count : first, count, out);
    const std::size_t slice = width * height;
    if (backwards_[2])
      for (int k = 0; k < count / 2; ++k)
        std::swap_ranges(out + static_cast<std::size_t>(k) * slice, out + static_cast<std::size_t>(k + 1) * slice,
                         out + static_cast<std::size_t>(count - 1 - k) * slice);
    for (int k = 0; k < count; ++k, out += slice) {
      if (backwards_[1])
        for (std::size_t j = 0; j < height / 2; ++j)
          std::swap_ranges(out + j * width, out + (j + 1) * width, out + (height - 1 - j) * width);
      if (backwards_[0])
        for (std::size_t j = 0; j < height; ++j) std::reverse(out + j * width, out + (j + 1) * width);
    }
  }

 private:
  VolumePtr other_;
  std::array<bool, 3> backwards_{};
};

class Respaced final : public Volume {
 public:
  Respaced(VolumePtr other, const Vec3& spacing)
      : Volume(other->lattice(), other->type(), other->own_threshold()), other_(std::move(other)) {
    lattice_.spacing = spacing;
  }
  void read(int first, int count, float* out) const override { other_->read(first, count, out); }

 private:
  VolumePtr other_;
};

class Halved final : public Volume {
 public:
  explicit Halved(VolumePtr fine)
      : Volume(fine->lattice(), SampleType::float32, fine->own_threshold()), fine_(std::move(fine)) {
    for (int& n : lattice_.size) n = (n - 1) / 2 + 1;
    lattice_.spacing *= 2;
  }
  void read(int first, int count, float* out) const override {
    const auto [width, height, depth] = fine_->lattice().size;
    std::vector<float> slice(fine_->lattice().slice()), sum(slice.size());
    for (int k = first; k < first + count; ++k) {
      std::fill(sum.begin(), sum.end(), 0.0F);
      for (const int step : {-1, 0, 1}) {
        fine_->read(std::clamp(2 * k + step, 0, depth - 1), 1, slice.data());
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += (step == 0 ? 0.5F : 0.25F) * slice[i];
      }
      for (int j = 0; j < lattice_.size[1]; ++j)
        for (int i = 0; i < lattice_.size[0]; ++i) {
          float mean = 0;
          for (const int down : {-1, 0, 1})
            for (const int across : {-1, 0, 1}) {
              const int x = std::clamp(2 * i + across, 0, width - 1), y = std::clamp(2 * j + down, 0, height - 1);
              mean += (across == 0 ? 0.5F : 0.25F) * (down == 0 ? 0.5F : 0.25F) *
                      sum[static_cast<std::size_t>(x) + static_cast<std::size_t>(width) * static_cast<std::size_t>(y)];
            }
          *out++ = mean;
        }
    }
  }

 private:
  VolumePtr fine_;
};

void require_extent(const SampleLattice& lattice) {
  for (const int n : lattice.size)
    if (n < 2)
      throw Error(ErrorKind::bad_input, "volume", fmt::format("{} samples along an axis; a solid needs two", n));
}

}  // namespace

VolumePtr volume_of(std::vector<float> densities, const SampleLattice& lattice, std::optional<double> own_threshold,
                    SampleType type) {
  require_extent(lattice);
  if (densities.size() != lattice.count())
    throw Error(ErrorKind::bad_input, "volume",
                fmt::format("{} densities for {} x {} x {} samples", densities.size(), lattice.size[0], lattice.size[1],
                            lattice.size[2]));
  const auto owner = std::make_shared<const std::vector<float>>(std::move(densities));
  return volume_in({owner, owner->data()}, lattice, own_threshold, type);
}

VolumePtr volume_in(std::shared_ptr<const float> densities, const SampleLattice& lattice,
                    std::optional<double> own_threshold, SampleType type) {
  require_extent(lattice);
  return std::make_shared<InMemory>(std::move(densities), lattice, own_threshold, type);
}

VolumePtr cropped(VolumePtr volume, const std::array<int, 3>& first, const std::array<int, 3>& count) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int whole = volume->lattice().size[axis];
    if (first[axis] < 0 || count[axis] < 2 || first[axis] > whole - count[axis])
      throw Error(ErrorKind::bad_input, "crop",
                  fmt::format("samples {} to {} along {} are not two or more of the volume's 0 to {}", first[axis],
                              static_cast<long long>(first[axis]) + count[axis] - 1, "xyz"[axis], whole - 1));
  }
  return std::make_shared<Cropped>(std::move(volume), first, count);
}

VolumePtr straightened(VolumePtr volume) {
  const Eigen::Matrix3d& axes = volume->lattice().axes;
  if (axes.isIdentity(0) || !axes.cwiseAbs().isIdentity(1e-9)) return volume;
  return std::make_shared<Flipped>(std::move(volume));
}

VolumePtr halved(VolumePtr volume) {
  for (const int n : volume->lattice().size)
    if (n < 3) throw Error(ErrorKind::bad_input, "levels", "more levels than the volume can be halved");
  return std::make_shared<Halved>(std::move(volume));
}

VolumePtr respaced(VolumePtr volume, const Vec3& spacing) {
  if (!spacing.allFinite() || spacing.minCoeff() <= 0)
    throw Error(ErrorKind::bad_input, "spacing", "must be three positive numbers of mm");
  return std::make_shared<Respaced>(std::move(volume), spacing);
}

std::vector<float> read_all(const Volume& volume, Progress& progress) {
  const SampleLattice& lattice = volume.lattice();
  require_memory(lattice.count() * sizeof(float), "volume");
  std::vector<float> densities(lattice.count());
  parallel_for(static_cast<std::size_t>(lattice.size[2]), [&](std::size_t k) {
    progress.check();
    volume.read(static_cast<int>(k), 1, densities.data() + k * lattice.slice());
  });
  return densities;
}

void for_slices(const Volume& volume, std::size_t bytes, Progress& progress, const std::string& what,
                const std::function<void(std::size_t part, std::size_t k, const float* densities)>& body) {
  const SampleLattice& lattice = volume.lattice();
  const auto slices = static_cast<std::size_t>(lattice.size[2]);
  // A file can state any size.
  require_memory(lattice.slice() * sizeof(float), "volume");
  const std::size_t fitting = bytes / (lattice.slice() * sizeof(float));
  const std::size_t parts = std::clamp(fitting, std::size_t{1}, std::min(slices, most_slice_parts));
  std::atomic<std::size_t> done{0};
  parallel_for(parts, [&](std::size_t part) {
    const auto densities = std::make_unique_for_overwrite<float[]>(lattice.slice());
    for (std::size_t k = part * slices / parts; k < (part + 1) * slices / parts; ++k) {
      progress.check();
      volume.read(static_cast<int>(k), 1, densities.get());
      body(part, k, densities.get());
      progress.report(static_cast<double>(++done) / static_cast<double>(slices), what);
    }
  });
}

}  // namespace fieldfab
