// Boolean combinations of parts, and their properties as a whole.
#include <algorithm>

#include "assembly.h"
#include "fieldfab/core/error.h"
#include "fieldfab/field/operations.h"
#include "leaf.h"

namespace fieldfab::openscad {
namespace {

using Kind = Part::Kind;

PartPtr joined(Kind kind, std::vector<PartPtr> parts) {
  if (parts.size() == 1) return parts.front();
  auto part = std::make_shared<Part>();
  part->kind = kind;
  part->children = std::move(parts);
  return part;
}

/// Joins by halves, so that the tree is flat.
template <class Join>
FieldPtr joined(std::span<const FieldPtr> all, const Join& join) {
  if (all.size() == 1) return all.front();
  return join(joined(all.first(all.size() / 2), join), joined(all.subspan(all.size() / 2), join));
}

/// Sets the least steepness and the box: for a union the box around all, otherwise the common box.
void tell_where(Shape& result, const std::vector<Shape>& all, bool is_union) {
  result.box = all.front().box;
  for (const Shape& solid : all) {
    result.steepness = std::min(result.steepness, solid.steepness);
    result.box = is_union ? hull(result.box, solid.box) : intersection(result.box, solid.box);
  }
  if (!result.box.valid()) result.box = all.front().box;  // they do not overlap
}

template <class JoinFormulas, class JoinFields>
Shape joined(const std::vector<Shape>& all, const JoinFormulas& join_formulas, const JoinFields& join_fields) {
  std::vector<frep::Expression> formulas;
  std::vector<FieldPtr> fields;
  for (const Shape& solid : all) {
    if (solid.formula) formulas.push_back(*solid.formula);
    if (solid.field) fields.push_back(solid.field);
  }
  while (formulas.size() > 1) {
    std::vector<frep::Expression> half;
    for (std::size_t i = 0; i + 1 < formulas.size(); i += 2)
      half.push_back(join_formulas(formulas[i], formulas[i + 1]));
    if (formulas.size() % 2 == 1) half.push_back(formulas.back());
    formulas = std::move(half);
  }
  Shape result;
  if (!formulas.empty()) result.formula = formulas.front();
  if (fields.empty()) return result;
  if (result.formula) fields.push_back(result.as_field());
  return {std::nullopt, joined(std::span<const FieldPtr>(fields), join_fields)};
}

Shape united(const std::vector<Shape>& all, const Making& making) {
  constexpr std::size_t few = 3;  // with more solids a search by position is faster
  Shape result;
  if (all.size() <= few || making.formulas_only) {
    result = joined(
        all, [](const auto& a, const auto& b) { return min(a, b); },
        [](const FieldPtr& a, const FieldPtr& b) { return fieldfab::unite(a, b); });
  } else {
    std::vector<Placed> parts;
    for (const Shape& solid : all) parts.push_back({solid.as_field(), solid.box, solid.steepness});
    result.field = assembly(std::move(parts));
  }
  tell_where(result, all, true);
  return result;
}

bool meet(const Box& a, const Box& b) { return intersection(a, b).valid(); }

}  // namespace

PartPtr nothing() { return std::make_shared<Part>(); }

PartPtr part_of(LeafPtr leaf) {
  if (leaf == nullptr) return nothing();
  auto part = std::make_shared<Part>();
  part->kind = Kind::leaf;
  part->leaf = std::move(leaf);
  return part;
}

PartPtr unite(std::vector<PartPtr> parts) {
  std::erase_if(parts, [](const PartPtr& part) { return part->empty(); });
  if (parts.empty()) return nothing();
  return joined(Kind::unite, std::move(parts));
}

PartPtr intersect(std::vector<PartPtr> parts) {
  if (parts.empty() || std::any_of(parts.begin(), parts.end(), [](const PartPtr& part) { return part->empty(); }))
    return nothing();
  return joined(Kind::intersect, std::move(parts));
}

PartPtr subtract(std::vector<PartPtr> parts) {
  if (parts.empty() || parts.front()->empty()) return nothing();
  const PartPtr first = parts.front();
  const Box box = bounds_of(*first);
  std::erase_if(parts,
                [&](const PartPtr& part) { return part->empty() || (part != first && !meet(box, bounds_of(*part))); });
  return joined(Kind::subtract, std::move(parts));
}

Box bounds_of(const Part& part) {
  if (part.kind == Kind::leaf) return part.leaf->bounds();
  Box box = bounds_of(*part.children.front());
  if (part.kind == Kind::subtract) return box;
  for (std::size_t i = 1; i < part.children.size(); ++i) {
    const Box other = bounds_of(*part.children[i]);
    if (part.kind == Kind::unite)
      box = hull(box, other);
    else if (meet(box, other))
      box = intersection(box, other);
    else
      box = {box.lower, box.lower};  // empty intersection
  }
  return box;
}

double thickness_of(const Part& part) {
  if (part.kind == Kind::leaf) return part.leaf->thickness();
  double least = std::numeric_limits<double>::infinity();
  for (const PartPtr& child : part.children) least = std::min(least, thickness_of(*child));
  return least;
}

double area_of(const Part& part) {
  if (part.kind == Kind::leaf) return part.leaf->area();
  double sum = 0;
  for (const PartPtr& child : part.children) sum += area_of(*child);
  return sum;
}

Shape solid_of(const Part& part, const Making& making) {
  making.progress->check();
  if (part.kind == Kind::nothing) return {};
  if (part.kind == Kind::leaf) {
    Shape solid = part.leaf->solid(making);
    solid.box = part.leaf->bounds().grown(2 * making.growth);
    solid.steepness = part.leaf->steepness();
    return solid;
  }
  std::vector<Shape> solids;
  for (std::size_t i = 0; i < part.children.size(); ++i) {
    Making here = making;
    if (part.kind == Kind::subtract && i > 0) here.growth += making.step;
    solids.push_back(solid_of(*part.children[i], here));
  }
  if (part.kind == Kind::unite) return united(solids, making);
  Shape result;
  if (part.kind == Kind::intersect) {
    result = joined(
        solids, [](const auto& a, const auto& b) { return max(a, b); },
        [](const FieldPtr& a, const FieldPtr& b) { return fieldfab::intersect(a, b); });
    tell_where(result, solids, false);
    return result;
  }
  const Shape others = united({solids.begin() + 1, solids.end()}, making);
  const Shape& first = solids.front();
  if (first.formula && others.formula)
    result.formula = max(*first.formula, -*others.formula);
  else
    result.field = fieldfab::subtract(first.as_field(), others.as_field());
  tell_where(result, {first}, true);
  return result;
}

std::vector<Polyhedron> pieces_of(const Part& part, bool& all_convex, Progress& progress) {
  if (part.kind == Kind::nothing) return {};
  if (part.kind == Kind::leaf) {
    Polyhedron solid = part.leaf->polyhedron();
    all_convex = all_convex && (part.leaf->convex() || is_convex(solid));
    return {std::move(solid)};
  }
  if (part.kind == Kind::unite) {
    std::vector<Polyhedron> all;
    for (const PartPtr& child : part.children)
      for (Polyhedron& solid : pieces_of(*child, all_convex, progress)) all.push_back(std::move(solid));
    return all;
  }
  Polyhedron solid = polyhedron_of(part, progress);
  if (solid.empty()) return {};
  all_convex = all_convex && is_convex(solid);
  return {std::move(solid)};
}

Region slice_of(const Part& part, Progress& progress) {
  progress.check();
  if (part.kind == Kind::nothing) return {};
  if (part.kind == Kind::leaf) {
    const Box box = part.leaf->bounds();
    if (box.lower.z() > 0 || box.upper.z() < 0) return {};
    return slice(part.leaf->polyhedron());
  }
  std::vector<Region> regions;
  for (const PartPtr& child : part.children) regions.push_back(slice_of(*child, progress));
  return part.kind == Kind::unite       ? unite(regions)
         : part.kind == Kind::intersect ? intersect(regions)
                                        : subtract(regions);
}

}  // namespace fieldfab::openscad
