// Reading job files.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/toml_table.h"
#include "base/tool_table.h"
#include "fieldfab/cam/job/job.h"
#include "fieldfab/core/angle.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/field/bounds.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/solid/open.h"
#include "sheet.h"
#include "stages.h"

namespace fieldfab::cam {
namespace {

Vec3 vector_of(const TomlTable& table, const std::string& key, std::size_t from, const std::vector<double>& list) {
  if (list.size() < from + 3)
    throw Error(ErrorKind::bad_input, table.place(key), fmt::format("{} has too few numbers", key));
  return {list[from], list[from + 1], list[from + 2]};
}

Solid moved(const Solid& solid, const Vec3& by) {
  return solid_of(translate(solid.field, by), "part", Box{solid.bounds->lower + by, solid.bounds->upper + by},
                  solid.flat);
}

}  // namespace

class JobReader {
 public:
  JobReader(std::string_view toml, const std::filesystem::path& path, FieldPtr part, Progress& progress,
            const Formats& formats)
      : path_(path),
        progress_(progress),
        formats_(formats),
        table_(TomlTable::parse(toml, path.string())),
        given_(std::move(part)) {}

  Job read() {
    table_.only({"name", "machine", "material", "input", "stock", "tool", "operation", "setting", "feeds"});
    job_.file_ = path_.string();
    job_.program_.name = table_.text("name").value_or(path_.stem().string());
    read_machine();
    if (const auto feeds = table_.table("feeds")) job_.adjust_feeds(feed_limits_of(*feeds));
    read_input();
    read_stock();
    tools_ = read_tools(table_, path_.parent_path());
    read_operations();
    return std::move(job_);
  }

 private:
  [[nodiscard]] Error refuse(const TomlTable& table, const std::string& key, const std::string& what) const {
    return {ErrorKind::bad_input, table.place(key), what};
  }
  [[nodiscard]] std::filesystem::path beside(const std::string& name) const {
    const std::filesystem::path p(name);
    return p.is_absolute() ? p : path_.parent_path() / p;
  }

  void read_machine() {
    const auto id = table_.text("machine");
    if (!id) throw refuse(table_, "", "a job needs a machine");
    try {
      job_.machine_ = load_machine(id->ends_with(".toml") ? beside(*id).string() : *id);
    } catch (const Error& error) {
      if (error.place() != "machine") throw;
      throw refuse(table_, "machine", error.what());
    }
    job_.machine_place_ = table_.place("machine");
    const Machine& machine = job_.machine_;
    job_.material_ = table_.text("material").value_or("");
    if (!job_.material_.empty() && !machine.materials.contains(job_.material_)) {
      std::vector<std::string> known;
      for (const auto& [name, values] : machine.materials) known.push_back(name);
      throw refuse(
          table_, "material",
          fmt::format("{} has no defaults for '{}'{}{}", machine.name, job_.material_,
                      suggestion(job_.material_, known),
                      known.empty() ? "; it has none at all" : fmt::format("; it knows {}", fmt::join(known, ", "))));
    }
    const auto own = table_.table("setting");
    if (own) {
      std::vector<std::string> known;
      for (const Setting& s : machine.settings) known.push_back(s.name);
      own->only(known);
    }
    for (const Setting& setting : machine.settings) {
      Given given{setting.standard, "machine", ""};
      const std::string material_place = fmt::format("{}: material {}", machine.file, job_.material_);
      if (const auto* value = material_value(setting.name))
        given = {checked(setting, *value, material_place), "material " + job_.material_, ""};
      if (own && own->has(setting.name))
        given = {checked(setting, *own->value(setting.name), own->place(setting.name)), "job",
                 own->place(setting.name)};
      job_.machine_values_.given[setting.name] = given;
    }
  }

  [[nodiscard]] const Value* material_value(const std::string& name) const {
    const auto material = job_.machine_.materials.find(job_.material_);
    if (material == job_.machine_.materials.end()) return nullptr;
    const auto value = material->second.find(name);
    return value == material->second.end() ? nullptr : &value->second;
  }

  void read_input() {
    const auto input = table_.table("input");
    if (!input) throw refuse(table_, "", "a job needs an [input] with a model or an image");
    input->only({"model", "models", "part", "image", "scale", "rotate", "move", "bounds", "thickness", "threshold",
                 "zero", "sheet", "gap"});
    if (const auto image = input->text("image")) {
      if (input->has("model")) throw refuse(*input, "image", "an input is a model or an image, not both");
      job_.input_ = read_png(beside(*image));
      return;
    }
    job_.input_ = read_solid(*input);
  }

