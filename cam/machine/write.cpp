// Selection of the writer for a machine.
#include <fmt/format.h>

#include "fieldfab/core/error.h"
#include "writers.h"

namespace fieldfab::cam {

std::string write_program(const Program& program, const Machine& machine, const Values& values) {
  switch (machine.format) {
    case FileFormat::text: return write_text(program, machine, values);
    case FileFormat::dxf: return write_dxf(program);
    case FileFormat::svg: return write_svg(program);
    case FileFormat::png:
    case FileFormat::stl: break;
  }
  throw Error(ErrorKind::bad_input, machine.file,
              fmt::format("a machine that takes {} has the format text, dxf or svg", name_of(machine.takes)));
}

}  // namespace fieldfab::cam
