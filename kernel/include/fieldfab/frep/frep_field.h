/// An expression as a Field: evaluated in batches over a tape, pruned to the part that matters in a box.
#pragma once

#include <string_view>

#include "fieldfab/field/field.h"
#include "fieldfab/frep/expression.h"

namespace fieldfab::frep {

/// How a tape is evaluated in batches. All give the same bits.
enum class Evaluator {
  automatic,   ///< the best interpreter that this processor has, and machine code for what is evaluated often
  reference,   ///< one point after the other, by the reference evaluator's own code
  portable,    ///< vector loops for the baseline instruction set
  avx2,        ///< vector loops for AVX2
  avx512,      ///< vector loops for AVX-512 (F, DQ and VL)
  jit_avx2,    ///< machine code for everything
  jit_avx512,  ///< the same, 16 numbers wide
};
/// Whether this processor can run it.
bool available(Evaluator evaluator);
/// "automatic", "reference", "portable", "avx2", "avx512", "jit-avx2", "jit-avx512".
std::string_view name(Evaluator evaluator);
/// The evaluator of that name; "jit" is the widest that this processor has. Throws bad_input.
Evaluator evaluator_named(std::string_view name);

/// What `automatic` means from now on, unless make_field() is told otherwise: for trying evaluators on a whole program. Throws
/// bad_input for one this processor lacks.
void set_default_evaluator(Evaluator evaluator);

/// The solid of an expression. Throws bad_input for an evaluator this processor lacks. Linear in the number of nodes.
FieldPtr make_field(const Expression& expression, Evaluator evaluator = Evaluator::automatic);

/// Nodes still active in a Field made by make_field() or by restricting one: for statistics (Fig. 3-4). 0 for another Field.
std::size_t active_nodes(const Field& field);

}  // namespace fieldfab::frep
