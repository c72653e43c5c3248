#include "fieldfab/cam/stock/stock.h"

#include <array>
#include <cstring>
#include <numbers>

#include "bindings.h"
#include "fieldfab/cam/simulate/frames.h"
#include "fieldfab/cam/simulate/html_report.h"
#include "fieldfab/cam/simulate/picture.h"
#include "fieldfab/cam/simulate/playback.h"
#include "fieldfab/cam/simulate/simulation.h"
#include "fieldfab/core/error.h"
#include "fieldfab/mesh/triangle_mesh.h"
#include "fieldfab/openscad/design.h"

namespace fieldfab::python {
namespace {

using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Red, green and blue, as Python has colours.
std::array<std::uint8_t, 3> channels_of(const Colour& colour) { return {colour.red, colour.green, colour.blue}; }

/// Poses as rows of x, y, z of the tip and, where there are six numbers, of the tool's axis.
std::vector<cam::ToolPose> poses_of(const Rows& rows) {
  if (rows.ndim() != 2 || (rows.shape(1) != 3 && rows.shape(1) != 6))
    throw Error(ErrorKind::bad_input, "poses", "an (n, 3) array of tips or an (n, 6) array of tips and axes is wanted");
  const auto in = rows.unchecked<2>();
  std::vector<cam::ToolPose> poses;
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    cam::ToolPose pose{{in(i, 0), in(i, 1), in(i, 2)}, Vec3::UnitZ()};
    if (rows.shape(1) == 6) pose.axis = Vec3(in(i, 3), in(i, 4), in(i, 5)).normalized();
    if (!pose.tip.allFinite() || !pose.axis.allFinite()) throw Error(ErrorKind::bad_input, "poses", "they must be finite");
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
      tool.angle = value.cast<double>() * std::numbers::pi / 180;
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
             return long_work(progress, [&](Progress& p) { return std::make_unique<cam::Stock>(*field, *box, settings, p); });
           }),
           py::arg("bounds"), py::arg("cell") = 0.2, py::arg("solid") = py::none(), py::arg("progress") = py::none())
      .def(
          "copy", [](const cam::Stock& stock) { return std::make_unique<cam::Stock>(stock); },
          "A checkpoint: it shares what does not change.")
      .def(
          "cut",
          [](cam::Stock& stock, const py::dict& tool, const Rows& poses, const py::object& progress) {
            const cam::ToolSolid solid = cam::tool_solid(tool_of(tool));
            const std::vector<cam::ToolPose> way = poses_of(poses);
            std::vector<cam::Stroke> strokes;
            std::vector<std::size_t> step;
            for (std::size_t i = 1; i < way.size(); ++i)
              for (const cam::ToolPiece& piece : solid.pieces)
                if (piece.role == cam::ToolRole::cutting)
                  strokes.push_back({&piece, way[i - 1], way[i], static_cast<std::uint32_t>(i), true}), step.push_back(i - 1);
            const auto results = long_work(progress, [&](Progress& p) { return stock.cut(strokes, p); });
            py::array_t<double> removed(static_cast<py::ssize_t>(way.empty() ? 0 : way.size() - 1));
            auto out = removed.mutable_unchecked<1>();
            for (py::ssize_t i = 0; i < removed.shape(0); ++i) out(i) = 0;
            for (std::size_t i = 0; i < results.size(); ++i) out(static_cast<py::ssize_t>(step[i])) += results[i].volume;
            return removed;
          },
          py::arg("tool"), py::arg("poses"), py::arg("progress") = py::none(),
          "Moves a tool (a dict of shape, diameter, flute, ... as in set-ups) evenly from pose to pose; returns mm3 removed by "
          "each step.")
      .def(
          "mesh", [](const cam::Stock& stock) { return stock.mesh(); }, "The closed surface of what is left, level flats merged.")
      .def_property_readonly("volume", &cam::Stock::volume)
      .def_property_readonly("bytes", [](const cam::Stock& stock) { return stock.statistics().bytes; })
      .def_property_readonly("splits", [](const cam::Stock& stock) { return stock.statistics().splits; });
}

/// Three lengths, three angles in degrees, three lengths.
cam::AxisValues axes_of(const std::array<double, 9>& given) {
  cam::AxisValues axes;
  for (std::size_t a = 0; a < 9; ++a) axes.at[a] = given[a] * (a >= 3 && a < 6 ? std::numbers::pi / 180 : 1);
  return axes;
}

/// One number of each cut.
template <class Of>
py::array_t<int> of_cuts(const cam::Simulation& simulation, const Of& of) {
  py::array_t<int> out(static_cast<py::ssize_t>(simulation.cuts()));
  for (std::size_t i = 0; i < simulation.cuts(); ++i) out.mutable_data()[i] = of(static_cast<std::uint32_t>(i));
  return out;
}

