/// Parts of the Python module: each file binds one folder of the kernel.
#pragma once

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/operators.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "fieldfab/core/geometry.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"
#include "fieldfab/frep/library.h"
#include "fieldfab/solid/open.h"
#include "fieldfab/solid/surface.h"

namespace fieldfab::python {

namespace py = pybind11;

void bind_solids(py::module_& module);
void bind_language(py::module_& module);
/// Adds the submodule `language`.
void bind_grammar(py::module_& parent);
void bind_distances(py::module_& module);
void bind_results(py::module_& module);
void bind_volumes(py::module_& module);
void bind_openscad(py::module_& module);
void bind_cam(py::module_& parent);
/// Adds to the module `cam`.
void bind_workflow(py::module_& module);
void bind_stock(py::module_& parent);
void bind_playback(py::module_& module);

/// An array of numbers in C order; NumPy converts others to it.
template <class Number>
using Array = py::array_t<Number, py::array::c_style | py::array::forcecast>;

inline Vec3 vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

/// A Progress that calls a Python callable (or none) and checks for Ctrl-C. The callable receives
/// (fraction, message) and returns False to cancel. Construct it with the interpreter lock held;
/// use it without.
class PythonProgress {
 public:
  explicit PythonProgress(py::object callable);
  Progress& get() { return progress_; }
  /// Rethrows an exception of the callable. Call with the lock held after the work has stopped.
  void rethrow();

 private:
  py::object callable_;
  std::exception_ptr raised_;
  Progress progress_;
};

/// Bounds in Python: None, six numbers, or two points.
std::optional<Box> bounds_of(const py::object& given);
/// (x0, y0, z0, x1, y1, z1).
py::object bounds_to_python(const Box& box);
/// The region to work in; default: working_bounds().
Box region_of(const Solid& solid, const py::object& given, Progress& progress);
/// The smallest cell from voxel= or resolution=, or the solid's default.
double cell_of(const Box& bounds, std::optional<double> voxel, std::optional<double> resolution, const Solid& solid);

/// Python's Solid: a value of the design language, and the solid, which is made on demand.
class SolidValue {
 public:
  SolidValue(frep::Value given) : value(std::move(given)) {}  // NOLINT(google-explicit-constructor): values are solids
  explicit SolidValue(Solid solid)
      : value{solid.expression, true}, made_(std::make_shared<const Solid>(std::move(solid))) {}
  virtual ~SolidValue() = default;

  /// The solid with its metadata. Call with Python's lock held.
  [[nodiscard]] const std::shared_ptr<const Solid>& solid() const;
  [[nodiscard]] const Field& field() const { return *solid()->field; }

  frep::Value value;

 private:
  mutable std::shared_ptr<const Solid> made_;
};

/// .frep text in Python: invalid UTF-8 in file names becomes surrogate escapes, as in Python's own
/// file names.
inline py::str python_text(const std::string& text) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "surrogateescape"));
}

/// The Solid of a Python object: a Solid or a number. Throws TypeError for any other.
std::shared_ptr<const Solid> solid_of(const py::object& solid);
/// The Field of a Python object, as for solid_of().
FieldPtr field_of(const py::object& solid);

/// A colour from a name, "#rrggbb", or three numbers from 0 to 255; std::nullopt for None.
std::optional<Colour> colour_of(const py::object& given);
/// A part in Python: (a Solid or a Mesh, name or None, colour or None).
struct PythonPart {
  py::object what;  ///< converted by the caller
  std::string name;
  std::optional<Colour> colour;
};
std::vector<PythonPart> parts_given(const py::iterable& parts);

/// Runs work(progress) without Python's lock.
template <class Work>
auto long_work(const py::object& callable, Work&& work) {
  PythonProgress progress(callable);
  try {
    py::gil_scoped_release release;
    return work(progress.get());
  } catch (...) {
    py::gil_scoped_acquire acquire;
    progress.rethrow();
    throw;
  }
}

}  // namespace fieldfab::python
