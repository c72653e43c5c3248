#include "program_file.h"

#include <algorithm>
#include <cctype>

#include "fieldfab/core/error.h"
#include "fieldfab/core/lower_case.h"

namespace fieldfab::cam {
namespace {

std::string_view text_of(const MappedFile& file) {
  return {reinterpret_cast<const char*>(file.bytes().data()), file.bytes().size()};
}

/// State of the control before a program with this many lines starts.
ReadingOptions reading_options(const SimulationSetup& setup, int lines) {
  ReadingOptions options;
  options.work_offsets = setup.work_offsets;
  options.start = setup.start;
  options.dialect = setup.machine.dialect;
  options.inch = setup.inch;
  options.home = setup.home;
  options.most_blocks = 10'000'000 + 10 * static_cast<std::uint64_t>(lines);
  for (const auto& [number, tool] : setup.tools) options.tools[number] = {Vec3(0, 0, tool.length), tool.diameter};
  return options;
}

MappedFile opened(const std::filesystem::path& path) {
  if (lower_case(path.extension().string()) == ".tpl")
    throw Error(ErrorKind::bad_input, path.string(), "programs in JavaScript (TPL) are not run");
  return MappedFile(path);
}

}  // namespace

ProgramFile::ProgramFile(const std::filesystem::path& path) : path_(path), file_(opened(path)) {
  const std::string_view text = text_of(file_);
  lines_ = static_cast<int>(std::min<std::ptrdiff_t>(std::count(text.begin(), text.end(), '\n') + 1, 2'000'000'000));
}

std::vector<ReadingNote> ProgramFile::read(const SimulationSetup& setup, const MotionSink& sink,
                                           Progress& progress) const {
  const std::string name = path_.string(), extension = lower_case(path_.extension().string());
  const ReadingOptions options = reading_options(setup, lines_);
  const std::string_view text = text_of(file_);
  const double tick = setup.machine.tick > 0 ? setup.machine.tick : 0.025;
  if (extension == ".sbp") return read_sbp(text, name, options, setup.machine.unit, sink, progress);
  if (extension == ".rml") return read_rml(text, name, options, tick, sink, progress);
  if (extension == ".plt" || extension == ".hpgl" || extension == ".camm" || extension == ".epi" || extension == ".gcc")
    return read_hpgl(text, name, options, tick, setup.pen_up, setup.pen_down, sink, progress);
  return read_gcode(text, name, options, sink, progress);
}

}  // namespace fieldfab::cam
