/// Writers of write_program(), one per family of files.
#pragma once

#include "fieldfab/cam/machine/machine.h"

namespace fieldfab::cam {

/// A number with at most the given number of decimals, without trailing zeros.
std::string number_text(double value, int decimals);

std::string write_text(const Program& program, const Machine& machine, const Values& values);
std::string write_dxf(const Program& program);
std::string write_svg(const Program& program);

}  // namespace fieldfab::cam
