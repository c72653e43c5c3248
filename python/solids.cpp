// Python's Solid: one class for shapes, files and formulas, and for numbers in formulas.
#include <fmt/format.h>

#include <Eigen/Geometry>

#include "bindings.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/field/bounds.h"
#include "fieldfab/field/surface_distance.h"
#include "fieldfab/frep/shapes.h"
#include "fieldfab/frep/text.h"
#include "fieldfab/volume/distances.h"

namespace fieldfab::python {
namespace {

using frep::Expression;
using frep::Value;
namespace shapes = frep::shapes;

/// (n, 3) points as three arrays.
struct PointArrays {
  std::vector<float> x, y, z;
  explicit PointArrays(const Array<float>& points) {
    if (points.ndim() != 2 || points.shape(1) != 3) throw py::value_error("points must be an array of shape (n, 3)");
    const auto p = points.unchecked<2>();
    for (py::ssize_t i = 0; i < points.shape(0); ++i) x.push_back(p(i, 0)), y.push_back(p(i, 1)), z.push_back(p(i, 2));
  }
  [[nodiscard]] Points get() const { return {x.data(), y.data(), z.data(), x.size()}; }
};

Array<float> values(const SolidValue& solid, const Array<float>& points) {
  const FieldPtr field = solid.solid()->field;
  const PointArrays arrays(points);
  Array<float> out(static_cast<py::ssize_t>(arrays.x.size()));
  float* to = out.mutable_data();
  py::gil_scoped_release release;
  field->values(arrays.get(), to);
  return out;
}

Array<float> surface_distances_of(const SolidValue& solid, const Array<float>& points) {
  const FieldPtr field = solid.solid()->field;
  if (points.ndim() != 2 || points.shape(1) != 3) throw py::value_error("points must be an (n, 3) array");
  const auto count = static_cast<std::size_t>(points.shape(0));
  Array<float> out(points.shape(0));
  const std::span places(reinterpret_cast<const std::array<float, 3>*>(points.data()), count);
  const std::span to(out.mutable_data(), count);
  py::gil_scoped_release release;
  surface_distances(*field, places, to);
  return out;
}

py::tuple gradients(const SolidValue& solid, const Array<float>& points) {
  const FieldPtr field = solid.solid()->field;
  const PointArrays arrays(points);
  const auto count = static_cast<py::ssize_t>(arrays.x.size());
  Array<float> out(count), slopes({count, py::ssize_t{3}});
  std::vector<float> dx(arrays.x.size()), dy(dx), dz(dx);
  {
    float* to = out.mutable_data();
    py::gil_scoped_release release;
    field->gradients(arrays.get(), to, {dx.data(), dy.data(), dz.data()});
  }
  auto to = slopes.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < count; ++i) {
    const auto n = static_cast<std::size_t>(i);
    to(i, 0) = dx[n], to(i, 1) = dy[n], to(i, 2) = dz[n];
  }
  return py::make_tuple(out, slopes);
}

/// Values at points with coordinates that are broadcast; a number if all three are numbers.
py::object evaluate(const SolidValue& solid, const py::object& x, const py::object& y, const py::object& z) {
  const py::module_ numpy = py::module_::import("numpy");
  const py::sequence broadcast = numpy.attr("broadcast_arrays")(x, y, z);
  // contiguous and converted to float
  const Array<float> xs(broadcast[0]), ys(broadcast[1]), zs(broadcast[2]);
  Array<float> out(std::vector<py::ssize_t>(xs.shape(), xs.shape() + xs.ndim()));
  float* to = out.mutable_data();
  const FieldPtr field = solid.solid()->field;
  const Points points{xs.data(), ys.data(), zs.data(), static_cast<std::size_t>(xs.size())};
  {
    py::gil_scoped_release release;
    field->values(points, to);
  }
  if (out.ndim() == 0) return py::float_(*to);
  return out;
}

/// A transformed solid: its points are rows * (x, y, z).
SolidValue placed(const SolidValue& solid, const Eigen::Affine3d& to_outer) {
  const Eigen::Affine3d to_inner = to_outer.inverse();
  const auto row = [&](int i) {
    Expression sum = to_inner.translation()[i];
    const std::array<Expression, 3> axis{Expression::x(), Expression::y(), Expression::z()};
    for (int j = 0; j < 3; ++j) sum = sum + to_inner.linear()(i, j) * axis[static_cast<std::size_t>(j)];
    return sum;
  };
  return Value{remap(solid.value.expression, row(0), row(1), row(2)), true};
}

SolidValue turned(const SolidValue& solid, const std::array<double, 3>& axis, double angle) {
  const Vec3 along = vector_of(axis);
  if (!(along.norm() > 0)) throw Error(ErrorKind::bad_input, "rotate", "the axis must have a length");
  return placed(solid, Eigen::Affine3d(Eigen::AngleAxisd(angle, along.normalized())));
}

SolidValue mirrored(const SolidValue& solid, const std::array<double, 3>& normal) {
  const Vec3 n = vector_of(normal);
  if (!(n.norm() > 0)) throw Error(ErrorKind::bad_input, "mirror", "the normal must have a length");
  Eigen::Affine3d reflection = Eigen::Affine3d::Identity();
  reflection.linear() -= 2 * n.normalized() * n.normalized().transpose();
  return placed(solid, reflection);
}

SolidValue scaled(const SolidValue& solid, const Vec3& factors) {
  if (!((factors.array() != 0).all() && factors.allFinite()))
    throw Error(ErrorKind::bad_input, "scale", "no factor may be 0");
  const SolidValue stretched = placed(solid, Eigen::Affine3d(Eigen::Scaling(factors)));
  return Value{stretched.value.expression * factors.cwiseAbs().minCoeff(), true};
}

SolidValue in_memory(FieldPtr field, const char* kind) {
  return SolidValue(fieldfab::solid_of(std::move(field), kind));
}

/// Text without the newline at the end of a file.
py::str text_of(const SolidValue& solid, const std::filesystem::path& folder) {
  std::string text = frep::print_infix(solid.value.expression, folder);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return python_text(text);
}

template <char sign>
void define_operator(py::class_<SolidValue, std::shared_ptr<SolidValue>>& solid, const char* name,
                     const char* reflected) {
  solid.def(
      name,
      [](const SolidValue& a, const SolidValue& b) {
        return SolidValue(frep::joined(sign, a.value, b.value, frep::Making::folded));
      },
      py::is_operator());
  if (reflected != nullptr)
    solid.def(
        reflected,
        [](const SolidValue& a, double b) {
          return SolidValue(frep::joined(sign, Value{b}, a.value, frep::Making::folded));
        },
        py::is_operator());
}

}  // namespace

