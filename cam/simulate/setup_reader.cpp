#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/toml_table.h"
#include "base/tool_table.h"
#include "camotics_setup.h"
#include "fieldfab/cam/job/job.h"
#include "fieldfab/cam/plan/planes.h"
#include "fieldfab/cam/simulate/setup.h"
#include "fieldfab/core/angle.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/field/bounds.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/text.h"
#include "fieldfab/solid/open.h"

namespace fieldfab::cam {
namespace {

Placement placement_of(const Plane& plane) { return {plane.axes, plane.axes * plane.origin}; }

/// Whether a machine's template stops the program.
bool stops(const Machine& machine, const std::string& text) {
  const auto found = machine.text.find(text);
  if (found == machine.text.end()) return false;
  const std::string& t = found->second;
  return t.find("M0\n") != std::string::npos || t.find("PAUSE\r\n") != std::string::npos;
}

/// For a set-up that does not say where the machine's zero is: puts it above the work, where machines have it, so that
/// G53 G0 Z0 and G28 Z0 lift every tool off the stock, however that is turned. Program coordinates stay as they are.
void put_below_machine_zero(SimulationSetup& setup) {
  constexpr double margin = 50;  // mm between stock and the longest tool
  const Box& stock = setup.stock_box;
  double longest = 0;
  for (const auto& [number, tool] : setup.tools) longest = std::max(longest, tool.length);
  const double above = stock.lower.cwiseAbs().cwiseMax(stock.upper.cwiseAbs()).norm() + longest + margin;
  setup.zero.z() -= above;
  setup.start.at[2] -= above;
  setup.start_given = false;
  for (AxisValues& offset : setup.work_offsets) offset.at[2] -= above;
}

class SetupReader {
 public:
  SetupReader(const std::filesystem::path& path, FieldPtr part, Progress& progress, const Formats& formats)
      : path_(path),
        part_(std::move(part)),
        progress_(progress),
        formats_(formats),
        text_(read_file(path, 16 << 20)),
        table_(TomlTable::parse(text_, path.string())) {}

  SimulationSetup read() {
    setup_.file = path_.string();
    setup_.name = table_.text("name").value_or(path_.stem().string());
    if (!table_.tables("operation").empty() || table_.has("input")) {
      read_job();
    } else {
      table_.only({"name", "machine", "cell", "tolerance", "rules", "rapids", "stock", "target", "fixture", "tool",
                   "zero", "start", "home", "second_home", "work", "limits", "stop", "dialect", "programs"});
      for (const std::string& program : table_.texts("programs")) setup_.programs.push_back(beside(program));
      read_machine();
      if (const auto dialect = table_.text("dialect"))
        setup_.machine.dialect = dialect_named(*dialect, table_.place("dialect"));
      for (Tool& tool : read_tools(table_, path_.parent_path())) setup_.tools.emplace(tool.number, std::move(tool));
      read_stock();
      read_target();
      read_fixture();
      read_places();
      read_stops();
    }
    if (!knows_machine_zero()) put_below_machine_zero(setup_);
    if (!(setup_.sampling.cell > 0)) throw refuse(table_, "cell", "cell must be above 0");
    return std::move(setup_);
  }

 private:
  [[nodiscard]] static Error refuse(const TomlTable& table, const std::string& key, const std::string& what) {
    return {ErrorKind::bad_input, table.place(key), what};
  }
  [[nodiscard]] std::filesystem::path beside(const std::string& name) const {
    const std::filesystem::path p(name);
    return p.is_absolute() ? p : path_.parent_path() / p;
  }
  [[nodiscard]] static Vec3 vector(const TomlTable& table, const std::string& key, const std::vector<double>& list,
                                   std::size_t from = 0) {
    if (list.size() < from + 3) throw refuse(table, key, fmt::format("{} needs {} numbers", key, from + 3));
    return {list[from], list[from + 1], list[from + 2]};
  }