  Solid read_model(const TomlTable& input, const std::string& name) {
    OpenSettings settings;
    settings.formats = &formats_;
    if (const auto threshold = input.value("threshold")) {
      const double* const number = std::get_if<double>(&*threshold);
      settings.options = {number != nullptr ? frep::OpenOption{"threshold", *number}
                                            : frep::OpenOption{"threshold", *input.text("threshold")}};
    }
    FieldPtr field = given_;
    const double scale = input.number("scale").value_or(1);
    if (!(scale > 0)) throw refuse(input, "scale", "scale must be above 0");
    if (!given_ || !name.empty()) {
      const Model model = open_model(beside(name), settings, progress_);
      job_.notes_.insert(job_.notes_.end(), model.notes.begin(), model.notes.end());
      const auto part = input.text("part");
      field = part ? part_of(model, *part, input.place("part")).field : united(model).field;
    }
    if (scale != 1) field = fieldfab::scale(field, Vec3::Constant(scale));
    if (const auto turns = input.list("rotate")) {
      const Vec3 angles = vector_of(input, "rotate", 0, *turns) * radians_per_degree;
      for (int axis = 0; axis < 3; ++axis)
        if (angles[axis] != 0) field = fieldfab::rotate(field, Vec3::Unit(axis), angles[axis]);
    }
    if (const auto bounds = input.list("bounds")) {
      const Box given{vector_of(input, "bounds", 0, *bounds), vector_of(input, "bounds", 3, *bounds)};
      if (!given.valid()) throw refuse(input, "bounds", "bounds are x0, y0, z0, x1, y1, z1");
      return solid_of(field, "part", given, given.size().z() == 0);
    }
    const SolidBounds found = solid_bounds(*field, progress_);
    if (found.empty) throw refuse(input, "model", fmt::format("{}: the solid is empty", name));
    const bool flat = found.bounded[0] && found.bounded[1] && !found.bounded[2];
    if (!flat && !found.is_bounded())
      throw refuse(input, "model",
                   fmt::format("{}: the solid is unbounded; give bounds = [x0, y0, z0, x1, y1, z1]", name));
    Box box = found.box;
    if (flat) box.lower.z() = box.upper.z() = 0;
    return solid_of(field, "part", box, flat);
  }

  /// One model, or several: together as they are, or arranged on a sheet.
  Solid read_models(const TomlTable& input) {
    const auto name = input.text("model");
    std::vector<std::string> names = input.texts("models");
    if (given_) {
      if (name || !names.empty())
        throw refuse(input, name ? "model" : "models", "the part is given: the input names none");
      return read_model(input, "");
    }
    if (name.has_value() == !names.empty())
      throw refuse(input, name ? "models" : "", "an input needs a model, or models, or an image");
    if (name) names = {*name};
    std::vector<Solid> parts;
    for (const std::string& part : names) parts.push_back(read_model(input, part));
    if (const auto sheet = input.list("sheet")) {
      if (sheet->size() != 2) throw refuse(input, "sheet", "sheet is [width, height] in mm");
      return lay_on_sheet(parts, {(*sheet)[0], (*sheet)[1]}, input.number("gap").value_or(5));
    }
    Solid all = parts[0];
    for (std::size_t i = 1; i < parts.size(); ++i)
      all = solid_of(unite(all.field, parts[i].field), "part", hull(*all.bounds, *parts[i].bounds),
                     all.flat && parts[i].flat);
    return all;
  }

  Solid read_solid(const TomlTable& input) {
    Solid solid = read_models(input);
    Vec3 move = Vec3::Zero();
    Box part = *solid.bounds;
    if (const auto by = input.list("move")) move = vector_of(input, "move", 0, *by);
    // Position of the program's zero on the part.
    if (const auto given = input.value("zero"); given && std::holds_alternative<std::vector<double>>(*given)) {
      move -= vector_of(input, "zero", 0, *input.list("zero"));
    } else {
      zero_ = input.text("zero").value_or("model");
      if (zero_ != "model") part = tight_bounds(*solid.field, part, progress_);
      if (zero_ == "corner")
        move -= Vec3(part.lower.x(), part.lower.y(), part.upper.z());
      else if (zero_ == "centre")
        move -= Vec3(part.centre().x(), part.centre().y(), part.upper.z());
      else if (zero_ != "model")
        throw refuse(input, "zero",
                     fmt::format("zero is '{}'; it must be one of model, corner, centre{}, or a point [x, y, z]", zero_,
                                 suggestion(zero_, {"model", "corner", "centre"})));
    }
    move_ = move;
    job_.zero_ = -move;
    if (move != Vec3::Zero()) solid = moved(solid, move);
    part_ = {part.lower + move, part.upper + move};
    return solid;
  }

