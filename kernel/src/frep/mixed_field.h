/// Formulas in which opened Fields occur, as Fields.
#pragma once

#include <functional>

#include "fieldfab/field/field.h"
#include "fieldfab/frep/expression.h"

namespace fieldfab::frep {

/// The Field of an expression that has_opened(): sets, moves and offsets become operations over Fields, so that intervals, slopes
/// and frames stay as tight as those of the parts; formulas without an opened Field are made by `make_pure`, as tapes.
FieldPtr make_mixed_field(const Expression& expression, const std::function<FieldPtr(const Expression&)>& make_pure);

}  // namespace fieldfab::frep
