#include "infix_library.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "fieldfab/core/error.h"
#include "fieldfab/frep/shapes.h"

namespace fieldfab::frep {
namespace {

using Arguments = std::span<const Expression>;
const double degree = std::numbers::pi / 180;

Function::Parameter required(std::string_view name) { return {name, std::nullopt}; }

/// An argument that must be a plain number, such as a count.
double number(const Expression& argument, const char* what) {
  const Expression value = simplify(argument);
  if (value.opcode() != Opcode::constant) throw Error(ErrorKind::bad_input, "", std::string(what) + " must be a plain number");
  return value.constant();
}

std::vector<Function> make_functions() {
  using namespace shapes;
  std::vector<Function> all;
  // The operations themselves, taken as they are written.
  for (int i = static_cast<int>(Opcode::sine); i < opcode_count; ++i) {
    const auto op = static_cast<Opcode>(i);
    const OpcodeInfo& about = info(op);
    if (op == Opcode::negate || op == Opcode::minimum || op == Opcode::maximum) continue;
    if (about.arity == 1)
      all.push_back({about.infix, {required("value")}, [op](Arguments a) { return Expression::make(op, a[0]); }});
    else if (about.infix.size() > 1)
      all.push_back(
          {about.infix, {required("a"), required("b")}, [op](Arguments a) { return Expression::make(op, a[0], a[1]); }});
  }
  const auto chain = [&](std::string_view name, Opcode op) {
    all.push_back({name,
                   {required("a"), required("b")},
                   [op](Arguments a) {
                     Expression result = a[0];
                     for (std::size_t i = 1; i < a.size(); ++i) result = Expression::make(op, result, a[i]);
                     return result;
                   },
                   true});
  };
  chain("min", Opcode::minimum);
  chain("max", Opcode::maximum);
  chain("union", Opcode::minimum);
  chain("intersection", Opcode::maximum);
  all.push_back({"difference",
                 {required("a"), required("b")},
                 [](Arguments a) {
                   Expression result = a[0];
                   for (std::size_t i = 1; i < a.size(); ++i) result = shapes::subtract(result, a[i]);
                   return result;
                 },
                 true});
  all.push_back({"pow", {required("a"), required("b")}, [](Arguments a) { return Expression::make(Opcode::power, a[0], a[1]); }});

  all.push_back({"sphere", {{"r", 1}}, [](Arguments a) { return sphere(a[0]); }});
  all.push_back({"box", {{"dx", 1}, {"dy", 1}, {"dz", 1}}, [](Arguments a) { return box(a[0], a[1], a[2]); }});
  all.push_back({"rounded_box", {{"dx", 1}, {"dy", 1}, {"dz", 1}, {"r", 0.1}}, [](Arguments a) {
                   return rounded_box(a[0], a[1], a[2], a[3]);
                 }});
  all.push_back({"cylinder", {{"r", 1}, {"h", 1}}, [](Arguments a) { return cylinder(a[0], a[1]); }});
  all.push_back({"cone", {{"r", 1}, {"h", 1}}, [](Arguments a) { return cone(a[0], a[1]); }});
  all.push_back({"torus", {{"R", 1}, {"r", 0.25}}, [](Arguments a) { return torus(a[0], a[1]); }});
  all.push_back({"capsule", {{"r", 1}, {"length", 1}}, [](Arguments a) { return capsule(a[0], a[1]); }});
  all.push_back({"plane", {{"nx", 0}, {"ny", 0}, {"nz", 1}, {"offset", 0}}, [](Arguments a) {
                   return half_space(a[0], a[1], a[2], a[3]);
                 }});
  all.push_back({"circle", {{"r", 1}}, [](Arguments a) { return circle(a[0]); }});
  all.push_back({"rectangle", {{"dx", 1}, {"dy", 1}}, [](Arguments a) { return rectangle(a[0], a[1]); }});
  all.push_back(
      {"rounded_rectangle", {{"dx", 1}, {"dy", 1}, {"r", 0.1}}, [](Arguments a) { return rounded_rectangle(a[0], a[1], a[2]); }});
  all.push_back({"polygon", {{"sides", 6}, {"r", 1}}, [](Arguments a) {
                   return polygon(static_cast<int>(std::clamp(number(a[0], "the number of sides"), 0.0, 1e6)),
                                  number(a[1], "the radius of a polygon"));
                 }});
  all.push_back({"extrude", {required("shape"), {"h", 1}}, [](Arguments a) { return extrude(a[0], 0.0, a[1]); }});
  all.push_back({"revolve", {required("shape")}, [](Arguments a) { return revolve(a[0]); }});
  all.push_back({"gyroid", {{"period", 1}}, [](Arguments a) { return gyroid(a[0]); }});
  all.push_back({"schwarz_p", {{"period", 1}}, [](Arguments a) { return schwarz_p(a[0]); }});
  all.push_back({"diamond", {{"period", 1}}, [](Arguments a) { return diamond(a[0]); }});

  all.push_back({"offset", {required("shape"), required("distance")}, [](Arguments a) { return offset(a[0], a[1]); }});
  all.push_back({"shell", {required("shape"), required("thickness")}, [](Arguments a) { return shell(a[0], a[1]); }});
  all.push_back({"blend", {required("a"), required("b"), {"r", 1}}, [](Arguments a) { return blend(a[0], a[1], a[2]); }});
  all.push_back(
      {"smooth_union", {required("a"), required("b"), {"r", 1}}, [](Arguments a) { return smooth_unite(a[0], a[1], a[2]); }});
  all.push_back({"morph", {required("a"), required("b"), {"weight", 0.5}}, [](Arguments a) { return morph(a[0], a[1], a[2]); }});

  all.push_back(
      {"move", {required("shape"), {"dx", 0}, {"dy", 0}, {"dz", 0}}, [](Arguments a) { return move(a[0], a[1], a[2], a[3]); }});
  all.push_back(
      {"rotate_x", {required("shape"), required("degrees")}, [](Arguments a) { return rotate_x(a[0], a[1] * degree); }});
  all.push_back(
      {"rotate_y", {required("shape"), required("degrees")}, [](Arguments a) { return rotate_y(a[0], a[1] * degree); }});
  all.push_back(
      {"rotate_z", {required("shape"), required("degrees")}, [](Arguments a) { return rotate_z(a[0], a[1] * degree); }});
  all.push_back({"scale", {required("shape"), required("factor")}, [](Arguments a) { return scale(a[0], a[1]); }});
  all.push_back({"scale_xyz", {required("shape"), {"sx", 1}, {"sy", 1}, {"sz", 1}}, [](Arguments a) {
                   return scale_xyz(a[0], a[1], a[2], a[3]);
                 }});
  all.push_back({"mirror_x", {required("shape")}, [](Arguments a) { return mirror_x(a[0]); }});
  all.push_back({"mirror_y", {required("shape")}, [](Arguments a) { return mirror_y(a[0]); }});
  all.push_back({"mirror_z", {required("shape")}, [](Arguments a) { return mirror_z(a[0]); }});
  all.push_back(
      {"twist", {required("shape"), required("degrees_per_mm")}, [](Arguments a) { return twist(a[0], a[1] * degree); }});
  all.push_back({"taper", {required("shape"), required("height"), required("factor")}, [](Arguments a) {
                   return taper(a[0], a[1], a[2]);
                 }});
  all.push_back({"repeat_x", {required("shape"), required("period")}, [](Arguments a) { return repeat_x(a[0], a[1]); }});
  all.push_back({"repeat_y", {required("shape"), required("period")}, [](Arguments a) { return repeat_y(a[0], a[1]); }});
  all.push_back({"repeat_z", {required("shape"), required("period")}, [](Arguments a) { return repeat_z(a[0], a[1]); }});
  all.push_back({"map", {required("shape"), required("x"), required("y"), required("z")}, [](Arguments a) {
                   return remap(a[0], a[1], a[2], a[3]);
                 }});
  return all;
}

}  // namespace

const std::vector<Function>& all_functions() {
  static const std::vector<Function> functions = make_functions();
  return functions;
}

const Function* find_function(std::string_view name) {
  static const auto by_name = [] {
    std::unordered_map<std::string_view, const Function*> table;
    for (const Function& function : all_functions()) table.emplace(function.name, &function);
    return table;
  }();
  const auto found = by_name.find(name);
  return found == by_name.end() ? nullptr : found->second;
}

}  // namespace fieldfab::frep
