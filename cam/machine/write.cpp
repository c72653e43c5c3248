// Which writer belongs to which machine.
#include <fmt/format.h>

#include "fieldfab/core/error.h"
#include "writers.h"

namespace fieldfab::cam {

std::string write_program(const Program& program, const Machine& machine, const Values& values) {
  if (machine.format == "text") return write_text(program, machine, values);
  if (machine.format == "dxf") return write_dxf(program);
  if (machine.format == "svg") return write_svg(program);
  throw Error(ErrorKind::bad_input, machine.file,
              fmt::format("there is no format '{}'; known are text, dxf, svg{}", machine.format,
                          suggestion(machine.format, {"text", "dxf", "svg"})));
}

}  // namespace fieldfab::cam
