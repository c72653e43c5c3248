// Python bindings of distance fields.
#include "bindings.h"
#include "fieldfab/asdf/asdf.h"
#include "fieldfab/contour/bricks.h"
#include "fieldfab/core/error.h"

namespace fieldfab::python {
namespace {

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

/// The mesh of an .asdf file in bricks, each made of the part of the file around it.
class MeshBricks {
 public:
  MeshBricks(std::filesystem::path path, const std::optional<Box>& bounds, std::optional<double> voxel,
             std::optional<double> max_error, int level, int cells)
      : path_(std::move(path)),
        options_({{"level", static_cast<double>(level)}}),
        known_(open(Box{Vec3::Zero(), Vec3::Zero()})),
        bounds_(bounds.value_or(known_.bounds.value_or(Box{}))),
        voxel_(voxel.value_or(default_voxel(known_, bounds_))),
        bricks_(bounds_, {voxel_, max_error.value_or(-1)}, cells) {}

  [[nodiscard]] const Box& bounds() const { return bounds_; }
  [[nodiscard]] double voxel() const { return voxel_; }
  /// Number of resolution levels of the file.
  [[nodiscard]] std::size_t levels() const { return std::max<std::size_t>(1, Asdf::look(path_).levels.size()); }
  [[nodiscard]] const std::array<int, 3>& count() const { return bricks_.count(); }
  [[nodiscard]] BrickMesh mesh(const std::array<int, 3>& brick, Progress& progress) const {
    return bricks_.mesh(*open(bricks_.surroundings(brick)).field, brick, progress);
  }

 private:
  /// The solid as the command opens it, with its distances in `region` only.
  [[nodiscard]] Solid open(const Box& region) const {
    Solid solid = open_solid(path_, options_, {.region = region});
    if (solid.kind != "asdf")
      throw Error(ErrorKind::bad_input, path_.string(), "only .asdf files are meshed in bricks");
    return solid;
  }

  std::filesystem::path path_;
  std::vector<frep::OpenOption> options_;
  Solid known_;  ///< almost nothing of the file, but its bounds and cell
  Box bounds_;
  double voxel_;
  ContourBricks bricks_;
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
  py::class_<MeshBricks>(module, "MeshBricks",
                         "The mesh of an .asdf file in bricks: cubes of cells, each meshed from the part of the file "
                         "around it. Their triangles are those of the mesh in one piece.")
      .def(py::init([](const std::filesystem::path& path, const py::object& bounds, std::optional<double> voxel,
                       std::optional<double> max_error, int level,
                       int cells) { return MeshBricks(path, bounds_of(bounds), voxel, max_error, level, cells); }),
           py::arg("filename"), py::arg("bounds") = py::none(), py::arg("voxel") = py::none(),
           py::arg("max_error") = py::none(), py::arg("level") = 0, py::arg("cells") = ContourBricks::usual_cells,
           "Bounds, voxel and max_error in mm, by default as `fieldfab mesh` has them; a resolution level of the file; "
           "the cells along the edge of a brick, a power of two of at least 32.")
      .def_property_readonly("bounds", [](const MeshBricks& b) { return bounds_to_python(b.bounds()); })
      .def_property_readonly("voxel", &MeshBricks::voxel, "Edge of a cell, mm.")
      .def_property_readonly("levels", &MeshBricks::levels, "Resolution levels of the file.")
      .def_property_readonly("count", &MeshBricks::count, "Bricks along x, y and z.")
      .def(
          "mesh",
          [](const MeshBricks& b, const std::array<int, 3>& brick, const py::object& progress) {
            BrickMesh made = long_work(progress, [&](Progress& p) { return b.mesh(brick, p); });
            py::array_t<std::uint32_t> seam(static_cast<py::ssize_t>(made.seam.size()), made.seam.data());
            return py::make_tuple(static_cast<TriangleMesh&&>(std::move(made)), std::move(seam));
          },
          py::arg("brick"), py::arg("progress") = py::none(),
          "The Mesh of the brick at x, y, z, and the indices of its vertices that neighbours have too.");
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
