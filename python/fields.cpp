#include "bindings.h"
#include "faced_field.h"
#include "fieldfab/asdf/asdf.h"
#include "fieldfab/field/bounds.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/field/surface_distance.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/model/model.h"
#include "fieldfab/volume/distances.h"

namespace fieldfab::python {
namespace {

using Floats = py::array_t<float, py::array::c_style | py::array::forcecast>;

Vec3 vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

/// (n, 3) points as three arrays.
struct PointArrays {
  std::vector<float> x, y, z;
  explicit PointArrays(const Floats& points) {
    if (points.ndim() != 2 || points.shape(1) != 3) throw py::value_error("points must be an array of shape (n, 3)");
    const auto p = points.unchecked<2>();
    for (py::ssize_t i = 0; i < points.shape(0); ++i) x.push_back(p(i, 0)), y.push_back(p(i, 1)), z.push_back(p(i, 2));
  }
  [[nodiscard]] Points get() const { return {x.data(), y.data(), z.data(), x.size()}; }
};

Floats values(const Field& field, const Floats& points) {
  const PointArrays arrays(points);
  Floats out(static_cast<py::ssize_t>(arrays.x.size()));
  float* to = out.mutable_data();
  py::gil_scoped_release release;
  field.values(arrays.get(), to);
  return out;
}

Floats surface_distances_of(const Field& field, const Floats& points) {
  if (points.ndim() != 2 || points.shape(1) != 3) throw py::value_error("points must be an (n, 3) array");
  const auto count = static_cast<std::size_t>(points.shape(0));
  Floats out(points.shape(0));
  const std::span places(reinterpret_cast<const std::array<float, 3>*>(points.data()), count);
  const std::span to(out.mutable_data(), count);
  py::gil_scoped_release release;
  surface_distances(field, places, to);
  return out;
}

py::tuple gradients(const Field& field, const Floats& points) {
  const PointArrays arrays(points);
  const auto count = static_cast<py::ssize_t>(arrays.x.size());
  Floats out(count), slopes({count, py::ssize_t{3}});
  std::vector<float> dx(arrays.x.size()), dy(dx), dz(dx);
  {
    float* to = out.mutable_data();
    py::gil_scoped_release release;
    field.gradients(arrays.get(), to, {dx.data(), dy.data(), dz.data()});
  }
  auto to = slopes.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < count; ++i) {
    const auto n = static_cast<std::size_t>(i);
    to(i, 0) = dx[n], to(i, 1) = dy[n], to(i, 2) = dz[n];
  }
  return py::make_tuple(out, slopes);
}

FieldPtr field_in(const std::filesystem::path& path, Scripts scripts, Progress& progress) {
  const Model model = load_model(path, scripts, progress);
  return with_faces(model.field, model.faces);
}

}  // namespace

py::object bounds_to_python(const Box& box) {
  return py::make_tuple(box.lower.x(), box.lower.y(), box.lower.z(), box.upper.x(), box.upper.y(), box.upper.z());
}

FieldPtr field_of(const py::object& solid) {
  if (py::isinstance<frep::Expression>(solid)) return frep::make_field(frep::simplify(solid.cast<frep::Expression>()));
  if (py::isinstance<Field>(solid)) return std::const_pointer_cast<const Field>(solid.cast<std::shared_ptr<Field>>());
  throw py::type_error("expected a fieldfab.Expression or fieldfab.Field");
}

std::optional<Box> bounds_of(const py::object& given) {
  if (given.is_none()) return std::nullopt;
  std::vector<double> numbers;
  for (const py::handle item : given) {
    if (py::isinstance<py::sequence>(item) || py::hasattr(item, "__len__"))
      for (const py::handle part : item) numbers.push_back(part.cast<double>());
    else
      numbers.push_back(item.cast<double>());
  }
  if (numbers.size() != 6) throw py::value_error("bounds must be (x0, y0, z0, x1, y1, z1) or two points");
  return Box{{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}};
}

Box region_of(const FieldPtr& field, const py::object& given, Progress& progress) {
  std::optional<Box> wanted;
  {
    py::gil_scoped_acquire acquire;
    wanted = bounds_of(given);
  }
  Model model;
  model.field = field;
  return working_bounds(model, wanted, progress);
}

double cell_of(const Box& bounds, std::optional<double> voxel, std::optional<double> resolution, const FieldPtr& field) {
  if (voxel && resolution) throw py::value_error("give voxel or resolution, not both");
  if (voxel) return *voxel;
  if (resolution) return 1 / *resolution;
  if (const auto* asdf = dynamic_cast<const Asdf*>(field.get())) return asdf->voxel();
  return bounds.size().maxCoeff() / 128;
}

