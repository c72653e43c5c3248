// Execution of a job: each operation through its chain of stages, ordering, linking, and output.
#include "fieldfab/cam/job/job.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fieldfab/cam/plan/planned_stock.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/core/angle.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/mesh/triangle_mesh.h"
#include "fieldfab/render/render.h"

namespace fieldfab::cam {
namespace {

std::string text_of(const Value& value) {
  if (const bool* const flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const double* const number = std::get_if<double>(&value))
    return *number == unset ? "by itself" : fmt::format("{:.6g}", *number);
  if (const auto* const text = std::get_if<std::string>(&value)) return *text;
  return fmt::format("[{:.6g}]", fmt::join(std::get<std::vector<double>>(value), ", "));
}

LinkSettings link_settings(const PlannedOperation& op, const PlannedCuts& cuts, const Box& stock,
                           const Material& material) {
  LinkSettings s;
  const Values& v = op.values;
  const double radius = op.tool.diameter / 2;
  // Above the stock, and above paths that are higher than it.
  double top = stock.upper.z();
  for (const Path& path : cuts.paths)
    for (const PathPoint& p : path.points) top = std::max(top, p.at.z());
  // The holder of a tilted tool is lower than that of a vertical one.
  const double wide = std::max({op.tool.holder_diameter, op.tool.shank, op.tool.diameter}) / 2;
  s.clearance = top + v.number("clearance") + wide * std::sin(cuts.leans);
  s.helix_radius = op.tool.helix_radius();
  s.feed = v.number("feed"), s.plunge = v.number("plunge");
  s.link_feed = is_set(v, "link_feed") ? v.number("link_feed") : s.feed;
  const std::string& entry = v.text("entry");
  s.entry = entry == "ramp" ? Entry::ramp : entry == "helix" ? Entry::helix : Entry::plunge;
  s.ramp_angle = to_radians(v.number("ramp_angle"));
  s.above = std::min(s.above, v.number("clearance"));
  s.material = [&material, radius](const Path& path) {
    return material.highest(path.points.front().at.head<2>(), radius);
  };
  s.may_stay_down = cuts.may_stay_down;
  return s;
}

}  // namespace

std::string Job::plan() const {
  std::string out = fmt::format("{}: {} -> {}\n", file_, name_of(static_cast<Kind>(input_.index())), machine_.name);
  for (const PlannedOperation& op : operations_) {
    out +=
        fmt::format("\n{}: {}", op.name, name_of(static_cast<Kind>((op.own_input ? *op.own_input : input_).index())));
    for (const Stage* stage : op.stages) out += fmt::format(" -> [{}] -> {}", stage->name, name_of(stage->makes));
    out += fmt::format(" -> [order] -> [link] -> [{}]\n", machine_.name);
    for (const auto& [name, given] : op.values.given)
      out += fmt::format("  {:<18} {:<14} {}\n", name, text_of(given.value),
                         fmt::format("{} {}", given.from, given.place));
  }
  if (!machine_values_.given.empty()) out += fmt::format("\n{}\n", machine_.name);
  for (const auto& [name, given] : machine_values_.given)
    out += fmt::format("  {:<18} {:<14} {}\n", name, text_of(given.value), given.from);
  return out;
}

namespace {

/// The input in a plane's coordinates.
Artifact seen_from(const Artifact& input, const Plane& plane) {
  const auto* const solid = std::get_if<Solid>(&input);
  if (solid == nullptr || (plane.is_top() && !plane.to_the_middle)) return input;
  Eigen::Affine3d back = Eigen::Affine3d::Identity();
  back.linear() = plane.axes.transpose();
  back.translation() = -plane.origin;
  Box bounds = plane.into(*solid->bounds);
  if (plane.to_the_middle) bounds.lower.z() = bounds.centre().z();
  return solid_of(transform(solid->field, back), "part", bounds);
}

}  // namespace

/// Runs the operations in sequence and stores their common data.
class JobRunner {
 public:
  JobRunner(Job& job, Progress& progress) : job_(job), progress_(progress), left_(stock_of(job)) {
    if (job.feed_limits_)
      measured_.emplace(job.saved_stock_ ? *job.saved_stock_
                                         : Stock(job.stock_, {.cell = StockSettings::usual_cell(job.stock_)}));
  }

  void run() {
    for (const PlannedOperation& op : job_.operations_) add(op);
    job_.program_.stock = job_.stock_;
    join_planes();
  }