  void read_job() {
    const Job job = Job::parse(text_, path_, part_, progress_, formats_);
    setup_.machine = job.machine();
    setup_.stock_box = job.stock();
    setup_.zero = zero_of(job);
    setup_.target = target_of(job);
    setup_.sampling.cell = StockSettings::usual_cell(setup_.stock_box);
    // Tolerances of the job's paths and of its model of the part.
    double allowed = 0;
    for (const PlannedOperation& op : job.operations()) {
      double sum = 0;
      for (const char* key : {"tolerance", "surface_tolerance"})
        if (const auto found = op.values.given.find(key); found != op.values.given.end())
          if (const double* const number = std::get_if<double>(&found->second.value); number != nullptr && *number > 0)
            sum += *number;
      allowed = std::max(allowed, sum);
    }
    setup_.gouge += allowed + setup_.machine.tick;
    const Plane* lying = nullptr;
    int tool = 0;
    for (const PlannedOperation& op : job.operations()) {
      setup_.tools.emplace(op.tool.number, op.tool);
      if (op.plane.setup && (lying == nullptr || lying->name != op.plane.name)) {
        if (lying == nullptr && !stops(setup_.machine, "setup"))
          setup_.placement = placement_of(op.plane);
        else
          setup_.stops.push_back({0, placement_of(op.plane)});
        lying = &op.plane;
      }
      if (op.tool.number != tool && stops(setup_.machine, "tool_change"))
        setup_.stops.push_back({op.tool.number, std::nullopt});
      tool = op.tool.number;
      if (!setup_.first_tool) setup_.first_tool = tool;
    }
    // A beam cuts through the whole sheet.
    if (setup_.machine.takes == MachineInput::flat_paths) {
      const double over = 1;
      setup_.pen_up = setup_.stock_box.upper.z() + over, setup_.pen_down = setup_.stock_box.lower.z() - over;
      for (auto& [number, beam] : setup_.tools) {
        beam.flute = setup_.stock_box.size().z() + 3 * over;
        // A narrower slit could pass between samples. Along the thickness of the sheet one cell
        // suffices.
        if (beam.diameter > 0) setup_.sampling.cell = std::min(setup_.sampling.cell, beam.diameter / 2);
      }
      setup_.sampling.cell_height = setup_.stock_box.size().z() / 2;
    }
    limits_of_machine();
    if (job.saved_stock()) begin_with(*job.saved_stock());
    if (part_) leave_where_it_was(job.zero());
  }

  /// Shifts a job's set-up by its program's zero, so that a part given from outside keeps its
  /// place.
  void leave_where_it_was(const Vec3& zero) {
    if (zero.isZero()) return;
    if (setup_.saved)
      throw Error(ErrorKind::bad_input, path_.string(),
                  "where the stock is a saved one, the program's zero must be the model's");
    if (!setup_.stops.empty() || !setup_.placement.rotation.isIdentity())
      throw Error(ErrorKind::bad_input, path_.string(),
                  "where the part is turned over, the program's zero must be the model's");
    setup_.stock_box = {setup_.stock_box.lower + zero, setup_.stock_box.upper + zero};
    setup_.target = translate(setup_.target, zero);
    setup_.zero -= zero;
  }

  /// Position of the part's zero by the machine's settings.
  static Vec3 zero_of(const Job& job) {
    Vec3 zero = Vec3::Zero();
    for (const auto& [key, axis] : {std::pair{"xmin", 0}, std::pair{"ymin", 1}})
      if (const auto found = job.machine_values().given.find(key); found != job.machine_values().given.end())
        if (const double* const number = std::get_if<double>(&found->second.value)) zero[axis] = *number;
    return zero;
  }

  /// The target of a job: its part if that is a solid; for drawings everything that no operation
  /// may cut.
  static FieldPtr target_of(const Job& job) {
    const Solid* const solid = job.solid();
    if (solid == nullptr || !solid->flat) return solid ? solid->field : nullptr;
    FieldPtr left = box_field(job.stock());
    for (const PlannedOperation& op : job.operations()) {
      const auto* const drawing = op.own_input ? std::get_if<Solid>(&*op.own_input) : solid;
      const Stage& stage = *op.stages.back();
      if (drawing == nullptr || !drawing->flat || stage.may_cut == nullptr || op.plane.setup) return nullptr;
      const FieldPtr gone = stage.may_cut(drawing->field, op.values, job.stock());
      if (!gone) return nullptr;
      left = subtract(left, gone);
    }
    return left;
  }

  void read_machine() {
    const auto id = table_.text("machine");
    if (!id) return;
    try {
      setup_.machine = load_machine(id->ends_with(".toml") ? beside(*id).string() : *id);
    } catch (const Error& error) {
      if (error.place() != "machine") throw;
      throw refuse(table_, "machine", error.what());
    }
    limits_of_machine();
  }

  void limits_of_machine() {
    for (const RotaryAxis& axis : setup_.machine.kinematics.axes)
      if (axis.letter >= 'A' && axis.letter <= 'C')
        setup_.limits[static_cast<std::size_t>(axis.letter - 'A') + 3] = {axis.lower, axis.upper};
  }

