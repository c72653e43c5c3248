// Python bindings of volumes: CT scans and other densities on a lattice.
#include "bindings.h"
#include "fieldfab/asdf/asdf.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/solid/scan_solid.h"

namespace fieldfab::python {
namespace {

using Triple = std::array<double, 3>;

constexpr std::size_t memory = std::size_t{512} << 20;

/// A threshold in Python: None, a number, "otsu" or "90%".
ThresholdRule rule_of(const py::object& threshold) {
  if (threshold.is_none()) return {};
  if (py::isinstance<py::str>(threshold)) return ThresholdRule::parse(threshold.cast<std::string>());
  return {ThresholdRule::Kind::value, threshold.cast<double>()};
}

ScanOptions options_of(const py::object& threshold, bool below, const std::string& denoise, bool keep_largest,
                       std::optional<double> min_island, std::optional<double> min_hole) {
  ScanOptions options;
  options.threshold = rule_of(threshold);
  options.below = below;
  options.clean = {Denoising::parse(denoise), keep_largest, min_island, min_hole};
  return options;
}

VolumePtr from_array(const Array<float>& densities, const Triple& spacing, const Triple& origin) {
  if (densities.ndim() != 3) throw py::value_error("densities must be an array of shape (nz, ny, nx)");
  SampleLattice lattice;
  for (int axis = 0; axis < 3; ++axis)
    lattice.size[static_cast<std::size_t>(axis)] = static_cast<int>(densities.shape(2 - axis));
  lattice.spacing = vector_of(spacing);
  lattice.origin = vector_of(origin);
  return volume_of({densities.data(), densities.data() + densities.size()}, lattice);
}

Array<float> to_array(const Volume& volume) {
  const auto& n = volume.lattice().size;
  Array<float> densities({n[2], n[1], n[0]});
  float* const to = densities.mutable_data();
  py::gil_scoped_release release;
  parallel_for(static_cast<std::size_t>(n[2]),
               [&](std::size_t k) { volume.read(static_cast<int>(k), 1, to + k * volume.lattice().slice()); });
  return densities;
}

}  // namespace

void bind_volumes(py::module_& module) {
  const auto mutable_volume = [](VolumePtr volume) { return std::const_pointer_cast<Volume>(std::move(volume)); };
  const auto triple = [](const Vec3& v) { return py::make_tuple(v.x(), v.y(), v.z()); };
  py::class_<Volume, std::shared_ptr<Volume>>(module, "Volume",
                                              "Densities on a lattice, such as a CT scan (Keeter, chapter 5).")
      .def(py::init([=](const Array<float>& densities, const Triple& spacing, const Triple& origin) {
             return mutable_volume(from_array(densities, spacing, origin));
           }),
           py::arg("densities"), py::arg("spacing") = Triple{1, 1, 1}, py::arg("origin") = Triple{0, 0, 0},
           "From an array of shape (nz, ny, nx); spacing and origin in mm.")
      .def_static(
          "open",
          [=](const std::filesystem::path& path, const py::object& dims, const std::string& type,
              const py::object& spacing, const std::string& series, const py::object& progress) {
            VolumeFileOptions options;
            if (!dims.is_none()) options.size = dims.cast<std::array<int, 3>>();
            if (!type.empty() && !(options.type = sample_type(type)))
              throw py::value_error("no type of sample: " + type);
            if (!spacing.is_none()) options.spacing = vector_of(spacing.cast<Triple>());
            options.series = series;
            return mutable_volume(long_work(progress, [&](Progress& p) { return open_volume(path, options, p); }));
          },
          py::arg("filename"), py::arg("dims") = py::none(), py::arg("type") = "", py::arg("spacing") = py::none(),
          py::arg("series") = "", py::arg("progress") = py::none(),
          "Opens .raw .vol .vgi .tif .mha .mhd .nrrd .nii .dcm .vdb, or a folder of TIFF, PNG or DICOM slices.")
      .def_property_readonly(
          "size", [](const Volume& v) { return v.lattice().size; }, "Samples along x, y and z.")
      .def_property_readonly("spacing", [=](const Volume& v) { return triple(v.lattice().spacing); })
      .def_property_readonly("origin", [=](const Volume& v) { return triple(v.lattice().origin); })
      .def_property_readonly(
          "axes",
          [=](const Volume& v) {
            const Eigen::Matrix3d& a = v.lattice().axes;
            return py::make_tuple(triple(a.col(0)), triple(a.col(1)), triple(a.col(2)));
          },
          "The directions of the lattice's axes in space.")
      .def_property_readonly("type", [](const Volume& v) { return std::string(name(v.type())); })
      .def("densities", &to_array, "All densities, an array of shape (nz, ny, nx).")
      .def(
          "histogram",
          [](const Volume& v) {
            const Histogram counts = long_work(py::none(), [&](Progress& p) { return histogram(v, memory, p); });
            std::vector<double> edges;
            for (std::size_t i = 0; i <= counts.counts.size(); ++i)
              edges.push_back(counts.first + static_cast<double>(i) * counts.width);
            return py::make_tuple(counts.counts, edges);
          },
          "Counts and the edges of their bins, as numpy.histogram gives them.")
      .def(
          "threshold",
          [](const Volume& v, const py::object& rule) {
            const ThresholdRule asked = rule_of(rule);
            return long_work(py::none(), [&](Progress& p) { return threshold_by(asked, v, memory, p); });
          },
          py::arg("rule") = "otsu", "The density by a rule: a number, 'otsu' or a share such as '90%'.")
      .def(
          "crop",
          [=](const std::shared_ptr<Volume>& v, const std::array<int, 3>& first, const std::array<int, 3>& last) {
            return mutable_volume(
                cropped(v, first, {last[0] - first[0] + 1, last[1] - first[1] + 1, last[2] - first[2] + 1}));
          },
          py::arg("first"), py::arg("last"), "The samples from `first` to `last`, both included.")
      .def(
          "half", [=](const std::shared_ptr<Volume>& v) { return mutable_volume(halved(v)); },
          "At half the resolution.")
      .def(
          "save", [](const Volume& v, const std::filesystem::path& path) { write_volume(v, path); },
          py::arg("filename"), py::call_guard<py::gil_scoped_release>(), "Writes .nrrd, .mha, .nii or .nii.gz.")
      .def(
          "solid",
          [](const std::shared_ptr<Volume>& v, const py::object& threshold, bool below, const std::string& denoise,
             bool keep_largest, std::optional<double> min_island, std::optional<double> min_hole,
             const py::object& progress) {
            const ScanOptions options = options_of(threshold, below, denoise, keep_largest, min_island, min_hole);
            return SolidValue(fieldfab::solid_of(std::shared_ptr<const OpenedSolid>(
                long_work(progress, [&](Progress& p) { return opened_scan(take_scan(v, options, p), p); }))));
          },
          py::arg("threshold") = py::none(), py::arg("below") = false, py::arg("denoise") = "",
          py::arg("keep_largest") = false, py::arg("min_island") = py::none(), py::arg("min_hole") = py::none(),
          py::arg("progress") = py::none(),
          "What is denser than the threshold (Otsu's where none is given), as a solid in mm.")
      .def(
          "save_asdf",
          [](const std::shared_ptr<Volume>& v, const std::filesystem::path& path, const py::object& threshold,
             bool below, double max_error, int levels, double quantum, const py::object& progress) {
            const ScanOptions options = options_of(threshold, below, "", false, {}, {});
            const ImportCounts counts = long_work(progress, [&](Progress& p) {
              return import_scan(take_scan(v, options, p), path, {max_error, {quantum, levels}, options.memory}, p);
            });
            py::dict made;
            made["cells"] = counts.cells, made["leafs"] = counts.leafs, made["blocks"] = counts.blocks;
            return made;
          },
          py::arg("filename"), py::arg("threshold") = py::none(), py::arg("below") = false, py::arg("max_error") = -1.0,
          py::arg("levels") = 1, py::arg("quantum") = -1.0, py::arg("progress") = py::none(),
          "Imports the solid into an .asdf file, block by block, whatever the volume's size.")
      .def(
          "save_part",
          [](const std::shared_ptr<Volume>& v, const std::filesystem::path& path, int part, int parts, double threshold,
             bool below, double max_error, int levels, double quantum, const py::object& progress) {
            long_work(progress, [&](Progress& p) {
              import_part(lattices_of({v, isosurface(*v, threshold, below)}, levels), path,
                          {max_error, {quantum, levels}, memory}, {part, parts}, p);
              return 0;
            });
          },
          py::arg("filename"), py::arg("part"), py::arg("parts"), py::arg("threshold"), py::arg("below") = false,
          py::arg("max_error") = -1.0, py::arg("levels") = 1, py::arg("quantum") = -1.0,
          py::arg("progress") = py::none(),
          "One part of what save_asdf() does, for merge_parts(): see fieldfab.bricks.")
      .def(
          "merge_parts",
          [](const std::shared_ptr<Volume>& v, const std::filesystem::path& path,
             const std::vector<std::filesystem::path>& parts, double threshold, bool below, double max_error,
             int levels, double quantum, const py::object& progress) {
            const ImportCounts counts = long_work(progress, [&](Progress& p) {
              return merge_parts(lattices_of({v, isosurface(*v, threshold, below)}, levels), parts, path,
                                 {max_error, {quantum, levels}, memory}, p);
            });
            py::dict made;
            made["cells"] = counts.cells, made["leafs"] = counts.leafs, made["blocks"] = counts.blocks;
            return made;
          },
          py::arg("filename"), py::arg("part_files"), py::arg("threshold"), py::arg("below") = false,
          py::arg("max_error") = -1.0, py::arg("levels") = 1, py::arg("quantum") = -1.0,
          py::arg("progress") = py::none(), "The .asdf file of all parts, byte for byte that of save_asdf().");
}

}  // namespace fieldfab::python
