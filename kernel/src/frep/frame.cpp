#include "frame.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace fieldfab::frep {
namespace {

using Gradient = Eigen::RowVector3d;

/// slope * p + shift; only meaningful where `holds`.
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
  const Form &a = forms[entry.a], &b = forms[entry.b];
  const auto scaled = [](const Form& form, double by) { return Form{form.slope * by, form.shift * by, std::isfinite(by)}; };
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

/// A direction that linear forms have, and how many of them have it.
struct Direction {
  Gradient along;
  int forms;
};

/// Up to three independent directions, the ones of most forms first, and what completes them.
Eigen::Matrix3d choose_rows(std::vector<Direction> directions) {
  std::stable_sort(directions.begin(), directions.end(), [](const auto& a, const auto& b) { return a.forms > b.forms; });
  Eigen::Matrix3d rows;
  int chosen = 0;
  const auto consider = [&](const Gradient& along) {
    constexpr double least_angle = 0.1;
    Gradient rest = along;
    if (chosen == 1) rest -= rest.dot(rows.row(0)) * rows.row(0);
    if (chosen == 2) {
      const Gradient normal = rows.row(0).cross(rows.row(1)).normalized();
      rest = rest.dot(normal) * normal;
    }
    if (chosen < 3 && rest.norm() > least_angle) rows.row(chosen++) = along;
  };
  for (const Direction& direction : directions) consider(direction.along);
  for (const Gradient& along : {Gradient(Gradient::UnitX()), Gradient(Gradient::UnitY()), Gradient(Gradient::UnitZ())}) {
    Gradient across = along;
    for (int i = 0; i < chosen && chosen < 3; ++i) across -= across.dot(rows.row(i)) * rows.row(i);
    if (chosen < 3 && across.norm() > 0.1) consider(across.normalized());
  }
  return rows;
}

Expression written(const Form& form) {
  const std::array<Expression, 3> axis{Expression::x(), Expression::y(), Expression::z()};
  Expression sum(form.shift);
  const double negligible = 1e-12 * form.slope.norm();  // what inverting the frame leaves
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

  // The largest linear forms: those that something else than a larger one is made from.
  std::vector<char> is_used(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const Flat::Entry& entry = flat.order[i];
    const int arity = info(entry.op).arity;
    if (forms[i].holds) continue;
    if (arity > 0) is_used[entry.a] = 1;
    if (arity > 1) is_used[entry.b] = 1;
  }
  std::vector<Direction> directions;
  bool is_straight = true;
  for (std::size_t i = 0; i < count; ++i) {
    if (is_used[i] == 0 || !forms[i].holds || forms[i].is_constant() || !forms[i].slope.allFinite()) continue;
    const Gradient along = forms[i].slope.normalized();
    is_straight = is_straight && along.cwiseAbs().maxCoeff() > 1 - 1e-9;
    const auto same = std::find_if(directions.begin(), directions.end(),
                                   [&](const auto& d) { return std::abs(d.along.dot(along)) > 1 - 1e-9; });
    constexpr std::size_t most = 64;  // more are not worth the search
    if (same != directions.end())
      ++same->forms;
    else if (directions.size() < most)
      directions.push_back({along, 1});
  }
  if (is_straight) return std::nullopt;

  const Eigen::Matrix3d axes = choose_rows(std::move(directions)).inverse();
  std::vector<Expression> fresh;
  fresh.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Flat::Entry& entry = flat.order[i];
    if (forms[i].holds) {
      const bool finite = forms[i].slope.allFinite() && std::isfinite(forms[i].shift);
      if (is_used[i] != 0 && !finite) return std::nullopt;
      fresh.push_back(is_used[i] != 0 ? written({forms[i].slope * axes, forms[i].shift, true}) : Expression(0.0));
    } else if (info(entry.op).arity == 1) {
      fresh.push_back(Expression::make(entry.op, fresh[entry.a]));
    } else {
      fresh.push_back(Expression::make(entry.op, fresh[entry.a], fresh[entry.b]));
    }
  }
  if (forms.back().holds) return std::nullopt;  // a half-space
  return FramedExpression{fresh.back(), axes};
}

}  // namespace fieldfab::frep