  /// Whether the file says how high the machine's zero is.
  bool knows_machine_zero() const {
    const auto has = [&](const char* key) { return table_.has(key); };
    const auto limits = table_.table("limits");
    return std::ranges::any_of(std::array{"zero", "start", "home", "second_home", "work"}, has) ||
           (limits && limits->has("z"));
  }

  /// A model with its bounds, or those of the table.
  std::pair<FieldPtr, Box> read_model(const TomlTable& table) {
    const std::string name = *table.text("model");
    OpenSettings settings;
    settings.formats = &formats_;
    const Model model = open_model(beside(name), settings, progress_);
    const auto part = table.text("part");
    FieldPtr field = part ? part_of(model, *part, table.place("part")).field : united(model).field;
    if (const auto move = table.list("move")) field = translate(field, vector(table, "move", *move));
    Box box;
    if (const auto given = table.list("bounds")) {
      box = {vector(table, "bounds", *given), vector(table, "bounds", *given, 3)};
    } else {
      const SolidBounds found = solid_bounds(*field, progress_);
      if (found.empty) throw refuse(table, "model", fmt::format("{}: the solid is empty", name));
      if (!found.is_bounded())
        throw refuse(table, "model",
                     fmt::format("{}: the solid is unbounded; give bounds = [x0, y0, z0, x1, y1, z1]", name));
      box = found.box;
    }
    if (!box.valid()) throw refuse(table, "bounds", "bounds are x0, y0, z0, x1, y1, z1");
    return {field, box};
  }

  void read_stock() {
    const auto stock = table_.table("stock");
    if (!stock) throw refuse(table_, "", "a set-up needs a [stock]");
    stock->only({"lower", "upper", "cylinder", "model", "part", "move", "bounds", "file"});
    if (const auto file = stock->text("file")) {
      for (const char* const key : {"lower", "upper", "cylinder", "model", "part", "move", "bounds"})
        if (stock->has(key)) throw refuse(*stock, key, "a saved stock is as it is: file stands alone");
      for (const char* const key : {"cell", "tolerance", "rules"})
        if (table_.has(key)) throw refuse(table_, key, fmt::format("a saved stock has its own {}", key));
      return begin_with(cam::read_stock(beside(*file)));
    }
    if (const auto cylinder = stock->list("cylinder")) {
      if (cylinder->size() != 5) throw refuse(*stock, "cylinder", "cylinder is [x, y, radius, z from, z to]");
      const auto& c = *cylinder;
      setup_.stock_box = {{c[0] - c[2], c[1] - c[2], c[3]}, {c[0] + c[2], c[1] + c[2], c[4]}};
      if (!(c[2] > 0) || !(c[4] > c[3])) throw refuse(*stock, "cylinder", "cylinder is [x, y, radius, z from, z to]");
      setup_.stock = frep::make_field(frep::parse_infix(
          fmt::format("sqrt(square(x - ({:.17g})) + square(y - ({:.17g}))) - {:.17g}", c[0], c[1], c[2])));
    } else if (stock->has("model")) {
      std::tie(setup_.stock, setup_.stock_box) = read_model(*stock);
    } else {
      const auto lower = stock->list("lower"), upper = stock->list("upper");
      if (!lower || !upper) throw refuse(*stock, "", "the stock needs lower and upper corners, a cylinder or a model");
      setup_.stock_box = {vector(*stock, "lower", *lower), vector(*stock, "upper", *upper)};
    }
    if (!setup_.stock_box.valid() || setup_.stock_box.size().minCoeff() <= 0)
      throw refuse(*stock, "", "the stock has no size: its lower corner is not below its upper one");
    setup_.sampling.cell = table_.number("cell").value_or(StockSettings::usual_cell(setup_.stock_box));
    setup_.sampling.tolerance = table_.number("tolerance").value_or(0);
    if (const auto rules = table_.text("rules")) setup_.sampling.rules = parse_split_rules(*rules);
  }

  /// Continues the cut numbers of a saved stock; their program lines are unknown.
  void begin_with(Stock saved) {
    saved.forget_cuts();
    setup_.stock_box = saved.lattice().box();
    setup_.sampling = saved.settings();
    setup_.saved = std::make_shared<const Stock>(std::move(saved));
  }

  void read_target() {
    const auto target = table_.table("target");
    if (!target) return;
    target->only({"model", "part", "move", "bounds", "gouge", "excess", "touch", "floor"});
    if (target->has("model")) setup_.target = read_model(*target).first;
    const auto get = [&](const char* key, double& into) {
      if (const auto value = target->number(key)) into = *value;
    };
    get("gouge", setup_.gouge), get("excess", setup_.excess), get("touch", setup_.touch), get("floor", setup_.floor);
  }

