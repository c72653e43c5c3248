/// Fields of expressions, evaluated in batches over a tape that is pruned to the relevant clauses in each box.
#pragma once

#include <string_view>

#include "fieldfab/field/field.h"
#include "fieldfab/frep/expression.h"

namespace fieldfab::frep {

/// Evaluator of a tape. All evaluators give the same bits.
enum class Evaluator {
  /// the widest interpreter that the processor supports, and machine code for tapes that are evaluated often
  automatic,
  reference,   ///< one point at a time, by the code of the reference evaluator
  portable,    ///< vector loops for the baseline instruction set
  avx2,        ///< vector loops for AVX2
  avx512,      ///< vector loops for AVX-512 (F, DQ and VL)
  jit_avx2,    ///< machine code (JIT) for each tape, 8 floats wide
  jit_avx512,  ///< machine code for each tape, 16 floats wide
};
/// Whether this processor supports the evaluator.
bool available(Evaluator evaluator);
/// Returns "automatic", "reference", "portable", "avx2", "avx512", "jit-avx2" or "jit-avx512".
std::string_view name(Evaluator evaluator);
/// Returns the evaluator of that name. "jit" is the widest one that this processor supports. Throws Error(bad_input)
/// for another name.
Evaluator evaluator_named(std::string_view name);

/// Sets the evaluator that `automatic` selects for the whole process, for comparisons of evaluators. Throws
/// Error(bad_input) if this processor does not support it.
void set_default_evaluator(Evaluator evaluator);

/// Compiles an expression to a Field. Throws Error(bad_input) if this processor does not support the evaluator. Linear
/// in the number of nodes.
FieldPtr make_field(const Expression& expression, Evaluator evaluator = Evaluator::automatic);

/// Returns the number of active nodes in a Field of make_field() or in a restriction of one, for statistics (Fig. 3-4);
/// 0 for any other Field.
std::size_t active_nodes(const Field& field);

}  // namespace fieldfab::frep