  /// The stock: given, or the part's bounds with a margin.
  void read_stock() {
    Box part;
    if (const auto* const solid = std::get_if<Solid>(&job_.input_)) {
      part = *solid->bounds;
    } else {
      const Image& image = std::get<Image>(job_.input_);
      const double pixel = image.pixels_per_mm > 0 ? 1 / image.pixels_per_mm : 1;
      part = {{0, 0, 0}, {image.width * pixel, image.height * pixel, 0}};
      if (image.has_heights) part.lower.z() = image.bounds.lower.z(), part.upper.z() = image.bounds.upper.z();
    }
    Box stock = part;
    if (const auto table = table_.table("stock")) {
      table->only({"lower", "upper", "margin", "thickness", "top", "coordinates", "file"});
      const double margin = table->number("margin").value_or(0);
      stock = {{part.lower.x() - margin, part.lower.y() - margin, part.lower.z()},
               {part.upper.x() + margin, part.upper.y() + margin, part.upper.z()}};
      if (const auto top = table->number("top")) stock.upper.z() += *top;
      if (const auto thickness = table->number("thickness")) stock.lower.z() = stock.upper.z() - *thickness;
      const std::string coordinates = table->text("coordinates").value_or("program");
      if (coordinates != "program" && coordinates != "model")
        throw refuse(*table, "coordinates",
                     fmt::format("coordinates is '{}'; it must be one of program, model{}", coordinates,
                                 suggestion(coordinates, {"program", "model"})));
      const Vec3 move = coordinates == "model" ? move_ : Vec3::Zero();
      if (const auto lower = table->list("lower")) stock.lower = vector_of(*table, "lower", 0, *lower) + move;
      if (const auto upper = table->list("upper")) stock.upper = vector_of(*table, "upper", 0, *upper) + move;
      if (const auto file = table->text("file")) {
        for (const char* const key : {"lower", "upper", "margin", "thickness", "top", "coordinates"})
          if (table->has(key)) throw refuse(*table, key, "a saved stock is as it is: file stands alone");
        job_.saved_stock_ = std::make_shared<const Stock>(cam::read_stock(beside(*file)));
        stock = job_.saved_stock_->lattice().box();
      }
      if (!stock.valid())
        throw refuse(*table, "", "the stock has no size: its lower corner is not below its upper one");
    }
    // A beam or a blade cuts through any thickness.
    if (job_.machine_.takes == MachineInput::flat_paths && stock.size().z() == 0) stock.lower.z() -= 1;
    job_.stock_ = stock;
    if (auto* const solid = std::get_if<Solid>(&job_.input_); solid != nullptr && !solid->flat) {
      // The part must lie in the stock, within the accuracy of its bounds. A part that is machined
      // from above stands on the stock's floor.
      Box& bounds = *solid->bounds;
      const double loose = 0.02 * bounds.size().maxCoeff();
      const Box& held = stock;
      if ((bounds.upper - held.upper).maxCoeff() > loose || (held.lower - bounds.lower).head<2>().maxCoeff() > loose)
        throw refuse(
            table_, "stock",
            fmt::format(
                "the part (to x {:.6g}, y {:.6g}, z {:.6g}) sticks out of the stock (to {:.6g}, {:.6g}, {:.6g})",
                bounds.upper.x(), bounds.upper.y(), bounds.upper.z(), held.upper.x(), held.upper.y(), held.upper.z()));
      job_.stock_.upper = job_.stock_.upper.cwiseMax(bounds.upper);
      bounds.lower = bounds.lower.cwiseMin(stock.lower);
      bounds.upper.head<2>() = bounds.upper.head<2>().cwiseMax(stock.upper.head<2>());
    }
  }

