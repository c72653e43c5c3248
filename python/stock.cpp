#include "fieldfab/cam/stock/stock.h"

#include <array>
#include <cstring>

#include "bindings.h"
#include "fieldfab/cam/simulate/frames.h"
#include "fieldfab/cam/simulate/html_report.h"
#include "fieldfab/cam/simulate/picture.h"
#include "fieldfab/cam/simulate/playback.h"
#include "fieldfab/cam/simulate/simulate.h"
#include "fieldfab/core/angle.h"
#include "fieldfab/core/error.h"
#include "fieldfab/mesh/triangle_mesh.h"
#include "fieldfab/openscad/design.h"

namespace fieldfab::python {
namespace {

/// Red, green and blue, as colours in Python.
std::array<std::uint8_t, 3> channels_of(const Colour& colour) { return {colour.red, colour.green, colour.blue}; }

/// Poses from rows of the tip's x, y and z, optionally followed by the tool's axis.
std::vector<cam::ToolPose> poses_of(const Array<double>& rows) {
  if (rows.ndim() != 2 || (rows.shape(1) != 3 && rows.shape(1) != 6))
    throw Error(ErrorKind::bad_input, "poses", "an (n, 3) array of tips or an (n, 6) array of tips and axes is wanted");
  const auto in = rows.unchecked<2>();
  std::vector<cam::ToolPose> poses;
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    cam::ToolPose pose{{in(i, 0), in(i, 1), in(i, 2)}, Vec3::UnitZ()};
    if (rows.shape(1) == 6) pose.axis = Vec3(in(i, 3), in(i, 4), in(i, 5)).normalized();
    if (!pose.tip.allFinite() || !pose.axis.allFinite())
      throw Error(ErrorKind::bad_input, "poses", "they must be finite");
    poses.push_back(pose);
  }
  return poses;
}

cam::Tool tool_of(const py::dict& given) {
  cam::Tool tool;
  for (const auto& [key, value] : given) {
    const auto name = key.cast<std::string>();
    if (name == "shape")
      tool.shape = cam::tool_shape_named(value.cast<std::string>(), "shape");
    else if (name == "diameter")
      tool.diameter = value.cast<double>();
    else if (name == "corner_radius")
      tool.corner_radius = value.cast<double>();
    else if (name == "angle")
      tool.angle = to_radians(value.cast<double>());
    else if (name == "tip_diameter")
      tool.tip_diameter = value.cast<double>();
    else if (name == "flute")
      tool.flute = value.cast<double>();
    else if (name == "profile")
      for (const auto& point : value.cast<std::vector<std::pair<double, double>>>())
        tool.points.emplace_back(point.first, point.second);
    else
      throw Error(ErrorKind::bad_input, "tool", "it has no \"" + name + "\"");
  }
  return tool;
}

void bind_block(py::module_& module) {
  py::class_<cam::Stock>(module, "Stock",
                         "A block of material that tools cut: a multidirectional heightmap (docs/simulation.md).")
      .def(py::init([](const py::object& bounds, double cell, const py::object& solid, const py::object& progress) {
             const auto box = bounds_of(bounds);
             if (!box) throw Error(ErrorKind::bad_input, "bounds", "a stock needs bounds");
             cam::StockSettings settings;
             settings.cell = cell;
             if (solid.is_none()) return std::make_unique<cam::Stock>(*box, settings);
             const FieldPtr field = field_of(solid);
             return long_work(progress,
                              [&](Progress& p) { return std::make_unique<cam::Stock>(*field, *box, settings, p); });
           }),
           py::arg("bounds"), py::arg("cell") = 0.2, py::arg("solid") = py::none(), py::arg("progress") = py::none())
      .def(
          "copy", [](const cam::Stock& stock) { return std::make_unique<cam::Stock>(stock); },
          "A checkpoint: it shares what does not change.")
      .def(
          "cut",
          [](cam::Stock& stock, const py::dict& tool, const Array<double>& poses, const py::object& progress) {
            const cam::ToolSolid solid = cam::tool_solid(tool_of(tool));
            const std::vector<cam::ToolPose> way = poses_of(poses);
            std::vector<cam::Stroke> strokes;
            std::vector<std::size_t> step;
            for (std::size_t i = 1; i < way.size(); ++i)
              for (const cam::ToolPiece& piece : solid.pieces)
                if (piece.role == cam::ToolRole::cutting)
                  strokes.push_back({&piece, way[i - 1], way[i], static_cast<std::uint32_t>(i), true}),
                      step.push_back(i - 1);
            const auto results = long_work(progress, [&](Progress& p) { return stock.cut(strokes, p); });
            py::array_t<double> removed(static_cast<py::ssize_t>(way.empty() ? 0 : way.size() - 1));
            auto out = removed.mutable_unchecked<1>();
            for (py::ssize_t i = 0; i < removed.shape(0); ++i) out(i) = 0;
            for (std::size_t i = 0; i < results.size(); ++i)
              out(static_cast<py::ssize_t>(step[i])) += results[i].volume;
            return removed;
          },
          py::arg("tool"), py::arg("poses"), py::arg("progress") = py::none(),
          "Moves a tool (a dict of shape, diameter, flute, ... as in set-ups) evenly from pose to pose; returns mm3 "
          "removed by "
          "each step.")
      .def(
          "mesh",
          [](const cam::Stock& stock, bool sharp) {
            return stock.mesh(nullptr, Progress::none(), sharp ? cam::StockEdges::sharp : cam::StockEdges::sampled);
          },
          py::arg("sharp") = true,
          "The closed surface of what is left, level flats merged; with vertices on edges, unless sharp is False.")
      .def_property_readonly("volume", &cam::Stock::volume)
      .def_property_readonly("bytes", [](const cam::Stock& stock) { return stock.statistics().bytes; })
      .def_property_readonly("splits", [](const cam::Stock& stock) { return stock.statistics().splits; });
}

/// Three lengths, three angles in degrees, three lengths.
cam::AxisValues axes_of(const std::array<double, 9>& given) {
  cam::AxisValues axes;
  for (std::size_t a = 0; a < 9; ++a) axes.at[a] = given[a] * (cam::is_rotary(a) ? radians_per_degree : 1);
  return axes;
}

/// One program, several, or those of the set-up.
using Programs = std::optional<std::variant<std::filesystem::path, std::vector<std::filesystem::path>>>;

std::vector<std::filesystem::path> paths_of(const Programs& programs) {
  if (!programs) return {};
  if (const auto* const one = std::get_if<std::filesystem::path>(&*programs)) return {*one};
  return std::get<std::vector<std::filesystem::path>>(*programs);
}

/// A simulation in Python, with the position in its playback.
struct Simulated {
  cam::SimulationResult result;
  std::optional<cam::Playhead> playhead;
};

Simulated simulated(cam::SimulationResult result) {
  Simulated made{std::move(result), std::nullopt};
  if (made.result.playback()) made.playhead.emplace(made.result.playback());
  return made;
}

/// An array with one number per cut.
template <class Of>
py::array_t<int> of_cuts(const cam::SimulationResult& result, const Of& of) {
  const cam::Cuts& cuts = result.cuts();
  py::array_t<int> out(static_cast<py::ssize_t>(cuts.size()));
  for (std::size_t i = 0; i < cuts.size(); ++i) out.mutable_data()[i] = of(cuts[static_cast<std::uint32_t>(i)]);
  return out;
}

/// Converts a text that may contain bytes of programs: invalid UTF-8 becomes U+FFFD.
py::str text_of(const std::string& bytes) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<py::ssize_t>(bytes.size()), "replace"));
}

