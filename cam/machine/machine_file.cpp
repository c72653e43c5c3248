// Reader of machines' data files.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/names.h"
#include "base/toml_table.h"
#include "fieldfab/cam/machine/machine.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

namespace fieldfab::cam {
namespace {

constexpr std::array<std::string_view, 4> kind_names{"none", "head-head", "table-table", "head-table"};
constexpr std::array<std::string_view, 4> takes_names{"paths", "flat paths", "height map", "mesh"};
constexpr std::array<std::string_view, 5> format_names{"text", "dxf", "svg", "png", "stl"};

std::optional<Vec3> read_centre(const TomlTable& table) {
  const auto centre = table.list("centre");
  if (!centre) return std::nullopt;
  if (centre->size() != 3) throw Error(ErrorKind::bad_input, table.place("centre"), "centre must be [x, y, z]");
  return Vec3((*centre)[0], (*centre)[1], (*centre)[2]);
}

Kinematics read_kinematics(const TomlTable& table) {
  table.only({"kind", "axis", "centre", "pivot", "tip_mode"});
  Kinematics k;
  if (const auto kind = table.text("kind"))
    k.kind = named<Kinematics::Kind>(*kind, kind_names, "kind", table.place("kind"));
  for (const TomlTable& entry : table.tables("axis")) {
    entry.only({"letter", "direction", "limits", "centre"});
    RotaryAxis axis;
    const std::string letter = entry.text("letter").value_or("A");
    const auto direction = entry.list("direction").value_or(std::vector<double>{1, 0, 0});
    const auto limits = entry.list("limits");
    if (letter.size() != 1 || direction.size() != 3 || (limits && limits->size() != 2))
      throw Error(ErrorKind::bad_input, entry.place(),
                  "an axis has a letter, a direction [x, y, z] and limits [from, to] in degrees");
    axis.letter = letter[0];
    axis.direction = Vec3(direction[0], direction[1], direction[2]);
    if (!(axis.direction.norm() > 0))
      throw Error(ErrorKind::bad_input, entry.place("direction"), "direction must not be zero");
    axis.direction.normalize();
    if (limits) axis.lower = (*limits)[0] * radians_per_degree, axis.upper = (*limits)[1] * radians_per_degree;
    axis.centre = read_centre(entry);
    k.axes.push_back(axis);
  }
  if (k.kind != Kinematics::Kind::none && (k.axes.empty() || k.axes.size() > 2))
    throw Error(ErrorKind::bad_input, table.place(), "a machine that tilts has one or two [[kinematics.axis]]");
  k.centre = read_centre(table).value_or(Vec3::Zero());
  k.pivot = table.number("pivot").value_or(0);
  k.tip_mode = table.flag("tip_mode").value_or(false);
  return k;
}

Setting read_setting(const std::string& name, const TomlTable& table) {
  table.only({"default", "unit", "help", "min", "max", "above"});
  Setting setting;
  setting.name = name;
  const auto standard = table.value("default");
  if (!standard) throw Error(ErrorKind::bad_input, table.place(), fmt::format("setting {} needs a default", name));
  setting.standard = *standard;
  setting.unit = table.text("unit").value_or("");
  setting.help = table.text("help").value_or("");
  if (const auto lower = table.number("min")) setting.lower = *lower;
  if (const auto above = table.number("above")) setting.lower = *above, setting.lower_open = true;
  if (const auto upper = table.number("max")) setting.upper = *upper;
  return setting;
}

}  // namespace

std::string_view name_of(Kinematics::Kind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

std::string_view name_of(MachineInput takes) { return takes_names[static_cast<std::size_t>(takes)]; }

Machine read_machine(std::string_view toml, const std::string& file) {
  const TomlTable table = TomlTable::parse(toml, file);
  table.only({"name",     "description",  "format",    "extension", "takes",       "unit",       "tick",
              "decimals", "arcs",         "feed_unit", "max_feed",  "max_spindle", "travel",     "negative",
              "rapid",    "acceleration", "text",      "setting",   "material",    "kinematics", "default_operation",
              "dialect"});
  Machine m;
  m.file = file;
  m.id = std::filesystem::path(file).stem().string();
  const auto need = [&](const std::string& key) {
    const auto text = table.text(key);
    if (!text) throw Error(ErrorKind::bad_input, file, fmt::format("a machine needs the key {}", key));
    return *text;
  };
  m.name = need("name");
  m.extension = need("extension");
  m.description = table.text("description").value_or("");
  if (const auto format = table.text("format"))
    m.format = named<FileFormat>(*format, format_names, "format", table.place("format"));
  if (const auto takes = table.text("takes"))
    m.takes = named<MachineInput>(*takes, takes_names, "takes", table.place("takes"));
  m.unit = table.number("unit").value_or(1);
  m.tick = table.number("tick").value_or(0);
  m.decimals = static_cast<int>(table.number("decimals").value_or(4));
  m.arcs = table.flag("arcs").value_or(false);
  m.feed_unit = table.number("feed_unit").value_or(m.unit);
  if (!(m.unit > 0) || !(m.tick >= 0) || !(m.feed_unit > 0) || m.decimals < 0 || m.decimals > 9)
    throw Error(ErrorKind::bad_input, file, "unit and feed_unit must be above 0, tick not below, decimals from 0 to 9");
  m.max_feed = table.number("max_feed").value_or(0);
  m.max_spindle = table.number("max_spindle").value_or(0);
  if (const auto travel = table.list("travel")) {
    if (travel->size() != 3) throw Error(ErrorKind::bad_input, table.place("travel"), "travel must be [x, y, z] in mm");
    std::copy(travel->begin(), travel->end(), m.travel.begin());
  }
  m.negative = table.flag("negative").value_or(true);
  m.dynamics.rapid = table.number("rapid").value_or(m.dynamics.rapid);
  m.dynamics.acceleration = table.number("acceleration").value_or(m.dynamics.acceleration);
  if (const auto dialect = table.text("dialect")) m.dialect = dialect_named(*dialect, table.place("dialect"));
  m.default_operation = table.text("default_operation").value_or("");
  if (const auto text = table.table("text")) {
    text->only({"header", "footer", "section", "tool_change", "spindle_on",   "spindle_off",   "feed",        "rapid",
                "line",   "arc_cw", "arc_ccw", "tilt",        "coolant_mist", "coolant_flood", "coolant_off", "begin",
                "end",    "setup",  "comment", "retract",     "drill",        "peck_drill"});
    for (const std::string& key : text->keys()) m.text[key] = *text->text(key);
  }
  if (const auto settings = table.table("setting"))
    for (const std::string& name : settings->keys()) m.settings.push_back(read_setting(name, *settings->table(name)));
  if (const auto materials = table.table("material"))
    for (const std::string& material : materials->keys()) {
      const TomlTable values = *materials->table(material);
      for (const std::string& key : values.keys()) m.materials[material][key] = *values.value(key);
    }
  // Mills know common materials by their chip loads.
  if (m.takes == MachineInput::paths && m.text.contains("spindle_on"))
    for (const std::string& material : cut_materials()) m.materials.try_emplace(material);
  if (const auto kinematics = table.table("kinematics")) m.kinematics = read_kinematics(*kinematics);
  return m;
}

std::optional<CuttingValues> cutting_values_of(const Machine& machine, const std::string& material, const Tool& tool) {
  const auto own = machine.materials.find(material);
  if (own == machine.materials.end() || !own->second.empty() || !(tool.diameter > 0)) return std::nullopt;
  const double fastest = machine.max_feed > 0 ? machine.max_feed : machine.dynamics.rapid;
  return cutting_values(material, tool, fastest, machine.max_spindle);
}

Machine load_machine(const std::string& id_or_path) {
  if (id_or_path.ends_with(".toml")) return read_machine(read_file(id_or_path, 1 << 20), id_or_path);
  const auto& files = machine_files();
  const auto found = files.find(id_or_path);
  if (found != files.end()) return read_machine(found->second, id_or_path + ".toml");
  std::vector<std::string> ids;
  for (const auto& [id, text] : files) ids.push_back(id);
  throw Error(ErrorKind::bad_input, "machine",
              fmt::format("there is no machine '{}'{} Known are {}, or a .toml file", id_or_path,
                          suggestion(id_or_path, ids), fmt::join(ids, ", ")));
}

}  // namespace fieldfab::cam