const std::shared_ptr<const Solid>& SolidValue::solid() const {
  if (made_ == nullptr) made_ = std::make_shared<const Solid>(fieldfab::solid_of(value.expression));
  return made_;
}

py::object bounds_to_python(const Box& box) {
  return py::make_tuple(box.lower.x(), box.lower.y(), box.lower.z(), box.upper.x(), box.upper.y(), box.upper.z());
}

std::shared_ptr<const Solid> solid_of(const py::object& solid) {
  // Itself, not a copy: it keeps what is made of it.
  if (py::isinstance<SolidValue>(solid)) return solid.cast<const SolidValue&>().solid();
  if (!py::isinstance<py::float_>(solid) && !py::isinstance<py::int_>(solid))
    throw py::type_error("expected a fieldfab.Solid");
  return solid.cast<SolidValue>().solid();
}

FieldPtr field_of(const py::object& solid) { return solid_of(solid)->field; }

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

Box region_of(const Solid& solid, const py::object& given, Progress& progress) {
  std::optional<Box> wanted;
  {
    py::gil_scoped_acquire acquire;
    wanted = bounds_of(given);
  }
  return working_bounds(solid, wanted, progress);
}

double cell_of(const Box& bounds, std::optional<double> voxel, std::optional<double> resolution, const Solid& solid) {
  if (voxel && resolution) throw py::value_error("give voxel or resolution, not both");
  if (voxel) return *voxel;
  if (resolution) return 1 / *resolution;
  return default_voxel(solid, bounds);
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

void bind_solids(py::module_& module) {
  // along the longest side, for a solid without a resolution of its own
  module.attr("default_cells") = default_cells;
  py::class_<SolidValue, std::shared_ptr<SolidValue>> solid(
      module, "Solid",
      "A solid, as a function of a point that is negative inside, or a number that may depend on x, y and z. Shapes, "
      "files and "
      "sets are solids: a | b, a & b, a - b, ~a. Numbers have arithmetic; a number is a solid where one is needed.");
  solid.def(py::init([](double number) { return SolidValue(Value{number}); }), py::arg("value"))
      .def(py::init<const SolidValue&>(), py::arg("value"));
  define_operator<'+'>(solid, "__add__", "__radd__");
  define_operator<'-'>(solid, "__sub__", "__rsub__");
  define_operator<'*'>(solid, "__mul__", "__rmul__");
  define_operator<'/'>(solid, "__truediv__", "__rtruediv__");
  define_operator<'^'>(solid, "__pow__", "__rpow__");
  define_operator<'|'>(solid, "__or__", nullptr);
  define_operator<'&'>(solid, "__and__", nullptr);
  solid.def("__neg__",
            [](const SolidValue& a) {
              return SolidValue(Value{-a.value.expression, a.value.solid});
            })
      .def(
          "__invert__",
          [](const SolidValue& a) {
            return SolidValue(Value{-a.value.expression, true});
          },
          "complement")
      .def(
          "__mod__",
          [](const SolidValue& a, const SolidValue& b) {
            return SolidValue(Value{frep::mod(a.value.expression, b.value.expression)});
          },
          py::is_operator())
      .def("__abs__", [](const SolidValue& a) { return SolidValue(Value{frep::abs(a.value.expression)}); })
      .def(
          "__eq__", [](const SolidValue& a, const SolidValue& b) { return a.value.expression == b.value.expression; },
          py::is_operator(), "Whether both are the same formula, node for node.")
      .def("__hash__", [](const SolidValue& a) { return std::hash<const void*>{}(a.value.expression.id()); })
      .def("__str__", [](const SolidValue& a) { return text_of(a, {}); })
      .def("__repr__",
           [](const SolidValue& a) {
             return fmt::format("<fieldfab.Solid: {} of {} nodes>", a.value.solid ? "a solid" : "a number",
                                frep::node_count(a.value.expression));
           })
      .def_property_readonly(
          "is_solid", [](const SolidValue& a) { return a.value.solid; }, "False for a number.")
      .def_property_readonly(
          "kind", [](const SolidValue& a) { return a.solid()->kind; },
          "What it comes from: f-rep, asdf, mesh, volume or design; f-rep, too, for what is made of several.")
      .def_property_readonly(
          "voxel", [](const SolidValue& a) { return a.solid()->voxel; }, "Its own resolution, mm, or None.")
      .def_property_readonly(
          "flat", [](const SolidValue& a) { return a.solid()->flat; }, "Whether it is known to be 2D.")
      .def_property_readonly(
          "sampled", [](const SolidValue& a) { return a.field().sampled(); },
          "Whether it is interpolated between samples, as scans are.")
      .def(
          "math", [](const SolidValue& a) { return frep::print_math(a.value.expression); },
          "The formula as a prefix math string.")
      .def(
          "vm", [](const SolidValue& a) { return frep::print_vm(a.value.expression); }, "The formula as a .vm program.")
      .def("frep", text_of, py::arg("folder") = "",
           "The solid as .frep text, which parse() reads back; files that it opens are named relative to `folder` if "
           "they are in "
           "it.")
      .def(
          "save_dot",
          [](const SolidValue& a, const std::filesystem::path& path) {
            write_file(path, frep::print_dot(a.value.expression));
          },
          py::arg("filename"), "Writes the formula as a graph for Graphviz.")
      .def("simplified",
           [](const SolidValue& a) {
             return SolidValue(Value{frep::simplify(a.value.expression), a.value.solid});
           })
      .def("node_count", [](const SolidValue& a) { return frep::node_count(a.value.expression); })
      .def(
          "map",
          [](const SolidValue& a, const std::optional<SolidValue>& x, const std::optional<SolidValue>& y,
             const std::optional<SolidValue>& z) {
            const auto or_axis = [](const std::optional<SolidValue>& given, const Expression& axis) {
              return given ? given->value.expression : axis;
            };
            return SolidValue(Value{remap(a.value.expression, or_axis(x, Expression::x()), or_axis(y, Expression::y()),
                                          or_axis(z, Expression::z())),
                                    a.value.solid});
          },
          py::arg("x") = py::none(), py::arg("y") = py::none(), py::arg("z") = py::none(),
          "With x, y and z replaced; None leaves a coordinate as it is.")
      .def("__call__", evaluate, py::arg("x"), py::arg("y"), py::arg("z"),
           "Values at points, in single precision; arrays broadcast as NumPy's do.")
      .def(
          "value",
          [](const SolidValue& a, double x, double y, double z) {
            return a.field().value({x, y, z});
          },
          py::arg("x"), py::arg("y"), py::arg("z"), "The value at one point.")
      .def("values", values, py::arg("points"), "Values at an (n, 3) array of points.")
      .def("gradients", gradients, py::arg("points"), "Values and (n, 3) gradients at an (n, 3) array of points.")
      .def("surface_distances", surface_distances_of, py::arg("points"),
           "Signed distances of an (n, 3) array of points from the surface, mm, whatever the values mean; 10 is far.")
      .def(
          "interval",
          [](const SolidValue& a, const py::object& bounds) {
            const auto box = bounds_of(bounds);
            if (!box) throw py::value_error("interval needs bounds");
            const Interval range = a.field().interval(*box);
            return py::make_tuple(range.lower, range.upper);
          },
          py::arg("bounds"), "The least and greatest value that the box may hold (never too narrow).")
      .def(
          "bounds",
          [](const SolidValue& a, bool flat) -> py::object {
            const FieldPtr field = a.solid()->field;
            SolidBounds found;
            {
              py::gil_scoped_release release;
              found = solid_bounds(*field);
            }
            if (flat && !found.bounded[2]) {
              found.bounded[2] = true;
              found.box.lower.z() = found.box.upper.z() = 0;
            }
            if (found.empty || !found.is_bounded()) return py::none();
            return bounds_to_python(found.box);
          },
          py::arg("flat") = false,
          "Returns the bounding box of the solid, found by interval search, or None if the solid is empty or "
          "unbounded. With "
          "flat=True a solid that is unbounded along z gets z from 0 to 0.")
      .def(
          "default_voxel",
          [](const SolidValue& a, const py::object& bounds, double cells) {
            const auto whole = a.solid();
            return long_work(py::none(),
                             [&](Progress& p) { return default_voxel(*whole, region_of(*whole, bounds, p), cells); });
          },
          py::arg("bounds") = py::none(), py::arg("cells") = default_cells,
          "The cell, mm, that mesh(), build() and others take where none is given: its own resolution, else so many "
          "along the "
          "longest side of the bounds, which are found where not given.")
      .def(
          "offset",
          [](const SolidValue& a, double d) {
            return SolidValue(Value{a.value.expression - d, true});
          },
          py::arg("distance"))
      .def(
          "shell",
          [](const SolidValue& a, double t) {
            if (!(t > 0)) throw Error(ErrorKind::bad_input, "shell", "the thickness must be above 0 mm");
            return SolidValue(Value{shapes::shell(a.value.expression, t), true});
          },
          py::arg("thickness"))
      .def(
          "blend",
          [](const SolidValue& a, const SolidValue& b, double r) {
            if (!(r > 0)) throw Error(ErrorKind::bad_input, "blend", "the radius must be above 0 mm");
            return SolidValue(Value{shapes::blend(a.value.expression, b.value.expression, r), true});
          },
          py::arg("other"), py::arg("radius"))
      .def(
          "morph",
          [](const SolidValue& a, const SolidValue& b, double w) {
            return SolidValue(Value{shapes::morph(a.value.expression, b.value.expression, w), true});
          },
          py::arg("other"), py::arg("weight"))
      .def(
          "distances",
          [](const SolidValue& a, double reach, double voxel, const py::object& bounds, const py::object& progress) {
            const auto whole = a.solid();
            return in_memory(
                long_work(progress,
                          [&](Progress& p) {
                            return distances(whole->field, region_of(*whole, bounds, p), {reach, voxel}, p);
                          }),
                "asdf");
          },
          py::arg("reach"), py::arg("voxel") = 0, py::arg("bounds") = py::none(), py::arg("progress") = py::none(),
          "The same solid with signed distances as its values, in mm, up to `reach` mm from its surface: what offset, "
          "shell, "
          "blend and morph need of a scan, whose densities are distances only next to the surface. Worked out every "
          "`voxel` mm; "
          "0: a 160th of the longest side.")
      .def(
          "faces",
          [](const SolidValue& a, const py::object& progress) {
            const auto whole = a.solid();
            return long_work(progress, [&](Progress& p) {
              return whole->faces != nullptr ? whole->faces(std::nullopt, p) : std::optional<TriangleMesh>();
            });
          },
          py::arg("progress") = py::none(),
          "The solid's own faces as a Mesh, exact but for the rounding of its corners: of an OpenSCAD design that is "
          "drawn with "
          "flat ones, moved and turned or as it is, where they can be had. None for any other solid.")
      .def(
          "translate",
          [](const SolidValue& a, double x, double y, double z) {
            return SolidValue(Value{shapes::move(a.value.expression, x, y, z), true});
          },
          py::arg("dx"), py::arg("dy"), py::arg("dz"))
      .def(
          "scale",
          [](const SolidValue& a, double x, double y, double z) {
            return scaled(a, {x, y, z});
          },
          py::arg("sx"), py::arg("sy"), py::arg("sz"))
      .def("rotate", turned, py::arg("axis"), py::arg("angle"), "Turned about an axis through the origin, in radians.")
      .def("mirror", mirrored, py::arg("normal"));
  py::implicitly_convertible<double, SolidValue>();
  py::implicitly_convertible<int, SolidValue>();
}

}  // namespace fieldfab::python