 private:
  /// Runs the chain of stages. Operations share the results of the first stages if their settings
  /// are equal.
  Artifact through_stages(const PlannedOperation& op, Context& context) {
    Artifact artifact = seen_from(op.own_input ? *op.own_input : job_.input_, op.plane);
    std::string key = op.plane.name;
    if (op.own_input) key += op.name;
    for (const Stage* stage : op.stages) {
      progress_.report(0, stage->name);
      key += fmt::format("/{}/{:.17g}", stage->name, stage->operation ? 0.0 : op.tool.diameter);
      for (const Setting& setting : stage->settings) {
        const Value& value = op.values.given.at(setting.name).value;
        const double* const exact = std::get_if<double>(&value);
        key += exact != nullptr ? fmt::format("/{:.17g}", *exact) : fmt::format("/{}", text_of(value));
      }
      if (const auto known = made_.find(key); known != made_.end()) {
        artifact = known->second;
        continue;
      }
      try {
        artifact = stage->run(artifact, op.values, context);
      } catch (const Error& error) {
        if (error.kind() != ErrorKind::bad_input) throw;
        throw Error(error.kind(), op.values.place("type"), fmt::format("{}: {}", op.name, error.what()));
      }
      if (!stage->operation) made_[key] = artifact;
    }
    return artifact;
  }

  void add(const PlannedOperation& op) {
    const Box stock = op.plane.into(job_.stock_);
    const auto* const solid = std::get_if<Solid>(op.own_input ? &*op.own_input : &job_.input_);
    const Material material = left_.seen_from(op.plane, progress_);
    Context context{op.tool,
                    stock,
                    op.plane,
                    solid != nullptr ? solid->field : nullptr,
                    [&]() -> const FreeSpace& { return space_about(*solid); },
                    material,
                    earlier_,
                    progress_,
                    job_.notes_};
    PlannedCuts cuts = std::get<PlannedCuts>(through_stages(op, context));
    OperationReport report;
    report.name = op.name;
    if (!cuts.ordered) {
      OrderSettings settings;
      settings.inside_first = cuts.inside_first;
      settings.may_reverse = cuts.may_reverse;
      report.air = order(cuts.paths, settings, progress_);
    }
    Section section;
    section.name = op.name;
    section.tool = op.tool;
    section.spindle = op.values.number("spindle");
    section.coolant = coolant_named(op.values.text("coolant"), op.values.place("coolant"));
    const LinkSettings linking = link_settings(op, cuts, stock, material);
    section.clearance = linking.clearance;
    section.drills = cuts.drills;
    section.moves = link(cuts.paths, linking);
    if (section.moves.empty()) {
      job_.notes_.push_back(fmt::format("{}: there is nothing left to cut", op.name));
      return;
    }
    const bool too_deep = cuts.leans == 0 && may_be_too_deep(section.moves, op.tool, op.plane, job_.stock_);
    const bool complete = !too_deep || back_out(op, section);
    if (section.moves.size() < 2) {
      job_.notes_.push_back(fmt::format("{}: nothing of it is left", op.name));
      return;
    }
    if (op.plane.setup && op.plane.name != setup_)
      section.setup = fmt::format(
          "turn the stock so that its {} is up; zero is {:.3f} mm from its left, {:.3f} mm from its front, {:.3f} mm "
          "below its "
          "top",
          op.plane.name, -stock.lower.x(), -stock.lower.y(), stock.upper.z());
    setup_ = op.plane.setup ? op.plane.name : "";
    if (!too_deep && op.tool.diameter > 0 && &op != &job_.operations_.back())
      left_.cut(section.moves, op.tool, op.plane, progress_);
    if (measured_ && op.tool.diameter > 0) {
      report.planned_seconds = duration(placed(section.moves, op.plane, 0.005), job_.machine_.dynamics);
      FeedReport removed;
      section.moves =
          measured_->adjust(section.moves, op.tool, op.plane, cuts.width > 0 ? cuts.width : op.tool.diameter,
                            *job_.feed_limits_, removed, progress_);
    }
    section.moves = placed(section.moves, op.plane, 0.005);
    report.paths = cuts.paths.size();
    report.length = lengths(section.moves);
    report.seconds = duration(section.moves, job_.machine_.dynamics);
    job_.reports_.push_back(report);
    job_.program_.sections.push_back(std::move(section));
    clearances_.push_back(op.values.number("clearance"));
    if (cuts.finished && complete) earlier_.emplace_back(op.plane, cuts.finished, 0.5);
  }

  /// Keeps the shank clear of material: if the tool is too short, it cuts less deep, and a note
  /// reports the remaining material. Returns false in that case. A holder that meets material is an
  /// error.
  bool back_out(const PlannedOperation& op, Section& section) {
    progress_.report(0, "deep cuts");
    BackedOut report;
    section.moves = left_.back_out(section.moves, op.tool, op.plane, op.values.number("plunge"), report, progress_);
    if (report.holder)
      throw Error(
          ErrorKind::bad_input, op.values.place("type"),
          fmt::format(
              "{}: the holder of tool {} meets material at x {:.2f}, y {:.2f}, z {:.2f} of the tip; the tool reaches "
              "{:.4g} mm out of it",
              op.name, op.tool.number, report.holder->x(), report.holder->y(), report.holder->z(), op.tool.length));
    if (report.length == 0) return true;
    const Box at =
        op.plane.setup ? report.places : image_of(report.places, op.plane.axes, op.plane.axes * op.plane.origin);
    job_.notes_.push_back(fmt::format(
        "{}: tool {} is too short with flutes of {:.4g} mm: along {:.0f} mm of its way it stays up to {:.2f} mm "
        "higher than planned; {:.3g} mm3 are left, between ({:.2f}, {:.2f}, {:.2f}) and ({:.2f}, {:.2f}, {:.2f})",
        op.name, op.tool.number, op.tool.flute, report.length, report.most, report.left, at.lower.x(), at.lower.y(),
        at.lower.z(), at.upper.x(), at.upper.y(), at.upper.z()));
    return false;
  }

