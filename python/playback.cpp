#include <cstring>

#include "bindings.h"
#include "fieldfab/cam/simulate/frames.h"
#include "fieldfab/cam/simulate/playback.h"
#include "fieldfab/cam/stock/stock.h"
#include "fieldfab/cam/stock/surface.h"
#include "fieldfab/core/angle.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab::python {
namespace {

/// (vertices, normals, corners, cuts); corners end with -1, as in Coin.
py::tuple arrays_of(const cam::DrawnSurface& surface) {
  const auto rows = [](const std::vector<std::array<float, 3>>& vectors) {
    py::array_t<float> out({static_cast<py::ssize_t>(vectors.size()), py::ssize_t{3}});
    if (!vectors.empty()) std::memcpy(out.mutable_data(), vectors.data(), sizeof(float) * 3 * vectors.size());
    return out;
  };
  py::array_t<std::int32_t> corners({static_cast<py::ssize_t>(surface.triangles.size()), py::ssize_t{4}});
  std::int32_t* corner = corners.mutable_data();
  for (const auto& t : surface.triangles) {
    for (const std::uint32_t v : t) *corner++ = static_cast<std::int32_t>(v);
    *corner++ = -1;
  }
  py::array_t<std::uint32_t> cuts(static_cast<py::ssize_t>(surface.cuts.size()), surface.cuts.data());
  return py::make_tuple(rows(surface.vertices), rows(surface.normals), corners, cuts);
}

void bind_surface(py::module_& module) {
  module.def(
      "to_draw",
      [](const TriangleMesh& mesh) {
        const auto surface = long_work(py::none(), [&](Progress&) { return cam::drawn(mesh); });
        return py::tuple(arrays_of(surface)[py::slice(0, 3, 1)]);
      },
      py::arg("mesh"),
      "A mesh's arrays for drawing: (n, 3) float32 vertices, their normals, (m, 4) int32 corners that end with -1.");
  py::class_<cam::StockSurface>(module, "Surface",
                                "The surface of a stock in pieces, which are made anew only where it was cut.")
      .def(py::init<>())
      .def(
          "update",
          [](cam::StockSurface& surface, const cam::Stock& stock, const py::object& progress) {
            return long_work(progress, [&](Progress& p) { return surface.update(stock, p); });
          },
          py::arg("stock"), py::arg("progress") = py::none(),
          "Brings it up to date; returns the indices of the pieces that have changed.")
      .def("__len__", &cam::StockSurface::pieces)
      .def(
          "piece", [](const cam::StockSurface& surface, std::size_t index) { return surface.piece(index); },
          py::arg("index"), "A mesh of one piece, to be drawn with the others.")
      .def(
          "to_draw",
          [](const cam::StockSurface& surface, const std::vector<std::size_t>& indices, int coarse) {
            if (coarse < 1 || coarse > 64) throw Error(ErrorKind::bad_input, "coarse", "it is 1 to 64 cells");
            std::vector<cam::DrawnSurface> pieces(indices.size());
            long_work(py::none(), [&](Progress&) {
              parallel_for(indices.size(), [&](std::size_t i) { pieces[i] = surface.drawn_piece(indices[i], coarse); });
            });
            py::list out;
            for (const cam::DrawnSurface& piece : pieces) out.append(arrays_of(piece));
            return out;
          },
          py::arg("indices"), py::arg("coarse") = 1,
          "Pieces for drawing: for each one (n, 3) float32 vertices, their normals, (m, 4) int32 corners that end with "
          "-1, and "
          "the "
          "cut that made each vertex. Flats have few triangles; where coarse is above 1, blocks of so many cells "
          "become one.")
      .def(
          "mesh", [](const cam::StockSurface& surface) { return surface.mesh(); },
          "All of it as one closed mesh, level flats merged.");
}

/// An array with one number per move.
template <class Number, class Of>
py::array_t<Number> of_moves(const cam::Playhead& head, const Of& of) {
  const cam::Playback& playback = head.playback();
  py::array_t<Number> out(static_cast<py::ssize_t>(playback.moves()));
  for (std::size_t i = 0; i < playback.moves(); ++i) out.mutable_data()[i] = of(playback.move(i));
  return out;
}

void bind_moves(py::module_& module) {
  py::class_<cam::Playhead>(module, "Playback", "The moves of a program, and the stock at any moment.")
      .def("__len__", [](const cam::Playhead& head) { return head.playback().moves(); })
      .def_property_readonly(
          "lines",
          [](const cam::Playhead& head) { return of_moves<int>(head, [](const auto& move) { return move.line; }); },
          "The program's line of each move.")
      .def_property_readonly(
          "tools",
          [](const cam::Playhead& head) { return of_moves<int>(head, [](const auto& move) { return move.tool; }); },
          "The tool of each move.")
      .def_property_readonly(
          "rapid",
          [](const cam::Playhead& head) { return of_moves<bool>(head, [](const auto& move) { return move.rapid; }); })
      .def_property_readonly(
          "seconds",
          [](const cam::Playhead& head) {
            return of_moves<double>(head, [](const auto& move) { return move.seconds; });
          },
          "Machine time at the end of each move.")
      .def(
          "done_after_line",
          [](const cam::Playhead& head, int line, int program) {
            return head.playback().done_after_line(line, program);
          },
          py::arg("line"), py::arg("program") = 0, "How many moves are done after a line.")
      .def(
          "done_after_seconds",
          [](const cam::Playhead& head, double seconds) { return head.playback().done_after_seconds(seconds); },
          py::arg("seconds"), "How many are done after a time.")
      .def(
          "poses",
          [](const cam::Playhead& head, std::size_t move) {
            const auto way = head.playback().poses(move);
            py::array_t<double> out({static_cast<py::ssize_t>(way.size()), py::ssize_t{6}});
            auto rows = out.mutable_unchecked<2>();
            for (py::ssize_t i = 0; i < rows.shape(0); ++i)
              for (py::ssize_t a = 0; a < 3; ++a) {
                const cam::ToolPose& pose = way[static_cast<std::size_t>(i)];
                rows(i, a) = pose.tip[a], rows(i, a + 3) = pose.axis[a];
              }
            return out;
          },
          py::arg("move"), "Rows of tip and axis that a move's tool passes, part coordinates.")
      .def(
          "at",
          [](const cam::Playhead& head, double seconds) {
            const cam::Playback& playback = head.playback();
            if (playback.moves() == 0) throw Error(ErrorKind::bad_input, "playback", "nothing moves");
            const cam::Playback::Moment moment = playback.at(seconds);
            const cam::Playback::Move& move = playback.move(moment.move);
            std::array<double, 9> axes = moment.axes.at;
            for (std::size_t a = 3; a < 6; ++a) axes[a] *= degrees_per_radian;
            const auto list = [](const Vec3& v) { return std::array<double, 3>{v.x(), v.y(), v.z()}; };
            return py::dict(py::arg("move") = moment.move, py::arg("line") = move.line, py::arg("tool") = move.tool,
                            py::arg("rapid") = move.rapid, py::arg("tip") = list(moment.pose.tip),
                            py::arg("axis") = list(moment.pose.axis), py::arg("axes") = axes);
          },
          py::arg("seconds"),
          "What is done at a moment: move, line, tool, rapid, the tool's tip and axis (part coordinates), and where "
          "the "
          "machine's "
          "nine axes stand, mm and degrees.")
      .def(
          "tool_mesh",
          [](const cam::Playhead& head, std::size_t move, const std::string& role) {
            for (const auto& [name, which] : {std::pair{"cutting", cam::ToolRole::cutting},
                                              {"shank", cam::ToolRole::shank},
                                              {"holder", cam::ToolRole::holder}})
              if (role == name) return cam::tool_mesh(head.playback().tool(move), which, {});
            throw Error(ErrorKind::bad_input, "role", "it is cutting, shank or holder");
          },
          py::arg("move"), py::arg("role"), "One part of a move's tool, its tip at the origin, its axis along z.")
      .def(
          "stock_at",
          [](cam::Playhead& head, double seconds, const py::object& progress) {
            return long_work(progress,
                             [&](Progress& p) { return std::make_unique<cam::Stock>(head.stock_at(seconds, p)); });
          },
          py::arg("seconds"), py::arg("progress") = py::none(),
          "The stock at a moment, in the middle of a move mostly.")
      .def(
          "stock_after",
          [](cam::Playhead& head, std::size_t moves, const py::object& progress) {
            return long_work(progress,
                             [&](Progress& p) { return std::make_unique<cam::Stock>(head.stock_after(moves, p)); });
          },
          py::arg("moves"), py::arg("progress") = py::none(), "The stock when so many moves are done.");
}

}  // namespace

void bind_playback(py::module_& module) {
  bind_surface(module);
  bind_moves(module);
}

}  // namespace fieldfab::python
