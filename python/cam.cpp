#include "bindings.h"
#include "fieldfab/cam/job/job.h"
#include "fieldfab/cam/job/picture.h"
#include "fieldfab/cam/plan/contour.h"
#include "fieldfab/cam/plan/distance.h"
#include "fieldfab/core/error.h"
#include "fieldfab/openscad/design.h"

namespace fieldfab::python {
namespace {

Array<double> rows_of(const cam::Loop& loop) {
  Array<double> rows({static_cast<py::ssize_t>(loop.points.size()), py::ssize_t{2}});
  auto out = rows.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < rows.shape(0); ++i)
    for (py::ssize_t k = 0; k < 2; ++k) out(i, k) = loop.points[static_cast<std::size_t>(i)][k];
  return rows;
}

py::list lists_of(const cam::Loops& loops) {
  py::list out;
  for (const cam::Loop& loop : loops) out.append(rows_of(loop));
  return out;
}

cam::Loops loops_of(const std::vector<Array<double>>& given) {
  cam::Loops loops;
  for (const Array<double>& rows : given) {
    if (rows.ndim() != 2 || rows.shape(1) != 2 || rows.shape(0) < 3)
      throw Error(ErrorKind::bad_input, "loops", "a loop is an (n, 2) array of at least three points");
    cam::Loop loop;
    const auto in = rows.unchecked<2>();
    for (py::ssize_t i = 0; i < rows.shape(0); ++i) loop.points.emplace_back(in(i, 0), in(i, 1));
    loops.push_back(std::move(loop));
  }
  return loops;
}

/// Array<double> of x, y, z, feed, bulge and the tool's axis, one per move.
Array<double> rows_of(const std::vector<cam::Move>& moves) {
  Array<double> rows({static_cast<py::ssize_t>(moves.size()), py::ssize_t{8}});
  auto out = rows.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    const cam::Move& m = moves[static_cast<std::size_t>(i)];
    const double row[] = {m.to.x(), m.to.y(), m.to.z(), m.feed, m.bulge, m.axis.x(), m.axis.y(), m.axis.z()};
    for (py::ssize_t k = 0; k < 8; ++k) out(i, k) = row[k];
  }
  return rows;
}

py::dict dict_of(const cam::OperationReport& r) {
  py::dict d;
  d["name"] = r.name, d["paths"] = r.paths, d["air_before"] = r.air.before, d["air_after"] = r.air.after;
  d["cut"] = r.length.cut, d["rapid"] = r.length.rapid, d["seconds"] = r.seconds;
  d["planned_seconds"] = r.planned_seconds.value_or(r.seconds);
  return d;
}

py::dict dict_of(const cam::Section& s) {
  py::dict d;
  d["name"] = s.name, d["tool"] = s.tool.number, d["tool_name"] = s.tool.name, d["spindle"] = s.spindle;
  d["coolant"] = s.coolant == cam::Coolant::none ? "" : cam::name_of(s.coolant), d["setup"] = s.setup,
  d["clearance"] = s.clearance, d["tilted"] = s.tilted();
  return d;
}

