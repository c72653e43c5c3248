/// Fields of formulas with opened Fields.
#pragma once

#include <functional>

#include "fieldfab/field/field.h"
#include "fieldfab/frep/expression.h"

namespace fieldfab::frep {

/// Returns the Field of an expression that has_opened(). Set operations, moves and offsets become
/// operations over Fields, so that intervals, slopes and frames stay as tight as those of the
/// parts. `make_pure` makes the Fields of formulas without opened Fields, as tapes.
FieldPtr make_mixed_field(const Expression& expression, const std::function<FieldPtr(const Expression&)>& make_pure);

}  // namespace fieldfab::frep
