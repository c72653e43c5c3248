// Boolean combination of two layers.
#include <fmt/format.h>

#include "../solids.h"
#include "all.h"
#include "fieldfab/core/error.h"
#include "fieldfab/field/operations.h"

namespace fieldfab::meshlab {
namespace {

std::vector<Parameter> combine_parameters(const Document& document) {
  const double diagonal = document.chosen().bounds.valid() ? document.chosen().bounds.diagonal() : 100;
  std::size_t other = 0;
  if (document.layers.size() > 1 && document.current == 0) other = 1;
  std::vector<Parameter> rows{
      choice_parameter("Operation", "Operation", "Boolean operation of the two layers.",
                       {"union", "intersection", "difference (first without second)"}),
      layer_parameter("First", "First layer", "The layer from which a difference subtracts.", document.current),
      layer_parameter("Second", "Second layer", "The layer that a difference subtracts.", other),
      length_parameter("Radius", "Smooth (mm)",
                       "How far a fillet reaches where the two surfaces meet; 0 makes a sharp seam.", 0, 0, diagonal)};
  for (Parameter& row : fineness_parameters(document)) rows.push_back(std::move(row));
  return rows;
}

FieldPtr joined(int operation, const FieldPtr& a, const FieldPtr& b, double radius) {
  const auto join = [&](const FieldPtr& one, const FieldPtr& two) {
    return radius > 0 ? blend(one, two, radius) : unite(one, two);
  };
  if (operation == 0) return join(a, b);
  if (operation == 1) return complement(join(complement(a), complement(b)));
  return complement(join(complement(a), b));
}

/// Returns the exact combination of two drawn parts; nullopt if one is not drawn, or if the result
/// is not the surface of a solid.
std::optional<Layer> exactly_joined(const Layer& first, const Layer& second, int operation, const Fineness& fineness,
                                    const std::string& name, std::vector<std::string>& log, Progress& progress) {
  std::vector<std::string> said;
  const auto a = exact_solid_of(first, fineness, said, progress);
  const auto b = a ? exact_solid_of(second, fineness, said, progress) : std::nullopt;
  if (!b) return std::nullopt;
  constexpr Operation operations[] = {Operation::unite, Operation::intersect, Operation::subtract};
  try {
    auto layer = layer_of(combined(*a, *b, operations[operation]), name);
    if (layer) log.insert(log.end(), said.begin(), said.end());
    return layer;
  } catch (const Error&) {  // faces that only touch, or too many of them
    return std::nullopt;
  }
}

Layer joined_as_fields(const Layer& first, const Layer& second, int operation, double radius, const Fineness& fineness,
                       const std::string& name, std::vector<std::string>& log, Progress& progress) {
  const Solid a = solid_of(first, fineness, radius, log, progress),
              b = solid_of(second, fineness, radius, log, progress);
  const FieldPtr both = joined(operation, a.field, b.field, radius);
  const Box bounds = operation == 2 ? *a.bounds : hull(*a.bounds, *b.bounds);
  return layer_of(both, bounds, fineness, is_sharp(a) || is_sharp(b), name, log, progress);
}

Result run_combine(const Values& values, Progress& progress) {
  Result result;
  const Fineness fineness = fineness_of(values);
  const double radius = values.not_negative("Radius");
  const int operation = values.whole("Operation");
  if (operation < 0 || operation > 2)
    throw Error(ErrorKind::bad_input, "Operation", fmt::format("is 0, 1 or 2, not {}", operation));
  const Layer &first = values.layer("First"), &second = values.layer("Second");
  constexpr const char* words[] = {"with", "and", "without"};
  const std::string name = fmt::format("{} {} {}", first.name, words[operation], second.name);
  std::optional<Layer> made;
  if (radius == 0) made = exactly_joined(first, second, operation, fineness, name, result.log, progress);
  if (!made) made = joined_as_fields(first, second, operation, radius, fineness, name, result.log, progress);
  result.add(std::move(*made));
  return result;
}

}  // namespace

Filter combine_layers() {
  return {"Fieldfab: Boolean of two layers",
          "Union, intersection or difference of the solids of two layers, sharp or with a fillet. The layers may be "
          "open, intersect themselves or have coplanar faces; the result is always a closed mesh. It is a new "
          "layer.",
          Filter::Group::remeshing,
          true,
          false,
          combine_parameters,
          run_combine};
}

}  // namespace fieldfab::meshlab