  void read_operations() {
    const auto tables = table_.tables("operation");
    int index = 0;
    const MachineInput takes = job_.machine_.takes;
    if (takes != MachineInput::paths && takes != MachineInput::flat_paths) {
      if (!tables.empty())
        throw refuse(tables[0], "",
                     fmt::format("{} takes a {}: it has no operations", job_.machine_.name, name_of(takes)));
      return;
    }
    if (tables.empty()) {
      if (job_.machine_.default_operation.empty()) throw refuse(table_, "", "a job needs at least one [[operation]]");
      const std::string toml = fmt::format("[[operation]]\ntype = \"{}\"\n", job_.machine_.default_operation);
      add_operation(TomlTable::parse(toml, path_.string()).tables("operation")[0], 1);
    }
    for (const TomlTable& table : tables) add_operation(table, ++index);
    // Planes in sequence, each with all of its operations.
    std::vector<std::string> seen;
    for (const PlannedOperation& op : job_.operations_)
      if (std::find(seen.begin(), seen.end(), op.plane.name) == seen.end()) seen.push_back(op.plane.name);
    std::stable_sort(
        job_.operations_.begin(), job_.operations_.end(), [&](const PlannedOperation& a, const PlannedOperation& b) {
          return std::find(seen.begin(), seen.end(), a.plane.name) < std::find(seen.begin(), seen.end(), b.plane.name);
        });
  }

  [[nodiscard]] Tool tool_for(const TomlTable& table) const {
    const auto number = table.number("tool");
    if (!number) {
      if (tools_.empty()) {
        Tool beam;  // a beam or a blade of width 0
        beam.shape = ToolShape::flat;
        const auto kerf = job_.machine_values_.given.find("kerf");
        beam.diameter = kerf == job_.machine_values_.given.end() ? 0 : std::get<double>(kerf->second.value);
        beam.name = beam.diameter > 0 ? fmt::format("beam of {:.4g} mm", beam.diameter) : "no tool";
        return beam;
      }
      if (tools_.size() == 1) return tools_[0];
      throw refuse(table, "", fmt::format("the job has {} tools: say which, tool = NUMBER", tools_.size()));
    }
    for (const Tool& tool : tools_)
      if (tool.number == *number) return tool;
    throw refuse(table, "tool", fmt::format("there is no [[tool]] with number {:g}", *number));
  }

  void add_operation(const TomlTable& table, int index) {
    const auto type = table.text("type");
    if (!type) throw refuse(table, "", "an [[operation]] needs a type");
    PlannedOperation op;
    const std::string place = table.place("type");  // by a name: GCC 14 warns of a reference into a temporary
    const Stage& last = operation(*type, place);
    op.name = table.text("name").value_or(fmt::format("{} {}", index, *type));
    op.tool = tool_for(table);
    if (const auto model = table.text("model")) op.own_input = read_own_model(table, *model);
    op.stages = chain(static_cast<Kind>((op.own_input ? *op.own_input : job_.input_).index()), last);
    std::vector<std::string> known{"type", "name", "tool", "model"};
    const auto add = [&](const Setting& setting) {
      known.push_back(setting.name);
      op.values.given[setting.name] = resolve(setting, table, op.tool);
    };
    for (const Stage* stage : op.stages)
      for (const Setting& setting : stage->settings) add(setting);
    for (const Setting& setting : joining_settings()) add(setting);
    table.only(known);
    op.values.given["type"] = {*type, "job", table.place("type").empty() ? table.place() : table.place("type")};
    const double most = job_.machine_.max_feed;
    for (const char* name : {"feed", "plunge"})
      if (Given& given = op.values.given[name]; most > 0 && given.from == "default")
        given.value = std::min(most, std::get<double>(given.value));
    const double feed = op.values.number("feed");
    if (most > 0 && feed > most)
      throw refuse(table, "feed",
                   fmt::format("feed is {:.6g}; {} goes no faster than {:.6g} mm/min", feed, job_.machine_.name, most));
    if (job_.machine_.max_spindle > 0 && op.values.number("spindle") > job_.machine_.max_spindle)
      throw refuse(table, "spindle",
                   fmt::format("spindle is {:.6g}; {} turns at {:.6g} at most", op.values.number("spindle"),
                               job_.machine_.name, job_.machine_.max_spindle));
    std::vector<Plane> planes = planes_of(op.values);
    const bool by_hand = job_.machine_.kinematics.kind == Kinematics::Kind::none;
    const bool leans = op.values.has("lean") && op.values.flag("lean");
    if (by_hand && leans) throw refuse(table, "lean", fmt::format("{} cannot tilt its tool", job_.machine_.name));
    if (by_hand)
      for (Plane& plane : planes) turn_by_hand(plane);
    if (std::any_of(planes.begin(), planes.end(), [](const Plane& p) { return !p.is_top(); })) {
      const auto* const solid = std::get_if<Solid>(op.own_input ? &*op.own_input : &job_.input_);
      if (solid == nullptr || solid->flat) throw refuse(table, "plane", "only a solid can be cut from other sides");
      if (by_hand && !job_.machine_.text.contains("setup"))
        throw refuse(table, "plane",
                     fmt::format("{} can neither tilt its tool nor stop for turning the part", job_.machine_.name));
      if (by_hand && (op.values.text("plane") == "view" || op.values.text("plane") == "stepped"))
        throw refuse(table, "plane",
                     fmt::format("{} cannot tilt its tool: only faces can be turned up by hand", job_.machine_.name));
    }
    const bool tilts = leans || std::any_of(planes.begin(), planes.end(), [](const Plane& p) { return !p.is_top(); });
    if (tilts && !by_hand && job_.machine_.kinematics.kind != Kinematics::Kind::table_table && !(op.tool.length > 0) &&
        !job_.machine_.kinematics.tip_mode)
      throw refuse(
          table, "tool",
          fmt::format("tool {} needs a length (from tip to holder): {} turns its head about a point that far away",
                      op.tool.number, job_.machine_.name));
    const std::string name = op.name;
    for (const Plane& plane : planes) {
      if (job_.machine_.kinematics.kind == Kinematics::Kind::head_head && plane.axes.col(2).z() < -1e-9)
        throw refuse(table, "plane", fmt::format("plane {} overhangs: the tool would point upwards", plane.name));
      op.plane = plane;
      if (planes.size() > 1) op.name = fmt::format("{} ({})", name, plane.name);
      job_.operations_.push_back(op);
    }
  }