  void read_fixture() {
    const auto fixture = table_.table("fixture");
    if (!fixture) return;
    fixture->only({"model", "part", "move", "bounds", "lower", "upper"});
    if (fixture->has("model")) {
      std::tie(setup_.fixture, setup_.fixture_box) = read_model(*fixture);
      return;
    }
    const auto lower = fixture->list("lower"), upper = fixture->list("upper");
    if (!lower || !upper) throw refuse(*fixture, "", "a fixture needs a model, or lower and upper corners");
    setup_.fixture_box = {vector(*fixture, "lower", *lower), vector(*fixture, "upper", *upper)};
    if (!setup_.fixture_box.valid() || setup_.fixture_box.size().minCoeff() <= 0)
      throw refuse(*fixture, "", "the fixture has no size");
    setup_.fixture = box_field(setup_.fixture_box.grown(1));
  }

  AxisValues axes(const TomlTable& table, const std::string& key, const std::vector<double>& list) const {
    if (list.size() < 3 || list.size() > 9)
      throw refuse(table, key, fmt::format("{} is [x, y, z] and up to six axes more", key));
    AxisValues values;
    for (std::size_t a = 0; a < list.size(); ++a) values.at[a] = list[a] * (a >= 3 && a < 6 ? radians_per_degree : 1);
    return values;
  }

  void read_places() {
    if (const auto zero = table_.list("zero")) setup_.zero = vector(table_, "zero", *zero);
    if (const auto start = table_.list("start")) setup_.start = axes(table_, "start", *start);
    if (const auto home = table_.list("home")) setup_.home[0] = axes(table_, "home", *home);
    if (const auto home = table_.list("second_home")) setup_.home[1] = axes(table_, "second_home", *home);
    if (const auto rapids = table_.text("rapids")) {
      if (*rapids != "straight" && *rapids != "dog-leg")
        throw refuse(table_, "rapids", "rapids are \"straight\" or \"dog-leg\"");
      setup_.rapid_way = *rapids == "straight" ? RapidWay::straight : RapidWay::dog_leg;
    }
    static const std::vector<std::string> systems{"G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"};
    if (const auto work = table_.table("work")) {
      work->only(systems);
      for (std::size_t i = 0; i < systems.size(); ++i)
        if (const auto list = work->list(systems[i])) setup_.work_offsets[i] = axes(*work, systems[i], *list);
    }
    if (const auto limits = table_.table("limits")) {
      static const std::vector<std::string> letters{"x", "y", "z", "a", "b", "c", "u", "v", "w"};
      limits->only(letters);
      for (std::size_t a = 0; a < letters.size(); ++a)
        if (const auto list = limits->list(letters[a])) {
          if (list->size() != 2 || !((*list)[0] <= (*list)[1]))
            throw refuse(*limits, letters[a], "limits are [from, to]");
          const double unit = a >= 3 && a < 6 ? radians_per_degree : 1;
          setup_.limits[a] = {(*list)[0] * unit, (*list)[1] * unit};
        }
    }
  }

  void read_stops() {
    for (const TomlTable& table : table_.tables("stop")) {
      table.only({"tool", "up"});
      StopAction action;
      action.tool = static_cast<int>(table.number("tool").value_or(0));
      if (const auto up = table.text("up")) {
        try {
          action.placement = placement_of(plane_named(*up));
        } catch (const Error& error) {
          throw refuse(table, "up", error.what());
        }
      }
      setup_.stops.push_back(std::move(action));
    }
  }

  std::filesystem::path path_;
  FieldPtr part_;  ///< of a job; null if it names its model
  Progress& progress_;
  const Formats& formats_;
  std::string text_;
  TomlTable table_;
  SimulationSetup setup_;
};

}  // namespace

SimulationSetup read_simulation_setup(const std::filesystem::path& path, Progress& progress, const Formats& formats) {
  if (path.extension() == ".camotics") {
    SimulationSetup setup = read_camotics(path, progress);
    put_below_machine_zero(setup);
    return setup;
  }
  return SetupReader(path, nullptr, progress, formats).read();
}

SimulationSetup read_simulation_setup(const std::filesystem::path& path, FieldPtr part, Progress& progress,
                                      const Formats& formats) {
  return SetupReader(path, std::move(part), progress, formats).read();
}

}  // namespace fieldfab::cam