PythonProgress::PythonProgress(py::object callable)
    : callable_(std::move(callable)), progress_([this](double fraction, const std::string& message) {
        py::gil_scoped_acquire acquire;
        if (raised_) return;
        try {
          if (PyErr_CheckSignals() != 0) throw py::error_already_set();
          if (!callable_.is_none() && callable_(fraction, message).is(py::bool_(false))) progress_.cancel();
        } catch (...) {
          raised_ = std::current_exception();
          progress_.cancel();
        }
      }) {}

void PythonProgress::rethrow() {
  if (raised_) std::rethrow_exception(raised_);
}

void bind_fields(py::module_& module) {
  const auto mutable_field = [](FieldPtr field) { return std::const_pointer_cast<Field>(std::move(field)); };
  py::class_<Field, std::shared_ptr<Field>>(
      module, "Field", "A solid: a function of a point that is negative inside. Made from an Expression; Asdf is one too.")
      .def(py::init([mutable_field](const frep::Expression& e) { return mutable_field(frep::make_field(frep::simplify(e))); }),
           py::arg("expression"))
      .def(
          "value",
          [](const Field& f, double x, double y, double z) {
            return f.value({x, y, z});
          },
          py::arg("x"), py::arg("y"), py::arg("z"))
      .def("values", values, py::arg("points"), "Values at an (n, 3) array of points.")
      .def("gradients", gradients, py::arg("points"), "Values and (n, 3) gradients at an (n, 3) array of points.")
      .def("surface_distances", surface_distances_of, py::arg("points"),
           "Signed distances of an (n, 3) array of points from the surface, mm, whatever the values mean; 10 is far.")
      .def(
          "interval",
          [](const Field& f, const py::object& bounds) {
            const auto box = bounds_of(bounds);
            if (!box) throw py::value_error("interval needs bounds");
            const Interval range = f.interval(*box);
            return py::make_tuple(range.lower, range.upper);
          },
          py::arg("bounds"), "The least and greatest value that the box may hold (never too narrow).")
      .def(
          "bounds",
          [](const FieldPtr& f) -> py::object {
            SolidBounds found;
            {
              py::gil_scoped_release release;
              found = solid_bounds(*f);
            }
            if (found.empty || !found.is_bounded()) return py::none();
            return bounds_to_python(found.box);
          },
          "The box of the solid, found by interval search; None where it is empty or unbounded.")
      .def("__or__", [=](FieldPtr a, FieldPtr b) { return mutable_field(unite(a, b)); })
      .def("__and__", [=](FieldPtr a, FieldPtr b) { return mutable_field(intersect(a, b)); })
      .def("__sub__", [=](FieldPtr a, FieldPtr b) { return mutable_field(subtract(a, b)); })
      .def("__invert__", [=](FieldPtr a) { return mutable_field(complement(a)); })
      .def(
          "offset", [=](FieldPtr a, double d) { return mutable_field(offset(a, d)); }, py::arg("distance"))
      .def(
          "shell", [=](FieldPtr a, double t) { return mutable_field(shell(a, t)); }, py::arg("thickness"))
      .def(
          "blend", [=](FieldPtr a, FieldPtr b, double r) { return mutable_field(blend(a, b, r)); }, py::arg("other"),
          py::arg("radius"))
      .def(
          "morph", [=](FieldPtr a, FieldPtr b, double w) { return mutable_field(morph(a, b, w)); }, py::arg("other"),
          py::arg("weight"))
      .def(
          "distances",
          [=](const FieldPtr& f, double reach, double voxel, const py::object& bounds, const py::object& progress) {
            return mutable_field(long_work(progress, [&](Progress& p) {
              return distances(f, region_of(f, bounds, p), {reach, voxel}, p);
            }));
          },
          py::arg("reach"), py::arg("voxel") = 0, py::arg("bounds") = py::none(), py::arg("progress") = py::none(),
          "The same solid with signed distances as its values, in mm, up to `reach` mm from its surface: what offset, shell, "
          "blend and "
          "morph need of a scan, whose densities are distances only next to the surface. Worked out every `voxel` mm; 0: a 160th "
          "of "
          "the longest side.")
      .def(
          "faces",
          [](const FieldPtr& f, const py::object& progress) {
            return long_work(progress, [&](Progress& p) { return faces_of(*f, p); });
          },
          py::arg("progress") = py::none(),
          "The solid's own faces as a Mesh, exact but for the rounding of its corners: of an OpenSCAD design that is drawn with "
          "flat ones, where they can be had. None for any other solid, also for one made of such a design.")
      .def_property_readonly("sampled", &Field::sampled, "Whether it is interpolated between samples, as scans are.")
      .def(
          "translate",
          [=](FieldPtr a, double x, double y, double z) {
            return mutable_field(translate(a, {x, y, z}));
          },
          py::arg("dx"), py::arg("dy"), py::arg("dz"))
      .def(
          "scale",
          [=](FieldPtr a, double x, double y, double z) {
            return mutable_field(scale(a, {x, y, z}));
          },
          py::arg("sx"), py::arg("sy"), py::arg("sz"))
      .def(
          "rotate",
          [=](FieldPtr a, std::array<double, 3> axis, double angle) { return mutable_field(rotate(a, vector_of(axis), angle)); },
          py::arg("axis"), py::arg("angle"), "Turned about an axis through the origin, in radians.")
      .def(
          "mirror", [=](FieldPtr a, std::array<double, 3> normal) { return mutable_field(mirror(a, vector_of(normal))); },
          py::arg("normal"))
      .def(
          "map", [=](FieldPtr a, FieldPtr x, FieldPtr y, FieldPtr z) { return mutable_field(map(a, x, y, z)); }, py::arg("x"),
          py::arg("y"), py::arg("z"));
  py::implicitly_convertible<frep::Expression, Field>();

  const auto mutable_asdf = [](std::shared_ptr<const Asdf> asdf) { return std::const_pointer_cast<Asdf>(std::move(asdf)); };
  py::class_<Asdf, Field, std::shared_ptr<Asdf>>(module, "Asdf", "An adaptively sampled distance field (Keeter, Appendix C.1).")
      .def_static(
          "load",
          [=](const std::filesystem::path& path, int level, const py::object& region) {
            return mutable_asdf(Asdf::load(path, {level, bounds_of(region)}));
          },
          py::arg("filename"), py::arg("level") = 0, py::arg("region") = py::none(),
          "Reads an .asdf file, or of one with several levels a coarser one, or only what meets a region.")
      .def(
          "save",
          [](const Asdf& a, const std::filesystem::path& path, int levels, double quantum) {
            a.save(path, {quantum, levels});
          },
          py::arg("filename"), py::arg("levels") = 1, py::arg("quantum") = -1.0, py::call_guard<py::gil_scoped_release>(),
          "Writes an .asdf file with so many levels; distances as multiples of quantum mm (1/1024 of a voxel where negative).")
      .def(
          "placed", [=](const Asdf& a) { return mutable_field(a.placed()); },
          "The solid where it is in space: scans can lie askew.")
      .def(
          "slice", [=](const Asdf& a, double z) { return mutable_asdf(a.slice(z)); }, py::arg("z"),
          "The cut at a height, as a flat Asdf.")
      .def(
          "rescale", [=](const Asdf& a, double mult) { return mutable_asdf(a.rescaled(mult)); }, py::arg("mult"),
          "The same solid, `mult` times as large.")
      .def(
          "ray",
          [](const Asdf& a, std::array<double, 3> origin, std::array<double, 3> direction) {
            return a.ray(vector_of(origin), vector_of(direction));
          },
          py::arg("origin"), py::arg("direction"), "Distance to the solid along a ray, or None.")
      .def_property_readonly("region", [](const Asdf& a) { return bounds_to_python(a.region()); })
      .def_property_readonly("lattice", &Asdf::lattice)
      .def_property_readonly("voxel", &Asdf::voxel)
      .def("statistics", [](const Asdf& a) {
        const AsdfStatistics s = a.statistics();
        py::dict counts;
        counts["cells"] = s.cells(), counts["filled"] = s.filled, counts["empty"] = s.empty, counts["branches"] = s.branches,
        counts["leafs"] = s.leafs, counts["bytes"] = s.bytes, counts["depth"] = s.depth;
        return counts;
      });
  module.def(
      "build",
      [=](const py::object& solid, const py::object& bounds, std::optional<double> voxel, std::optional<double> resolution,
          std::optional<double> max_error, bool merge_leafs, const py::object& progress) {
        const FieldPtr field = field_of(solid);
        return mutable_asdf(long_work(progress, [&](Progress& p) {
          const Box region = region_of(field, bounds, p);
          return Asdf::build(*field, region, {cell_of(region, voxel, resolution, field), max_error.value_or(-1), merge_leafs}, p);
        }));
      },
      py::arg("solid"), py::arg("bounds") = py::none(), py::arg("voxel") = py::none(), py::arg("resolution") = py::none(),
      py::arg("max_error") = py::none(), py::arg("merge_leafs") = true, py::arg("progress") = py::none(),
      "Samples a solid into an Asdf. voxel in mm or resolution in voxels a mm; bounds are found where not given.");
  module.def(
      "load",
      [=](const std::filesystem::path& path) { return mutable_field(field_in(path, Scripts::refused, Progress::none())); },
      py::arg("filename"),
      "The solid of a .math, .vm, .frep, .asdf, .scad or .csg file or of a mesh, or of a volume halfway between its two "
      "commonest "
      "densities.");
  module.def(
      "run_model",
      [=](const std::filesystem::path& path, const py::object& progress) {
        return mutable_field(long_work(progress, [&](Progress& p) { return field_in(path, Scripts::run, p); }));
      },
      py::arg("filename"), py::arg("progress") = py::none(),
      "load(), and .py scripts, too: they are run, in a process of their own, and can do whatever their user can.");
}

}  // namespace fieldfab::python
