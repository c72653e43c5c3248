#include "mixed_field.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>

#include "fieldfab/field/operations.h"
#include "frame.h"

namespace fieldfab::frep {
namespace {

using Places = std::set<std::size_t>;  // of nodes, in topological order

class MixedFieldMaker {
 public:
  MixedFieldMaker(const Expression& root, const std::function<FieldPtr(const Expression&)>& make_pure)
      : make_pure_(make_pure), flat_(flatten(root)), fields_(flat_.order.size()) {
    expressions_.reserve(flat_.order.size());
    for (std::size_t i = 0; i < flat_.order.size(); ++i) {
      const Flat::Entry& entry = flat_.order[i];
      expressions_.push_back(made_again(entry, expressions_));
      bool mixed = entry.op == Opcode::opened;
      for (const std::size_t argument : arguments(i)) mixed = mixed || mixed_[argument];
      mixed_.push_back(mixed);
    }
  }

  FieldPtr make() {
    // Arguments first, without recursion, so that depth is not limited. Entries of fields_ stay
    // empty for nodes that are not needed.
    std::vector<std::size_t> stack{flat_.order.size() - 1};
    while (!stack.empty()) {
      const std::size_t node = stack.back();
      if (fields_[node] != nullptr) {
        stack.pop_back();
        continue;
      }
      const Plan plan = plan_of(node);
      bool ready = true;
      for (const std::size_t part : plan.parts)
        if (fields_[part] == nullptr) stack.push_back(part), ready = false;
      if (!ready) continue;
      fields_[node] = carried_out(node, plan);
      stack.pop_back();
    }
    return fields_.back();
  }

 private:
  /// Construction of a node's Field from the Fields of other nodes.
  struct Plan {
    enum class Kind { pure, source, moved, mapped, unite, intersect, complement, offset, scaled, formula } kind;
    std::vector<std::size_t> parts = {};
    double number = 0;
  };

  [[nodiscard]] std::vector<std::size_t> arguments(std::size_t node) const {
    const Flat::Entry& entry = flat_.order[node];
    const std::array<std::size_t, 3> all{entry.a, entry.b, entry.c};
    return {all.begin(), all.begin() + info(entry.op).arity};
  }

  [[nodiscard]] std::optional<double> constant(std::size_t node) const {
    if (flat_.order[node].op != Opcode::constant) return std::nullopt;
    return flat_.order[node].constant;
  }

  [[nodiscard]] std::optional<Eigen::Affine3d> placement(const Flat::Entry& entry) const {
    return affine_map(expressions_[entry.a], expressions_[entry.b], expressions_[entry.c]);
  }

  Plan plan_of(std::size_t node) const {
    using Kind = Plan::Kind;
    if (!mixed_[node]) return {Kind::pure};
    const Flat::Entry& entry = flat_.order[node];
    switch (entry.op) {
      case Opcode::opened: {
        const auto placed = placement(entry);
        if (!placed) return {Kind::mapped, arguments(node)};
        return {placed->matrix() == Eigen::Matrix4d::Identity() ? Kind::source : Kind::moved};
      }
      case Opcode::minimum:
      case Opcode::maximum:
        if (shares_nothing(entry.a, entry.b))
          return {entry.op == Opcode::minimum ? Kind::unite : Kind::intersect, {entry.a, entry.b}};
        break;
      case Opcode::negate: return {Kind::complement, {entry.a}};
      case Opcode::add:
        if (const auto b = constant(entry.b)) return {Kind::offset, {entry.a}, -*b};
        if (const auto a = constant(entry.a)) return {Kind::offset, {entry.b}, -*a};
        break;
      case Opcode::subtract:
        if (const auto b = constant(entry.b)) return {Kind::offset, {entry.a}, *b};
        break;
      case Opcode::multiply:
        if (const auto b = constant(entry.b); b && *b > 0) return {Kind::scaled, {entry.a}, *b};
        if (const auto a = constant(entry.a); a && *a > 0) return {Kind::scaled, {entry.b}, *a};
        break;
      default: break;
    }
    return {Kind::formula, cut_below(node)};
  }

