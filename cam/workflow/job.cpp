// Running a job: each operation down its chain of stages, ordering, linking; and writing what comes out.
#include "fieldfab/cam/job.h"

#include <fmt/format.h>

#include <algorithm>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/mesh/contour.h"
#include "fieldfab/mesh/triangle_mesh.h"
#include "fieldfab/render/render.h"
#include "unset.h"

namespace fieldfab::cam {
namespace {

std::string text_of(const Value& value) {
  if (const bool* const flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const double* const number = std::get_if<double>(&value)) return *number == unset ? "by itself" : fmt::format("{:.6g}", *number);
  if (const auto* const text = std::get_if<std::string>(&value)) return *text;
  return fmt::format("[{:.6g}]", fmt::join(std::get<std::vector<double>>(value), ", "));
}

LinkSettings link_settings(const PlannedOperation& op, const Cuts& cuts, const Box& stock) {
  LinkSettings s;
  const Values& v = op.values;
  s.clearance = stock.upper.z() + v.number("clearance");
  s.feed = v.number("feed"), s.plunge = v.number("plunge");
  const std::string& entry = v.text("entry");
  s.entry = entry == "ramp" ? Entry::ramp : entry == "helix" ? Entry::helix : Entry::plunge;
  s.ramp_angle = v.number("ramp_angle") * 3.14159265358979323846 / 180;
  s.above = std::min(s.above, v.number("clearance"));
  const double top = stock.upper.z();
  s.material = [top](const Path&) { return top; };
  s.may_stay_down = cuts.may_stay_down;
  return s;
}

void check_depth(const PlannedOperation& op, const Section& section, const Box& stock) {
  double deepest = stock.upper.z();
  for (const Move& move : section.moves) deepest = std::min(deepest, move.to.z());
  const double depth = stock.upper.z() - deepest;
  if (op.tool.flute > 0 && depth > op.tool.flute + 1e-6)
    throw Error(ErrorKind::bad_input, op.name, fmt::format("cuts {:.4g} mm deep; tool {} has flutes of {:.4g} mm", depth, op.tool.number, op.tool.flute));
  if (op.tool.length > 0 && depth > op.tool.length + 1e-6)
    throw Error(ErrorKind::bad_input, op.name, fmt::format("goes {:.4g} mm deep; tool {} reaches {:.4g} mm out of its holder", depth, op.tool.number, op.tool.length));
}

}  // namespace

std::string Job::plan() const {
  std::string out = fmt::format("{}: {} -> {}\n", file_, name_of(static_cast<Kind>(input_.index())), machine_.name);
  for (const PlannedOperation& op : operations_) {
    out += fmt::format("\n{}: {}", op.name, name_of(static_cast<Kind>(input_.index())));
    for (const Stage* stage : op.stages) out += fmt::format(" -> [{}] -> {}", stage->name, name_of(stage->makes));
    out += fmt::format(" -> [order] -> [link] -> [{}]\n", machine_.name);
    for (const auto& [name, given] : op.values.given) out += fmt::format("  {:<18} {:<14} {}\n", name, text_of(given.value), fmt::format("{} {}", given.from, given.place));
  }
  if (!machine_values_.given.empty()) out += fmt::format("\n{}\n", machine_.name);
  for (const auto& [name, given] : machine_values_.given) out += fmt::format("  {:<18} {:<14} {}\n", name, text_of(given.value), given.from);
  return out;
}

void Job::run(Progress& progress) {
  program_.sections.clear();
  reports_.clear();
  // Operations share what the first stages made of the input, where their settings are the same.
  std::map<std::string, Artifact> made;
  for (const PlannedOperation& op : operations_) {
    Context context{op.tool, stock_, progress, notes_};
    Artifact artifact = input_;
    std::string key;
    for (const Stage* stage : op.stages) {
      progress.report(0, stage->name);
      key += fmt::format("{}/{:.17g}", stage->name, stage->operation ? 0.0 : op.tool.diameter);
      for (const Setting& setting : stage->settings) key += fmt::format("/{}", text_of(op.values.given.at(setting.name).value));
      if (const auto known = made.find(key); known != made.end()) {
        artifact = known->second;
        continue;
      }
      try {
        artifact = stage->run(artifact, op.values, context);
      } catch (const Error& error) {
        if (error.kind() != ErrorKind::bad_input) throw;
        throw Error(error.kind(), op.values.place("type"), fmt::format("{}: {}", op.name, error.what()));
      }
      if (!stage->operation) made[key] = artifact;
    }
    Cuts& cuts = std::get<Cuts>(artifact);
    OperationReport report;
    report.name = op.name;
    if (!cuts.ordered) {
      OrderSettings settings;
      settings.inside_first = cuts.inside_first;
      settings.may_reverse = cuts.may_reverse;
      report.air = order(cuts.paths, settings, progress);
    }
    Section section;
    section.name = op.name;
    section.tool = op.tool;
    section.spindle = op.values.number("spindle");
    section.coolant = op.values.text("coolant") == "none" ? "" : op.values.text("coolant");
    section.clearance = stock_.upper.z() + op.values.number("clearance");
    section.moves = link(cuts.paths, link_settings(op, cuts, stock_));
    check_depth(op, section, stock_);
    report.paths = cuts.paths.size();
    report.length = lengths(section.moves);
    report.seconds = duration(section.moves, machine_.dynamics);
    reports_.push_back(report);
    program_.sections.push_back(std::move(section));
  }
  program_.stock = stock_;
}

void Job::write(const std::filesystem::path& path, Progress& progress) const {
  if (machine_.takes == "mesh" || machine_.takes == "height map") {
    const Solid* const part = solid();
    if (part == nullptr || part->flat) throw Error(ErrorKind::bad_input, file_, fmt::format("{} takes a {}: the input must be a solid", machine_.name, machine_.takes));
    if (machine_.takes == "height map") {
      RenderSettings settings;
      settings.mode = RenderMode::height;
      settings.size = 2048;
      return write_png(render(*part->field, part->bounds, settings, progress), path);
    }
    const double longest = part->bounds.size().maxCoeff(), voxel = machine_values_.number("voxel");
    return write_mesh(contour(*part->field, part->bounds.grown(longest / 64), {voxel > 0 ? voxel : longest / 200}, progress), path, progress);
  }
  write_file(path, write_program(program_, machine_, machine_values_));
}

}  // namespace fieldfab::cam