void bind_simulation(py::module_& module) {
  py::class_<cam::Simulation>(module, "Simulation", "A program carried out on the stock of a set-up (docs/simulation.md).")
      .def(py::init([](const std::filesystem::path& setup, const std::filesystem::path& program, const py::object& target,
                       std::optional<double> cell, bool remember, const py::object& stock, const py::object& part,
                       const py::object& progress) {
             const FieldPtr of_job = part.is_none() ? nullptr : field_of(part);
             const FieldPtr wanted = target.is_none() ? nullptr : field_of(target);
             const FieldPtr block = stock.is_none() ? nullptr : field_of(stock);
             return long_work(progress, [&](Progress& p) {
               cam::SimulationSetup made = cam::read_simulation_setup(setup, of_job, p, openscad::all_formats());
               if (wanted) made.target = wanted;
               if (block) made.stock = block;
               if (cell) made.sampling.cell = *cell;
               auto simulation = std::make_unique<cam::Simulation>(std::move(made), p);
               if (remember) simulation->remember();
               simulation->run(program, p);
               simulation->finish(p);
               return simulation;
             });
           }),
           py::arg("setup"), py::arg("program"), py::arg("target") = py::none(), py::arg("cell") = py::none(),
           py::arg("remember") = false, py::arg("stock") = py::none(), py::arg("part") = py::none(),
           py::arg("progress") = py::none(),
           "`target` and `stock` take the place of the set-up's; the stock's shape counts within the set-up's stock box. `part`: "
           "of a "
           "job that names no model, as fieldfab.cam.Job.parse() takes it.")
      .def_property_readonly(
          "playback", [](cam::Simulation& s) { return s.playback(); }, py::return_value_policy::reference_internal,
          "Any moment of it; None where it was not to remember.")
      .def(
          "frames",
          [](cam::Simulation& s, const std::filesystem::path& folder, int count, int size, std::optional<double> alpha,
             std::optional<double> beta, const py::object& progress) {
            cam::FrameSettings settings;
            settings.count = count, settings.size = size;
            if (alpha) settings.alpha = *alpha;
            if (beta) settings.beta = *beta;
            long_work(progress, [&](Progress& p) { cam::write_frames(s, folder, settings, p); });
          },
          py::arg("folder"), py::arg("count") = 100, py::arg("size") = 800, py::arg("alpha") = py::none(),
          py::arg("beta") = py::none(), py::arg("progress") = py::none(),
          "Writes pictures at even times, for a video; it has to remember.")
      .def_property_readonly(
          "stock_box", [](const cam::Simulation& s) { return bounds_to_python(s.setup().stock_box); },
          "Of the material at first, part coordinates.")
      .def_property_readonly(
          "axes",
          [](const cam::Simulation& s) {
            std::string letters = "XYZ";
            for (const cam::RotaryAxis& axis : s.setup().machine.kinematics.axes) letters += axis.letter;
            return letters;
          },
          "The letters of the machine's axes.")
      .def(
          "turn_of_work",
          [](const cam::Simulation& s, const std::array<double, 9>& axes) {
            const Eigen::Matrix4d turn = cam::turn_of_work(s.setup().machine, axes_of(axes)).matrix();
            py::array_t<double> out({4, 4});
            for (int i = 0; i < 16; ++i) out.mutable_data()[i] = turn(i / 4, i % 4);
            return out;
          },
          py::arg("axes"), "The (4, 4) matrix from part coordinates to where the table has turned the part.")
      .def_property_readonly(
          "lines_of_cuts", [](const cam::Simulation& s) { return of_cuts(s, [&](auto cut) { return s.line_of(cut); }); },
          "The program's line of each cut that Surface.to_draw() tells.")
      .def_property_readonly(
          "tools_of_cuts", [](const cam::Simulation& s) { return of_cuts(s, [&](auto cut) { return s.tool_of(cut); }); },
          "And its tool; 0 for the stock's first surface.")
      .def_property_readonly(
          "colours_of_tools",
          [](const cam::Simulation& s) {
            std::map<int, std::array<std::uint8_t, 3>> colours{{0, channels_of(cam::colour_of_tool(0))}};
            for (const auto& [number, tool] : s.setup().tools)
              colours.try_emplace(number, channels_of(cam::colour_of_tool(colours.size())));
            return colours;
          },
          "Red, green and blue by tool number, as pictures have them; 0: the stock's first surface.")
      .def_property_readonly(
          "deviation_scale",
          [](const cam::Simulation& s) -> py::object {
            if (!s.report().deviation) return py::none();
            const auto scale = cam::DeviationScale::of(s);
            return py::dict(py::arg("gouge") = scale.gouge, py::arg("excess") = scale.excess, py::arg("full") = scale.full);
          },
          "Tolerances, and from where on a colour is full, mm. None without a target.")
      .def(
          "colour_of_deviation",
          [](const cam::Simulation& s, double deviation) { return channels_of(cam::DeviationScale::of(s).colour(deviation)); },
          py::arg("deviation"), "Red, green and blue.")
      .def_property_readonly("good", [](const cam::Simulation& s) { return s.report().good(); })
      .def_property_readonly(
          "report",
          [](const cam::Simulation& s) { return py::module_::import("json").attr("loads")(cam::to_json(s.report(), true)); },
          "Events, times, lengths and volumes, as the command's --report has them.")
      .def_property_readonly(
          "mesh", [](const cam::Simulation& s) { return s.mesh(); }, "The surface of what is left, level flats merged.")
      .def_property_readonly("stock", [](const cam::Simulation& s) { return cam::Stock(s.stock()); })
      .def_property_readonly(
          "lines_of_vertices",
          [](const cam::Simulation& s) {
            return py::array_t<int>(static_cast<py::ssize_t>(s.lines_of_vertices().size()), s.lines_of_vertices().data());
          },
          "For each vertex of the mesh the program's line that made it; 0 for the stock's first surface.")
      .def_property_readonly(
          "tools_of_vertices",
          [](const cam::Simulation& s) {
            return py::array_t<int>(static_cast<py::ssize_t>(s.tools_of_vertices().size()), s.tools_of_vertices().data());
          },
          "And the tool that did.")
      .def_property_readonly(
          "colours",
          [](const cam::Simulation& s) {
            const std::vector<Colour> colours = cam::vertex_colours(s, cam::default_colouring(s));
            py::array_t<std::uint8_t> out({static_cast<py::ssize_t>(colours.size()), py::ssize_t{3}});
            if (!colours.empty()) std::memcpy(out.mutable_data(), colours.data(), 3 * colours.size());
            return out;
          },
          "Of each vertex, (n, 3) bytes: by its deviation from the target; without one, by its tool or line.")
      .def(
          "picture",
          [](const cam::Simulation& s, int size, std::optional<double> alpha, std::optional<double> beta, bool marks,
             const py::object& progress) {
            cam::StockPictureSettings view;
            view.size = size, view.marks = marks;
            if (alpha) view.alpha = *alpha;
            if (beta) view.beta = *beta;
            const Image image = long_work(progress, [&](Progress& p) { return cam::stock_picture(s, view, p).image; });
            py::array_t<std::uint8_t> out({py::ssize_t{image.height}, py::ssize_t{image.width}, py::ssize_t{3}});
            std::memcpy(out.mutable_data(), image.pixels8.data(), image.pixels8.size());
            return out;
          },
          py::arg("size") = 1024, py::arg("alpha") = py::none(), py::arg("beta") = py::none(), py::arg("marks") = true,
          py::arg("progress") = py::none(),
          "What is left as (height, width, 3) bytes, turned by alpha about z, then by beta about x (radians); with the worst "
          "events numbered.")
      .def(
          "save",
          [](const cam::Simulation& s, const std::filesystem::path& filename, const py::object& progress) {
            long_work(progress, [&](Progress& p) { cam::write_stock_mesh(s, filename, p); });
          },
          py::arg("filename"), py::arg("progress") = py::none(),
          "Writes what is left as a mesh; a .ply has colours, deviation, line and tool of its vertices.")
      .def(
          "html",
          [](const cam::Simulation& s, const std::filesystem::path& filename, const py::object& progress) {
            long_work(progress, [&](Progress& p) { cam::write_html_report(s, filename, p); });
          },
          py::arg("filename"), py::arg("progress") = py::none(), "Writes the report as one HTML page with pictures.")
      .def_property_readonly(
          "deviation",
          [](const cam::Simulation& s) -> py::object {
            if (!s.report().deviation) return py::none();
            const auto& at = s.report().deviation->at_vertex;
            return py::array_t<float>(static_cast<py::ssize_t>(at.size()), at.data());
          },
          "For each vertex its signed distance from the target, mm: above 0 where material is left over. None without a target.");
}

}  // namespace

void bind_stock(py::module_& parent) {
  py::module_ module = parent.def_submodule("stock", "Simulated stock.");
  bind_block(module);
  bind_playback(module);
  bind_simulation(module);
}

}  // namespace fieldfab::python
