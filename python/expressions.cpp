#include <pybind11/operators.h>

#include "bindings.h"
#include "fieldfab/core/error.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"
#include "fieldfab/frep/text.h"

namespace fieldfab::python {
namespace {

using frep::Expression;

/// Infix .frep text, or a prefix math string where it reads as one and not as infix.
Expression parse_any(const std::string& text) {
  try {
    return frep::parse_infix(text, "expression");
  } catch (const Error&) {
    try {
      return frep::parse_math(text, "expression");
    } catch (const Error&) {
    }
    throw;
  }
}

using Floats = py::array_t<float, py::array::c_style | py::array::forcecast>;

/// Values at points given by coordinates that broadcast against each other; a number where all three are.
py::object evaluate(const Expression& expression, const py::object& x, const py::object& y, const py::object& z) {
  const py::module_ numpy = py::module_::import("numpy");
  const py::sequence broadcast = numpy.attr("broadcast_arrays")(x, y, z);
  const Floats xs(broadcast[0]), ys(broadcast[1]), zs(broadcast[2]);  // laid out and rounded to float
  Floats out(std::vector<py::ssize_t>(xs.shape(), xs.shape() + xs.ndim()));
  float* to = out.mutable_data();
  const Points points{xs.data(), ys.data(), zs.data(), static_cast<std::size_t>(xs.size())};
  {
    py::gil_scoped_release release;
    frep::make_field(expression)->values(points, to);
  }
  if (out.ndim() == 0) return py::float_(*to);
  return out;
}

/// Without the newline that ends a file.
std::string text_of(const Expression& expression) {
  std::string text = frep::print_infix(expression);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

}  // namespace

void bind_expressions(py::module_& module) {
  py::class_<Expression> expression(module, "Expression", "A formula over x, y and z. Equal formulas are one object inside.");
  expression.def(py::init<double>(), py::arg("value"))
      .def(py::self + py::self)
      .def(py::self - py::self)
      .def(py::self * py::self)
      .def(py::self / py::self)
      .def(-py::self)
      .def(
          "__radd__", [](const Expression& a, double b) { return Expression(b) + a; }, py::is_operator())
      .def(
          "__rsub__", [](const Expression& a, double b) { return Expression(b) - a; }, py::is_operator())
      .def(
          "__rmul__", [](const Expression& a, double b) { return Expression(b) * a; }, py::is_operator())
      .def(
          "__rtruediv__", [](const Expression& a, double b) { return Expression(b) / a; }, py::is_operator())
      .def(
          "__pow__", [](const Expression& a, const Expression& b) { return frep::pow(a, b); }, py::is_operator())
      .def(
          "__rpow__", [](const Expression& a, double b) { return frep::pow(Expression(b), a); }, py::is_operator())
      .def(
          "__mod__", [](const Expression& a, const Expression& b) { return frep::mod(a, b); }, py::is_operator())
      .def("__abs__", [](const Expression& a) { return frep::abs(a); })
      .def(
          "__or__", [](const Expression& a, const Expression& b) { return frep::min(a, b); }, py::is_operator(), "union")
      .def(
          "__and__", [](const Expression& a, const Expression& b) { return frep::max(a, b); }, py::is_operator(), "intersection")
      .def(
          "__invert__", [](const Expression& a) { return -a; }, "complement")
      .def(
          "__eq__", [](const Expression& a, const Expression& b) { return a == b; }, py::is_operator(),
          "Whether both are the same formula, node for node.")
      .def("__hash__", [](const Expression& a) { return std::hash<const void*>{}(a.id()); })
      .def("__str__", text_of)
      .def("__repr__",
           [](const Expression& a) { return "<fieldfab.Expression of " + std::to_string(frep::node_count(a)) + " nodes>"; })
      .def(
          "math", [](const Expression& a) { return frep::print_math(a); }, "The formula as a prefix math string.")
      .def(
          "vm", [](const Expression& a) { return frep::print_vm(a); }, "The formula as a .vm program.")
      .def("simplified", [](const Expression& a) { return frep::simplify(a); })
      .def("node_count", [](const Expression& a) { return frep::node_count(a); })
      .def(
          "map",
          [](const Expression& a, std::optional<Expression> x, std::optional<Expression> y, std::optional<Expression> z) {
            return frep::remap(a, x.value_or(Expression::x()), y.value_or(Expression::y()), z.value_or(Expression::z()));
          },
          py::arg("x") = py::none(), py::arg("y") = py::none(), py::arg("z") = py::none(),
          "The formula with x, y and z replaced; None leaves a coordinate as it is.")
      .def("__call__", evaluate, py::arg("x"), py::arg("y"), py::arg("z"),
           "Values at points, in single precision; arrays broadcast as NumPy's do.");
  py::implicitly_convertible<double, Expression>();
  py::implicitly_convertible<int, Expression>();

  module.attr("X") = Expression::x();
  module.attr("Y") = Expression::y();
  module.attr("Z") = Expression::z();
  module.def("parse", parse_any, py::arg("text"), "Reads .frep text or a prefix math string.");
  module.def(
      "parse_math", [](const std::string& text) { return frep::parse_math(text); }, py::arg("text"));
  module.def(
      "parse_vm", [](const std::string& text) { return frep::parse_vm(text); }, py::arg("text"));
  module.def(
      "parse_infix", [](const std::string& text) { return frep::parse_infix(text); }, py::arg("text"));

  using Unary = Expression (*)(const Expression&);
  for (const auto& [name, function] : std::initializer_list<std::pair<const char*, Unary>>{{"sin", frep::sin},
                                                                                           {"cos", frep::cos},
                                                                                           {"tan", frep::tan},
                                                                                           {"asin", frep::asin},
                                                                                           {"acos", frep::acos},
                                                                                           {"atan", frep::atan},
                                                                                           {"sqrt", frep::sqrt},
                                                                                           {"square", frep::square},
                                                                                           {"exp", frep::exp},
                                                                                           {"ln", frep::ln},
                                                                                           {"floor", frep::floor},
                                                                                           {"ceil", frep::ceil}})
    module.def(name, function, py::arg("value"));
  using Binary = Expression (*)(const Expression&, const Expression&);
  for (const auto& [name, function] : std::initializer_list<std::pair<const char*, Binary>>{
           {"minimum", frep::min}, {"maximum", frep::max}, {"atan2", frep::atan2}, {"compare", frep::compare}})
    module.def(name, function, py::arg("a"), py::arg("b"));

  namespace s = frep::shapes;
  auto shapes =
      module.def_submodule("shapes", "Shapes and what is done with them, as expressions. Lengths in mm, angles in radians.");
  const auto a = [](const char* name) { return py::arg(name); };
  shapes.def("sphere", s::sphere, a("radius"), "Centred; exact distance.");
  shapes.def("box", s::box, a("dx"), a("dy"), a("dz"), "Centred; a bound of the distance.");
  shapes.def("rounded_box", s::rounded_box, a("dx"), a("dy"), a("dz"), a("radius"), "Centred; exact distance outside.");
  shapes.def("cylinder", s::cylinder, a("radius"), a("height"), "Along z, centred; a bound.");
  shapes.def("cone", s::cone, a("radius"), a("height"), "Along z, base down, centred; a bound.");
  shapes.def("torus", s::torus, a("ring"), a("tube"), "Ring in the xy plane; exact distance.");
  shapes.def("capsule", s::capsule, a("radius"), a("length"), "Along z, centred; exact distance.");
  shapes.def("half_space", s::half_space, a("nx"), a("ny"), a("nz"), a("offset"), "Below a plane; exact distance.");
  shapes.def("circle", s::circle, a("radius"), "Flat; exact distance.");
  shapes.def("rectangle", s::rectangle, a("dx"), a("dy"), "Flat, centred; a bound.");
  shapes.def("rounded_rectangle", s::rounded_rectangle, a("dx"), a("dy"), a("radius"), "Flat, centred; exact distance outside.");
  shapes.def("polygon", s::polygon, a("sides"), a("radius"), "Flat, regular, corners at `radius`; a bound.");
  shapes.def("extrude", s::extrude, a("shape"), a("low"), a("high"), "A flat shape from z = low to z = high.");
  shapes.def("revolve", s::revolve, a("shape"), "A flat shape turned about its y axis, which becomes z.");
  shapes.def("gyroid", s::gyroid, a("period"), "Neither exact nor a bound; give it walls with shell().");
  shapes.def("schwarz_p", s::schwarz_p, a("period"), "Neither exact nor a bound.");
  shapes.def("diamond", s::diamond, a("period"), "Neither exact nor a bound.");
  shapes.def("union", s::unite, a("a"), a("b"));
  shapes.def("intersection", s::intersect, a("a"), a("b"));
  shapes.def("difference", s::subtract, a("a"), a("b"));
  shapes.def("offset", s::offset, a("shape"), a("distance"), "Grown by `distance`.");
  shapes.def("shell", s::shell, a("shape"), a("thickness"), "A wall about the surface.");
  shapes.def("blend", s::blend, a("a"), a("b"), a("radius"), "Union with a rounded seam (Keeter, Table 3.3).");
  shapes.def("smooth_union", s::smooth_unite, a("a"), a("b"), a("radius"), "Union with a circular fillet.");
  shapes.def("morph", s::morph, a("a"), a("b"), a("weight"), "a at 0, b at 1.");
  shapes.def("move", s::move, a("shape"), py::arg("dx") = 0.0, py::arg("dy") = 0.0, py::arg("dz") = 0.0);
  shapes.def("rotate_x", s::rotate_x, a("shape"), a("angle"));
  shapes.def("rotate_y", s::rotate_y, a("shape"), a("angle"));
  shapes.def("rotate_z", s::rotate_z, a("shape"), a("angle"));
  shapes.def("scale", s::scale, a("shape"), a("factor"), "Keeps distances.");
  shapes.def("scale_xyz", s::scale_xyz, a("shape"), a("sx"), a("sy"), a("sz"), "Does not keep distances.");
  shapes.def("mirror_x", s::mirror_x, a("shape"));
  shapes.def("mirror_y", s::mirror_y, a("shape"));
  shapes.def("mirror_z", s::mirror_z, a("shape"));
  shapes.def("twist", s::twist, a("shape"), a("angle"), "About z, by `angle` radians a mm.");
  shapes.def("taper", s::taper, a("shape"), a("height"), a("factor"), "Full size at z = 0, `factor` at z = height.");
  shapes.def("repeat_x", s::repeat_x, a("shape"), a("period"), "Without end.");
  shapes.def("repeat_y", s::repeat_y, a("shape"), a("period"), "Without end.");
  shapes.def("repeat_z", s::repeat_z, a("shape"), a("period"), "Without end.");
}

}  // namespace fieldfab::python
