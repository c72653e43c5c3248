#include "frame.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace fieldfab::frep {
namespace {

using Gradient = Eigen::RowVector3d;

/// slope * p + shift; valid only if `holds`.
struct Form {
  Gradient slope = Gradient::Zero();
  double shift = 0;
  bool holds = false;
  [[nodiscard]] bool is_constant() const { return slope.isZero(0); }
};

Form form_of(const Flat::Entry& entry, const std::vector<Form>& forms) {
  switch (entry.op) {
    case Opcode::constant: return {Gradient::Zero(), entry.constant, true};
    case Opcode::x: return {Gradient::UnitX(), 0, true};
    case Opcode::y: return {Gradient::UnitY(), 0, true};
    case Opcode::z: return {Gradient::UnitZ(), 0, true};
    default: break;
  }
  if (entry.op == Opcode::opened) return {};
  const Form &a = forms[entry.a], &b = forms[entry.b];
  const auto scaled = [](const Form& form, double by) {
    return Form{form.slope * by, form.shift * by, std::isfinite(by)};
  };
  if (!a.holds) return {};
  if (entry.op == Opcode::negate) return scaled(a, -1);
  if (info(entry.op).arity < 2 || !b.holds) return {};
  switch (entry.op) {
    case Opcode::add: return {a.slope + b.slope, a.shift + b.shift, true};
    case Opcode::subtract: return {a.slope - b.slope, a.shift - b.shift, true};
    case Opcode::multiply: return a.is_constant() ? scaled(b, a.shift) : b.is_constant() ? scaled(a, b.shift) : Form{};
    case Opcode::divide: return b.is_constant() ? scaled(a, 1 / b.shift) : Form{};
    default: return {};
  }
}

constexpr double parallel = 1 - 1e-9;  // a cosine

/// A direction of linear forms, and the number of forms with it.
struct Direction {
  Gradient along;
  int forms;
};

/// Returns three independent directions as rows, those of most forms first; axes fill the missing
/// ones.
Eigen::Matrix3d choose_rows(std::vector<Direction> directions) {
  std::stable_sort(directions.begin(), directions.end(),
                   [](const auto& a, const auto& b) { return a.forms > b.forms; });
  for (int axis = 0; axis < 3; ++axis) directions.push_back({Gradient::Unit(axis), 0});
  Eigen::Matrix3d rows, orthonormal;
  int chosen = 0;
  for (const Direction& direction : directions) {
    Gradient rest = direction.along;
    for (int i = 0; i < chosen; ++i) rest -= rest.dot(orthonormal.row(i)) * orthonormal.row(i);
    constexpr double least = 0.1;  // radians from the directions chosen
    if (chosen == 3 || rest.norm() < least) continue;
    rows.row(chosen) = direction.along;
    orthonormal.row(chosen++) = rest.normalized();
  }
  return rows;
}

bool is_finite(const Form& form) { return form.slope.allFinite() && std::isfinite(form.shift); }

Expression written(const Form& form) {
  const std::array<Expression, 3> axis{Expression::x(), Expression::y(), Expression::z()};
  Expression sum(form.shift);
  const double negligible = 1e-12 * form.slope.norm();  // rounding errors of the inverse of the frame
  for (int i = 0; i < 3; ++i)
    if (std::abs(form.slope[i]) > negligible) sum = sum + form.slope[i] * axis[static_cast<std::size_t>(i)];
  return sum;
}

}  // namespace

std::optional<FramedExpression> in_own_frame(const Expression& expression) {
  const Flat flat = flatten(expression);
  const std::size_t count = flat.order.size();
  std::vector<Form> forms(count);
  for (std::size_t i = 0; i < count; ++i) forms[i] = form_of(flat.order[i], forms);

  // The largest linear forms: arguments of operations that are not linear.
  std::vector<char> is_largest(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    if (forms[i].holds) continue;
    const Flat::Entry& entry = flat.order[i];
    const int arity = info(entry.op).arity;
    for (const std::uint32_t argument : {entry.a, arity == 2 ? entry.b : entry.a})
      is_largest[argument] = forms[argument].holds;
  }
  std::vector<Direction> directions;
  for (std::size_t i = 0; i < count; ++i) {
    if (is_largest[i] == 0 || forms[i].is_constant() || !is_finite(forms[i])) continue;
    const Gradient along = forms[i].slope.normalized();
    const auto same = std::find_if(directions.begin(), directions.end(),
                                   [&](const Direction& other) { return std::abs(other.along.dot(along)) > parallel; });
    constexpr std::size_t most = 64;  // more directions are not worth the search
    if (same != directions.end())
      ++same->forms;
    else if (directions.size() < most)
      directions.push_back({along, 1});
  }
  const auto is_axis = [](const Direction& direction) { return direction.along.cwiseAbs().maxCoeff() > parallel; };
  if (std::all_of(directions.begin(), directions.end(), is_axis)) return std::nullopt;

  const Eigen::Matrix3d axes = choose_rows(std::move(directions)).inverse();
  std::vector<Expression> fresh(count, Expression(0.0));
  for (std::size_t i = 0; i < count; ++i) {
    const Flat::Entry& entry = flat.order[i];
    if (is_largest[i] != 0) {
      const Form form{forms[i].slope * axes, forms[i].shift, true};
      if (!is_finite(form)) return std::nullopt;
      fresh[i] = written(form);
    } else if (!forms[i].holds) {
      fresh[i] = info(entry.op).arity == 1 ? Expression::make(entry.op, fresh[entry.a])
                                           : Expression::make(entry.op, fresh[entry.a], fresh[entry.b]);
    }
  }
  return FramedExpression{fresh.back(), axes};
}

std::optional<Eigen::Affine3d> affine_map(const Expression& x, const Expression& y, const Expression& z) {
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  int row = 0;
  for (const Expression* coordinate : {&x, &y, &z}) {
    const Flat flat = flatten(*coordinate);
    std::vector<Form> forms(flat.order.size());
    for (std::size_t i = 0; i < forms.size(); ++i) forms[i] = form_of(flat.order[i], forms);
    if (!forms.back().holds || !is_finite(forms.back())) return std::nullopt;
    map.linear().row(row) = forms.back().slope;
    map.translation()[row++] = forms.back().shift;
  }
  const double volume = map.linear().determinant();
  if (!std::isfinite(volume) || std::abs(volume) < 1e-12) return std::nullopt;
  return map;
}

std::vector<PlacedLeaf> leaves_of(const Expression& root) {
  std::vector<PlacedLeaf> leaves;
  const Flat flat = flatten(root);
  std::vector<Expression> made;
  made.reserve(flat.order.size());
  for (const Flat::Entry& entry : flat.order) {
    made.push_back(made_again(entry, made));
    if (entry.op == Opcode::opened)
      leaves.push_back({entry.source->shared_from_this(), affine_map(made[entry.a], made[entry.b], made[entry.c])});
  }
  return leaves;
}

}  // namespace fieldfab::frep
