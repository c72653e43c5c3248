#include <nlohmann/json.hpp>

#include "fieldfab/cam/simulate/report_json.h"

namespace fieldfab::cam {
namespace {

nlohmann::ordered_json json_of(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

nlohmann::ordered_json json_of(const SimulationReport& report, bool with_lines) {
  // The program of a line is given only if there are several programs.
  const auto with_program = [&](int program, nlohmann::ordered_json row) {
    if (report.programs.size() > 1) row["program"] = program;
    return row;
  };
  auto events = nlohmann::ordered_json::array();
  for (const SimulationEvent& e : report.events)
    events.push_back(with_program(e.move.program, {{"kind", name_of(e.kind)},
                                                   {"line", e.move.line},
                                                   {"first_line", e.first_line},
                                                   {"last_line", e.last_line},
                                                   {"tool", e.move.tool},
                                                   {"place", json_of(e.place)},
                                                   {"amount", e.amount},
                                                   {"message", e.message}}));
  auto notes = nlohmann::ordered_json::array();
  for (const SimulationNote& note : report.notes)
    notes.push_back(with_program(note.program, {{"line", note.line}, {"message", note.message}}));
  nlohmann::ordered_json json{{"good", report.good()},
                              {"events", events},
                              {"notes", notes},
                              {"moves", report.moves},
                              {"poses", report.poses},
                              {"seconds", report.seconds},
                              {"rapid_seconds", report.rapid_seconds},
                              {"cut", report.cut},
                              {"air", report.air},
                              {"air_share", report.air_share()},
                              {"rapid", report.rapid},
                              {"removed", report.removed},
                              {"left", report.left},
                              {"cells", report.stock.cells},
                              {"splits", report.stock.splits},
                              {"bytes", report.stock.bytes}};
  if (report.programs.size() > 1) {
    auto programs = nlohmann::ordered_json::array();
    for (const std::filesystem::path& program : report.programs) programs.push_back(program.string());
    json["programs"] = std::move(programs);
  }
  if (report.deviation) {
    const Deviation& d = *report.deviation;
    json["deviation"] = {
        {"deepest_gouge", d.deepest}, {"highest_excess", d.highest}, {"mean", d.mean}, {"rms", d.root_mean_square}};
  }
  if (with_lines) {
    auto lines = nlohmann::ordered_json::array();
    for (const LineRecord& line : report.lines)
      lines.push_back(with_program(line.program, {{"line", line.line},
                                                  {"tool", line.tool},
                                                  {"removed", line.removed},
                                                  {"seconds", line.seconds},
                                                  {"cut", line.cut},
                                                  {"air", line.air}}));
    json["lines"] = std::move(lines);
  }
  return json;
}

std::string to_json(const SimulationReport& report, bool with_lines) {
  // programs may contain any bytes
  constexpr auto replace = nlohmann::ordered_json::error_handler_t::replace;
  return json_of(report, with_lines).dump(1, ' ', false, replace) + "\n";
}

}  // namespace fieldfab::cam
