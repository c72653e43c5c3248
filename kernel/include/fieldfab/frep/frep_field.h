/// An expression as a Field: evaluated in batches over a tape, pruned to the part that matters in a box.
#pragma once

#include <string_view>

#include "fieldfab/field/field.h"
#include "fieldfab/frep/expression.h"

namespace fieldfab::frep {

/// How a tape is evaluated in batches. All give the same bits.
enum class Evaluator {
  automatic,  ///< the best this processor has
  reference,  ///< one point after the other, by the reference evaluator's own code
  portable,   ///< vector loops for the baseline instruction set
  avx2,
  avx512,
};
/// The evaluator that `automatic` stands for on this processor.
Evaluator best_evaluator();
/// Whether this processor can run it.
bool available(Evaluator evaluator);
std::string_view name(Evaluator evaluator);

/// The solid of an expression. Throws bad_input for an evaluator this processor lacks. Linear in the number of nodes.
FieldPtr make_field(const Expression& expression, Evaluator evaluator = Evaluator::automatic);

/// Nodes still active in a Field made by make_field() or by restricting one: for statistics (Fig. 3-4). 0 for another Field.
std::size_t active_nodes(const Field& field);

}  // namespace fieldfab::frep