py::dict dict_of(const cam::SimulationReport& report) {
  py::list events, notes, lines;
  for (const cam::SimulationEvent& e : report.events)
    events.append(py::dict(py::arg("kind") = cam::name_of(e.kind), py::arg("line") = e.move.line,
                           py::arg("first_line") = e.first_line, py::arg("last_line") = e.last_line,
                           py::arg("tool") = e.move.tool, py::arg("program") = e.move.program,
                           py::arg("place") = std::array<double, 3>{e.place.x(), e.place.y(), e.place.z()},
                           py::arg("amount") = e.amount, py::arg("message") = text_of(e.message)));
  for (const cam::SimulationNote& note : report.notes)
    notes.append(py::dict(py::arg("line") = note.line, py::arg("program") = note.program,
                          py::arg("message") = text_of(note.message)));
  for (const cam::LineRecord& line : report.lines)
    lines.append(py::dict(py::arg("line") = line.line, py::arg("tool") = line.tool, py::arg("program") = line.program,
                          py::arg("removed") = line.removed, py::arg("seconds") = line.seconds,
                          py::arg("cut") = line.cut, py::arg("air") = line.air));
  py::dict d;
  d["good"] = report.good(), d["events"] = events, d["notes"] = notes, d["moves"] = report.moves,
  d["poses"] = report.poses;
  d["seconds"] = report.seconds, d["rapid_seconds"] = report.rapid_seconds, d["cut"] = report.cut,
  d["air"] = report.air;
  d["air_share"] = report.air_share(), d["rapid"] = report.rapid, d["removed"] = report.removed,
  d["left"] = report.left;
  d["cells"] = report.stock.cells, d["splits"] = report.stock.splits, d["bytes"] = report.stock.bytes;
  if (const auto& off = report.deviation)
    d["deviation"] = py::dict(py::arg("deepest_gouge") = off->deepest, py::arg("highest_excess") = off->highest,
                              py::arg("mean") = off->mean, py::arg("rms") = off->root_mean_square);
  d["lines"] = lines, d["programs"] = report.programs;
  return d;
}