void bind_job(py::module_& module) {
  py::class_<cam::Job>(module, "Job", "A part, a machine, tools and operations, as a job file says (docs/cam.md).")
      .def(py::init([](const std::filesystem::path& path, const py::object& progress) {
             return long_work(progress, [&](Progress& p) {
               return std::make_unique<cam::Job>(cam::Job::read(path, p, openscad::all_formats()));
             });
           }),
           py::arg("filename"), py::arg("progress") = py::none())
      .def_static(
          "parse",
          [](const std::string& text, const py::object& solid, const std::filesystem::path& filename,
             const py::object& progress) {
            const FieldPtr part = solid.is_none() ? nullptr : field_of(solid);
            return long_work(progress, [&](Progress& p) {
              return std::make_unique<cam::Job>(cam::Job::parse(text, filename, part, p, openscad::all_formats()));
            });
          },
          py::arg("text"), py::arg("solid") = py::none(), py::arg("filename") = "job", py::arg("progress") = py::none(),
          "The job of a file's text, with its part where that is given; `filename` is what messages call it.")
      .def("plan", &cam::Job::plan, "The chains of stages with all settings, as text.")
      .def(
          "adjust_feeds",
          [](cam::Job& job, double least, double most) {
            job.adjust_feeds({least, most});
          },
          py::arg("least") = cam::FeedLimits{}.least, py::arg("most") = cam::FeedLimits{}.most,
          "Has run() adjust feeds to the material that each move removes, within these parts of the planned feed.")
      .def(
          "run",
          [](cam::Job& job, const py::object& progress) { long_work(progress, [&](Progress& p) { job.run(p); }); },
          py::arg("progress") = py::none(), "Plans all paths.")
      .def(
          "save", [](const cam::Job& job, const std::filesystem::path& path) { job.write(path); }, py::arg("filename"),
          "Writes the machine's program, after run().")
      .def(
          "sheet", [](const cam::Job& job, const std::filesystem::path& path) { cam::write_setup_sheet(job, path); },
          py::arg("filename"), "Writes the set-up sheet, an .html file, after run().")
      .def_property_readonly("machine", [](const cam::Job& job) { return job.machine().name; })
      .def_property_readonly("reports",
                             [](const cam::Job& job) {
                               py::list out;
                               for (const auto& r : job.reports()) out.append(dict_of(r));
                               return out;
                             })
      .def_property_readonly("notes", &cam::Job::notes)
      .def_property_readonly(
          "sections",
          [](const cam::Job& job) {
            py::list out;
            for (const cam::Section& section : job.program().sections) out.append(dict_of(section));
            return out;
          },
          "For each operation's run of moves: name, tool, tool_name, spindle, coolant, setup, clearance, tilted.")
      .def_property_readonly(
          "stock", [](const cam::Job& job) { return bounds_to_python(job.stock()); }, "As the program counts.")
      .def_property_readonly(
          "zero", [](const cam::Job& job) { return std::make_tuple(job.zero().x(), job.zero().y(), job.zero().z()); },
          "Where the program's zero is in the model's coordinates.")
      .def_property_readonly(
          "moves",
          [](const cam::Job& job) {
            py::list out;
            for (const cam::Section& section : job.program().sections) out.append(rows_of(section.moves));
            return out;
          },
          "For each operation an (n, 8) array: x, y, z, feed (mm/min, 0 for rapids), bulge, and the tool's axis.");
}

}  // namespace

void bind_cam(py::module_& parent) {
  py::module_ module = parent.def_submodule("cam", "Toolpaths and machines.");
  bind_job(module);
  bind_workflow(module);
  module.def(
      "machines",
      [] {
        py::dict out;
        for (const auto& [id, text] : cam::machine_files()) out[py::str(id)] = cam::load_machine(id).name;
        return out;
      },
      "The machines that come with Fieldfab: id to name.");
  module.def(
      "distance_transform",
      [](const py::array_t<bool, py::array::c_style | py::array::forcecast>& bitmap, double cell) {
        if (bitmap.ndim() != 2) throw Error(ErrorKind::bad_input, "bitmap", "must have two axes");
        cam::Bitmap samples(static_cast<int>(bitmap.shape(1)), static_cast<int>(bitmap.shape(0)), cell,
                            cam::Vec2::Zero(), 0);
        std::transform(bitmap.data(), bitmap.data() + bitmap.size(), samples.values.begin(),
                       [](bool b) { return b ? 1 : 0; });
        const cam::Lattice<float> distance = cam::distance_transform(samples);
        return py::array_t<float>({bitmap.shape(0), bitmap.shape(1)}, distance.values.data());
      },
      py::arg("bitmap"), py::arg("cell") = 1.0,
      "Exact distance from each sample to the nearest True one, in mm (Meijster).");
  module.def(
      "contours",
      [](const py::object& solid, const py::object& bounds, double cell, double z, double level,
         const py::object& progress) {
        const auto wanted = solid_of(solid);
        return lists_of(long_work(progress, [&](Progress& p) {
          return cam::contours(*wanted->field, cam::Rectangle::of(region_of(*wanted, bounds, p)), {cell, z, level}, p);
        }));
      },
      py::arg("solid"), py::arg("bounds") = py::none(), py::arg("cell") = 0.1, py::arg("z") = 0.0,
      py::arg("level") = 0.0, py::arg("progress") = py::none(),
      "Closed curves where the solid is cut by a plane: (n, 2) arrays, the solid on their left.");
  module.def(
      "offset",
      [](const std::vector<Array<double>>& loops, double distance, double cell) {
        return lists_of(cam::offset(loops_of(loops), distance, cell));
      },
      py::arg("loops"), py::arg("distance"), py::arg("cell") = 0.1, "The loops moved outward by a distance, mm.");
}

}  // namespace fieldfab::python