  const FreeSpace& space_about(const Solid& solid) {
    auto& space = spaces_[solid.field.get()];
    if (!space) space = std::make_unique<FreeSpace>(solid.field, solid.bounds->grown(1e-3), progress_);
    return *space;
  }

  /// The stock at the start: saved, or a box with cells as fine as the smallest tool requires, within
  /// a limit of memory.
  static PlannedStock stock_of(const Job& job) {
    if (job.saved_stock_) return PlannedStock(*job.saved_stock_);
    const double longest = job.stock_.size().maxCoeff(), usual = StockSettings::usual_cell(job.stock_);
    double cell = longest / 100;
    for (const PlannedOperation& op : job.operations_)
      if (op.tool.diameter > 0) cell = std::min(cell, op.tool.diameter / 16);
    cell = std::max({cell, longest / 1000, 1e-3});
    // Deep cuts need the cells of a simulation: at once, if they cost little more.
    if (cell < 1.5 * usual) cell = std::min(cell, usual);
    // Drawings may have no thickness.
    Box box = job.stock_;
    box.lower = box.lower.cwiseMin(Vec3(box.upper.array() - cell));
    return {box, cell};
  }

  /// Adds moves (Algorithm 6.1) at each change of the tool's direction, and to the vertical at the
  /// end.
  void join_planes() {
    auto& sections = job_.program_.sections;
    const Kinematics& k = job_.machine_.kinematics;
    const auto arm = [&](const Section& s) {
      return k.kind == Kinematics::Kind::table_table ? 0.0 : k.pivot + s.tool.length;
    };
    const auto high = [&](const Section& s, const Move& near) {
      return Move{{near.to.x(), near.to.y(), job_.stock_.upper.z() + s.tool.length + 50}, 0, 0, Vec3::UnitZ()};
    };
    for (std::size_t i = 0; i < sections.size(); ++i) {
      if (!sections[i].tilted() && (i == 0 || !sections[i - 1].tilted())) continue;
      const Move from = i == 0 ? high(sections[0], sections[0].moves.front()) : sections[i - 1].moves.back();
      const auto moves = transfer(from, sections[i].moves.front(), job_.stock_, clearances_[i], arm(sections[i]));
      sections[i].moves.insert(sections[i].moves.begin(), moves.begin(), moves.end());
    }
    if (sections.empty() || !sections.back().tilted()) return;
    Section& last = sections.back();
    const Move end = last.moves.back();
    const auto moves = transfer(end, high(last, end), job_.stock_, 5, arm(last));
    last.moves.insert(last.moves.end(), moves.begin(), moves.end());
  }

  Job& job_;
  Progress& progress_;
  std::map<std::string, Artifact> made_;
  std::map<const Field*, std::unique_ptr<FreeSpace>> spaces_;  // by part
  PlannedStock left_;
  std::vector<Reached> earlier_;
  std::vector<double> clearances_;  // of each section
  std::string setup_;               // orientation of the work
  std::optional<MeasuredStock> measured_;
};

void Job::run(Progress& progress) {
  program_.sections.clear();
  reports_.clear();
  JobRunner(*this, progress).run();
}

void Job::write(const std::filesystem::path& path, Progress& progress) const {
  if (machine_.takes == MachineInput::mesh || machine_.takes == MachineInput::height_map) {
    const Solid* const part = solid();
    if (part == nullptr || part->flat)
      throw Error(ErrorKind::bad_input, file_,
                  fmt::format("{} takes a {}: the input must be a solid", machine_.name, name_of(machine_.takes)));
    if (machine_.takes == MachineInput::height_map) {
      RenderSettings settings;
      settings.mode = RenderMode::height;
      settings.size = 2048;
      return write_png(render(*part->field, *part->bounds, settings, progress), path);
    }
    const double longest = part->bounds->size().maxCoeff(), voxel = machine_values_.number("voxel");
    return write_mesh(
        contour(*part->field, part->bounds->grown(longest / 64), {voxel > 0 ? voxel : longest / 200}, progress), path,
        progress);
  }
  std::string text;
  try {
    text = write_program(program_, machine_, machine_values_);
  } catch (const Error& error) {
    // Errors of the machine refer to the line that selects it.
    if (error.place() != "machine") throw;
    throw Error(error.kind(), machine_place_, error.what());
  }
  write_file(path, text);
}

}  // namespace fieldfab::cam