  /// Whether no mixed node is below both. As operations over Fields such a node would be evaluated
  /// twice, and its arguments four times.
  [[nodiscard]] bool shares_nothing(std::size_t a, std::size_t b) const {
    const auto below = [&](std::size_t node) {
      Places all, front{node};
      while (!front.empty()) {
        const std::size_t next = *front.rbegin();
        front.erase(next);
        if (!mixed_[next] || !all.insert(next).second) continue;
        for (const std::size_t argument : arguments(next)) front.insert(argument);
      }
      return all;
    };
    const Places of_a = below(a);
    for (const std::size_t node : below(b))
      if (of_a.contains(node)) return false;
    return true;
  }

  /// Returns at most three nodes, the inputs of a tape, such that the node is a formula of them.
  /// The cut is as low as possible, so that shared nodes are evaluated once. A formula without
  /// opened Fields is one of the inputs, or is above the cut if it is a constant.
  [[nodiscard]] std::vector<std::size_t> cut_below(std::size_t node) const {
    Places front;
    const auto open = [&](std::size_t opened) {
      for (const std::size_t argument : arguments(opened))
        if (flat_.order[argument].op != Opcode::constant) front.insert(argument);
    };
    open(node);
    Places best = front;
    for (;;) {
      // The latest in topological order: all nodes that use it have been opened.
      const auto next = std::find_if(front.rbegin(), front.rend(),
                                     [&](std::size_t i) { return mixed_[i] && flat_.order[i].op != Opcode::opened; });
      constexpr std::size_t widest = 24;
      if (next == front.rend() || front.size() > widest) break;
      const std::size_t opened = *next;
      front.erase(opened);
      open(opened);
      if (front.size() <= 3) best = front;
    }
    return {best.begin(), best.end()};
  }

  FieldPtr carried_out(std::size_t node, const Plan& plan) {
    using Kind = Plan::Kind;
    const auto part = [&](std::size_t i) { return fields_[plan.parts[i]]; };
    const Flat::Entry& entry = flat_.order[node];
    switch (plan.kind) {
      case Kind::pure: return make_pure_(expressions_[node]);
      case Kind::source: return entry.source->field;
      case Kind::moved: return transform(entry.source->field, placement(entry)->inverse());
      case Kind::mapped: return map(entry.source->field, part(0), part(1), part(2));
      case Kind::unite: return unite(part(0), part(1));
      case Kind::intersect: return intersect(part(0), part(1));
      case Kind::complement: return complement(part(0));
      case Kind::offset: return offset(part(0), plan.number);
      case Kind::scaled: return scaled_values(part(0), plan.number);
      case Kind::formula: break;
    }
    // The node as a formula of its parts, which are x, y and z in it.
    const std::array<Expression, 3> axis{Expression::x(), Expression::y(), Expression::z()};
    std::map<std::size_t, Expression> rewritten;
    for (std::size_t i = 0; i < plan.parts.size(); ++i) rewritten.emplace(plan.parts[i], axis[i]);
    std::vector<std::size_t> stack{node};
    while (!stack.empty()) {
      const std::size_t next = stack.back();
      if (rewritten.contains(next)) {
        stack.pop_back();
        continue;
      }
      const std::vector<std::size_t> given = arguments(next);
      bool ready = true;
      for (const std::size_t argument : given)
        if (!rewritten.contains(argument)) stack.push_back(argument), ready = false;
      if (!ready) continue;
      const Opcode op = flat_.order[next].op;
      const auto of = [&](std::size_t i) -> const Expression& { return rewritten.at(given[i]); };
      rewritten.emplace(next, given.empty()       ? expressions_[next]
                              : given.size() == 1 ? Expression::make(op, of(0))
                                                  : Expression::make(op, of(0), of(1)));
      stack.pop_back();
    }
    const FieldPtr none = plan.parts.size() < 3 ? make_pure_(0.0) : nullptr;
    const auto part_or_none = [&](std::size_t i) { return i < plan.parts.size() ? part(i) : none; };
    return map(make_pure_(rewritten.at(node)), part_or_none(0), part_or_none(1), part_or_none(2));
  }

  const std::function<FieldPtr(const Expression&)>& make_pure_;
  Flat flat_;
  std::vector<Expression> expressions_;
  std::vector<bool> mixed_;
  std::vector<FieldPtr> fields_;
};

}  // namespace

FieldPtr make_mixed_field(const Expression& expression, const std::function<FieldPtr(const Expression&)>& make_pure) {
  return MixedFieldMaker(expression, make_pure).make();
}

}  // namespace fieldfab::frep