  /// Makes the plane a set-up of its own, with the program's zero as in the job: in the corner or
  /// the centre of the part's new top.
  void turn_by_hand(Plane& plane) const {
    if (plane.is_top()) return;
    plane.setup = true;
    const Box part = plane.into(part_);
    if (zero_ == "corner") plane.origin = {part.lower.x(), part.lower.y(), part.upper.z()};
    if (zero_ == "centre") plane.origin = {part.centre().x(), part.centre().y(), part.upper.z()};
  }

  [[nodiscard]] static std::vector<Plane> planes_of(const Values& values) {
    const std::string& name = values.text("plane");
    if (name == "five") return five_planes();
    if (name == "stepped") return stepped_planes(static_cast<int>(values.number("steps")));
    if (name == "view")
      return {plane_from_view(values.number("alpha") * radians_per_degree, values.number("beta") * radians_per_degree)};
    Plane plane = plane_named(name);
    plane.to_the_middle = !plane.is_top();
    return {plane};
  }

  /// Value of a setting: the job's, else the tool's, the material's, that of its chip load, the default.
  [[nodiscard]] Given resolve(const Setting& setting, const TomlTable& table, const Tool& tool) const {
    if (const auto value = table.value(setting.name))
      return {checked(setting, *value, table.place(setting.name)), "job", table.place(setting.name)};
    if (const double own = CuttingValues{tool.feed, tool.plunge, tool.spindle}.named(setting.name); own > 0)
      return {own, fmt::format("tool {}", tool.number), table.place()};
    if (const Value* const value = material_value(setting.name))
      return {checked(setting, *value, fmt::format("{}: material {}", job_.machine_.file, job_.material_)),
              "material " + job_.material_, table.place()};
    if (const auto values = cutting_values_of(job_.machine_, job_.material_, tool); values)
      if (const double value = values->named(setting.name); value > 0)
        return {value, "chip load of " + job_.material_, table.place()};
    return {setting.standard, "default", table.place()};
  }

  std::filesystem::path path_;
  Progress& progress_;
  const Formats& formats_;
  TomlTable table_;
  FieldPtr given_;  // the part, if it does not come from a file
  std::vector<Tool> tools_;
  /// A model for one operation only, placed as the input.
  Solid read_own_model(const TomlTable& operation, const std::string& name) {
    const auto input = table_.table("input");
    if (input->has("image")) throw refuse(operation, "model", "a job with an image as its input has no other models");
    return moved(read_model(*input, name), move_);
  }

  Vec3 move_ = Vec3::Zero();    // of the input
  Box part_;                    // the input's bounds, exact ones if the zero depends on them
  std::string zero_ = "model";  // position of the program's zero on the part
  Job job_;
};

Job Job::read(const std::filesystem::path& path, Progress& progress, const Formats& formats) {
  return JobReader(read_file(path, 16 << 20), path, nullptr, progress, formats).read();
}

Job Job::parse(std::string_view toml, const std::filesystem::path& path, FieldPtr part, Progress& progress,
               const Formats& formats) {
  return JobReader(toml, path, std::move(part), progress, formats).read();
}

}  // namespace fieldfab::cam
