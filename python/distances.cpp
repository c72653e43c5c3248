// Python bindings of distance fields.
#include "bindings.h"
#include "fieldfab/asdf/asdf.h"

namespace fieldfab::python {
namespace {

Vec3 vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

Solid sampled_solid(const std::shared_ptr<const Asdf>& asdf) {
  auto opened = std::make_shared<OpenedSolid>();
  opened->field = asdf;
  opened->kind = "asdf";
  opened->voxel = asdf->voxel();
  return fieldfab::solid_of(opened);
}

/// A Solid that is an Asdf.
class AsdfValue : public SolidValue {
 public:
  explicit AsdfValue(std::shared_ptr<const Asdf> made) : SolidValue(sampled_solid(made)), asdf(std::move(made)) {}
  std::shared_ptr<const Asdf> asdf;
};

}  // namespace

void bind_distances(py::module_& module) {
  py::class_<AsdfValue, SolidValue, std::shared_ptr<AsdfValue>>(
      module, "Asdf", "An adaptively sampled distance field (Keeter, Appendix C.1).")
      .def_static(
          "load",
          [](const std::filesystem::path& path, int level, const py::object& region) {
            return AsdfValue(Asdf::load(path, {level, bounds_of(region)}));
          },
          py::arg("filename"), py::arg("level") = 0, py::arg("region") = py::none(),
          "Reads an .asdf file, or of one with several levels a coarser one, or only what meets a region.")
      .def(
          "save",
          [](const AsdfValue& a, const std::filesystem::path& path, int levels, double quantum) {
            a.asdf->save(path, {quantum, levels});
          },
          py::arg("filename"), py::arg("levels") = 1, py::arg("quantum") = -1.0,
          py::call_guard<py::gil_scoped_release>(),
          "Writes an .asdf file with so many levels; distances as multiples of quantum mm (1/1024 of a voxel where "
          "negative).")
      .def(
          "placed", [](const AsdfValue& a) { return SolidValue(solid_of(a.asdf->placed(), "asdf")); },
          "The solid where it is in space: scans can lie askew.")
      .def(
          "slice", [](const AsdfValue& a, double z) { return AsdfValue(a.asdf->slice(z)); }, py::arg("z"),
          "The cut at a height, as a flat Asdf.")
      .def(
          "rescale", [](const AsdfValue& a, double mult) { return AsdfValue(a.asdf->rescaled(mult)); }, py::arg("mult"),
          "The same solid, `mult` times as large.")
      .def(
          "ray",
          [](const AsdfValue& a, std::array<double, 3> origin, std::array<double, 3> direction) {
            return a.asdf->ray(vector_of(origin), vector_of(direction));
          },
          py::arg("origin"), py::arg("direction"), "Distance to the solid along a ray, or None.")
      .def_property_readonly("region", [](const AsdfValue& a) { return bounds_to_python(a.asdf->region()); })
      .def_property_readonly("lattice", [](const AsdfValue& a) { return a.asdf->lattice(); })
      .def_property_readonly("voxel", [](const AsdfValue& a) { return a.asdf->voxel(); })
      .def("statistics", [](const AsdfValue& a) {
        const AsdfStatistics s = a.asdf->statistics();
        py::dict counts;
        counts["cells"] = s.cells(), counts["filled"] = s.filled, counts["empty"] = s.empty,
        counts["branches"] = s.branches, counts["leafs"] = s.leafs, counts["bytes"] = s.bytes,
        counts["depth"] = s.depth;
        return counts;
      });
  module.def(
      "build",
      [](const py::object& solid, const py::object& bounds, std::optional<double> voxel,
         std::optional<double> resolution, std::optional<double> max_error, bool merge_leafs,
         const py::object& progress) {
        const auto wanted = solid_of(solid);
        return AsdfValue(long_work(progress, [&](Progress& p) {
          const Box region = region_of(*wanted, bounds, p);
          const double cell = cell_of(region, voxel, resolution, *wanted);
          return Asdf::build(*wanted->field, region, {cell, max_error.value_or(-1), merge_leafs}, p);
        }));
      },
      py::arg("solid"), py::arg("bounds") = py::none(), py::arg("voxel") = py::none(),
      py::arg("resolution") = py::none(), py::arg("max_error") = py::none(), py::arg("merge_leafs") = true,
      py::arg("progress") = py::none(),
      "Samples a solid into an Asdf. voxel in mm or resolution in voxels a mm; bounds are found where not given.");
}

}  // namespace fieldfab::python