void bind_simulation(py::module_& module) {
  py::class_<Simulated>(module, "Simulation", "A program carried out on the stock of a set-up (docs/simulation.md).")
      .def(py::init([](const std::filesystem::path& setup, const Programs& program, const py::object& target,
                       std::optional<double> cell, bool remember, const py::object& stock, const py::object& part,
                       const py::object& progress, const std::optional<std::string>& dialect) {
             const FieldPtr of_job = part.is_none() ? nullptr : field_of(part);
             const FieldPtr wanted = target.is_none() ? nullptr : field_of(target);
             const FieldPtr block = stock.is_none() ? nullptr : field_of(stock);
             return long_work(progress, [&](Progress& p) {
               cam::SimulationSetup made = cam::read_simulation_setup(setup, of_job, p, openscad::all_formats());
               if (wanted) made.target = wanted;
               if (block) made.stock = block;
               if (cell) made.sampling.cell = *cell;
               if (dialect) made.machine.dialect = cam::dialect_named(*dialect, "dialect");
               return simulated(cam::simulate(std::move(made), paths_of(program), {.remember = remember}, p));
             });
           }),
           py::arg("setup"), py::arg("program") = py::none(), py::arg("target") = py::none(),
           py::arg("cell") = py::none(), py::arg("remember") = false, py::arg("stock") = py::none(),
           py::arg("part") = py::none(), py::arg("progress") = py::none(), py::arg("dialect") = py::none(),
           "`program`: a file, or several that are carried out one after the other; None: those that the set-up names. "
           "`dialect`: "
           "\"linuxcnc\", \"fanuc\", \"grbl\" or \"mach3\", instead of the set-up's. `target` and `stock` take the "
           "place of the "
           "set-up's; the stock's shape counts within the set-up's stock box. `part`: "
           "of a "
           "job that names no model, as fieldfab.cam.Job.parse() takes it.")
      .def_property_readonly(
          "playback", [](Simulated& s) { return s.playhead ? &*s.playhead : nullptr; },
          py::return_value_policy::reference_internal, "Any moment of it; None where it was not to remember.")
      .def(
          "frames",
          [](const Simulated& s, const std::filesystem::path& folder, int count, int size, std::optional<double> alpha,
             std::optional<double> beta, const py::object& progress) {
            cam::FrameSettings settings;
            settings.count = count, settings.size = size;
            if (alpha) settings.alpha = *alpha;
            if (beta) settings.beta = *beta;
            long_work(progress, [&](Progress& p) { cam::write_frames(s.result, folder, settings, p); });
          },
          py::arg("folder"), py::arg("count") = 100, py::arg("size") = 800, py::arg("alpha") = py::none(),
          py::arg("beta") = py::none(), py::arg("progress") = py::none(),
          "Writes pictures at even times, for a video; it has to remember.")
      .def_property_readonly(
          "stock_box", [](const Simulated& s) { return bounds_to_python(s.result.setup().stock_box); },
          "Of the material at first, part coordinates.")
      .def_property_readonly(
          "axes",
          [](const Simulated& s) {
            std::string letters = "XYZ";
            for (const cam::RotaryAxis& axis : s.result.setup().machine.kinematics.axes) letters += axis.letter;
            return letters;
          },
          "The letters of the machine's axes.")
      .def(
          "turn_of_work",
          [](const Simulated& s, const std::array<double, 9>& axes) {
            const Eigen::Matrix4d turn = cam::turn_of_work(s.result.setup().machine, axes_of(axes)).matrix();
            py::array_t<double> out({4, 4});
            for (int i = 0; i < 16; ++i) out.mutable_data()[i] = turn(i / 4, i % 4);
            return out;
          },
          py::arg("axes"), "The (4, 4) matrix from part coordinates to where the table has turned the part.")
      .def_property_readonly(
          "lines_of_cuts",
          [](const Simulated& s) { return of_cuts(s.result, [](const cam::Cut& cut) { return cut.move.line; }); },
          "The program's line of each cut that Surface.to_draw() tells.")
      .def_property_readonly(
          "tools_of_cuts",
          [](const Simulated& s) { return of_cuts(s.result, [](const cam::Cut& cut) { return cut.move.tool; }); },
          "And its tool; 0 for the stock's first surface.")
      .def_property_readonly(
          "colours_of_tools",
          [](const Simulated& s) {
            std::map<int, std::array<std::uint8_t, 3>> colours{{0, channels_of(cam::colour_of_tool(0))}};
            for (const auto& [number, tool] : s.result.setup().tools)
              colours.try_emplace(number, channels_of(cam::colour_of_tool(colours.size())));
            return colours;
          },
          "Red, green and blue by tool number, as pictures have them; 0: the stock's first surface.")
      .def_property_readonly(
          "deviation_scale",
          [](const Simulated& s) -> py::object {
            if (!s.result.report().deviation) return py::none();
            const auto scale = cam::DeviationScale::of(s.result);
            return py::dict(py::arg("gouge") = scale.gouge, py::arg("excess") = scale.excess,
                            py::arg("full") = scale.full);
          },
          "Tolerances, and from where on a colour is full, mm. None without a target.")
      .def(
          "colour_of_deviation",
          [](const Simulated& s, double deviation) {
            return channels_of(cam::DeviationScale::of(s.result).colour(deviation));
          },
          py::arg("deviation"), "Red, green and blue.")
      .def_property_readonly("good", [](const Simulated& s) { return s.result.report().good(); })
      .def_property_readonly(
          "report", [](const Simulated& s) { return dict_of(s.result.report()); },
          "Events, times, lengths and volumes, as the command's --report has them.")
      .def_property_readonly(
          "mesh", [](const Simulated& s) { return s.result.surface().mesh; },
          "The surface of what is left, level flats merged.")
      .def_property_readonly("stock", [](const Simulated& s) { return cam::Stock(s.result.stock()); })
      .def_property_readonly(
          "lines_of_vertices",
          [](const Simulated& s) {
            const std::vector<int> lines = s.result.lines_of_vertices();
            return py::array_t<int>(static_cast<py::ssize_t>(lines.size()), lines.data());
          },
          "For each vertex of the mesh the program's line that made it; 0 for the stock's first surface.")
      .def_property_readonly(
          "tools_of_vertices",
          [](const Simulated& s) {
            const std::vector<int> tools = s.result.tools_of_vertices();
            return py::array_t<int>(static_cast<py::ssize_t>(tools.size()), tools.data());
          },
          "And the tool that did.")
      .def_property_readonly(
          "colours",
          [](const Simulated& s) {
            const std::vector<Colour> colours = cam::vertex_colours(s.result, cam::default_colouring(s.result));
            py::array_t<std::uint8_t> out({static_cast<py::ssize_t>(colours.size()), py::ssize_t{3}});
            if (!colours.empty()) std::memcpy(out.mutable_data(), colours.data(), 3 * colours.size());
            return out;
          },
          "Of each vertex, (n, 3) bytes: by its deviation from the target; without one, by its tool or line.")
      .def(
          "picture",
          [](const Simulated& s, int size, std::optional<double> alpha, std::optional<double> beta, bool marks,
             const py::object& progress) {
            cam::StockPictureSettings view;
            view.size = size, view.marks = marks;
            if (alpha) view.alpha = *alpha;
            if (beta) view.beta = *beta;
            const Image image =
                long_work(progress, [&](Progress& p) { return cam::stock_picture(s.result, view, p).image; });
            py::array_t<std::uint8_t> out({py::ssize_t{image.height}, py::ssize_t{image.width}, py::ssize_t{3}});
            std::memcpy(out.mutable_data(), image.pixels8.data(), image.pixels8.size());
            return out;
          },
          py::arg("size") = 1024, py::arg("alpha") = py::none(), py::arg("beta") = py::none(), py::arg("marks") = true,
          py::arg("progress") = py::none(),
          "What is left as (height, width, 3) bytes, turned by alpha about z, then by beta about x (radians); with the "
          "worst "
          "events numbered.")
      .def(
          "save",
          [](const Simulated& s, const std::filesystem::path& filename, const py::object& progress) {
            long_work(progress, [&](Progress& p) { cam::write_stock_mesh(s.result, filename, p); });
          },
          py::arg("filename"), py::arg("progress") = py::none(),
          "Writes what is left as a mesh; a .ply has colours, deviation, line and tool of its vertices.")
      .def(
          "html",
          [](const Simulated& s, const std::filesystem::path& filename, const py::object& progress) {
            long_work(progress, [&](Progress& p) { cam::write_html_report(s.result, filename, p); });
          },
          py::arg("filename"), py::arg("progress") = py::none(), "Writes the report as one HTML page with pictures.")
      .def_property_readonly(
          "deviation",
          [](const Simulated& s) -> py::object {
            if (!s.result.report().deviation) return py::none();
            const auto& at = s.result.report().deviation->at_vertex;
            return py::array_t<float>(static_cast<py::ssize_t>(at.size()), at.data());
          },
          "For each vertex its signed distance from the target, mm: above 0 where material is left over. None without "
          "a target.");
}

}  // namespace

void bind_stock(py::module_& parent) {
  py::module_ module = parent.def_submodule("stock", "Simulated stock.");
  bind_block(module);
  bind_playback(module);
  bind_simulation(module);
}

}  // namespace fieldfab::python
