#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "bindings.h"
#include "fieldfab/check/check.h"
#include "fieldfab/check/vdb.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/contour/detail.h"
#include "fieldfab/core/error.h"
#include "fieldfab/mesh/bms.h"
#include "fieldfab/mesh/mesh_distances.h"
#include "fieldfab/mesh/mesh_field.h"
#include "fieldfab/mesh/mesh_parts.h"
#include "fieldfab/mesh/ply.h"
#include "fieldfab/render/render.h"

namespace fieldfab::python {
namespace {

/// A NumPy view of memory that `owner` keeps alive.
template <class Number>
py::array_t<Number> view(Number* data, std::vector<py::ssize_t> shape, const py::object& owner) {
  py::array_t<Number> array(std::move(shape), data, owner);
  return array;
}

TriangleMesh mesh_of(const Array<float>& vertices, const Array<std::uint32_t>& triangles) {
  const auto check_rows = [](const py::array& a, const char* name) {
    if (a.ndim() != 2 || a.shape(1) != 3) throw Error(ErrorKind::bad_input, name, "needs three numbers a row");
  };
  check_rows(vertices, "vertices");
  check_rows(triangles, "triangles");
  TriangleMesh mesh;
  mesh.vertices.resize(static_cast<std::size_t>(vertices.shape(0)));
  mesh.triangles.resize(static_cast<std::size_t>(triangles.shape(0)));
  if (!mesh.vertices.empty())
    std::memcpy(mesh.vertices.data(), vertices.data(), sizeof(float) * 3 * mesh.vertices.size());
  if (!mesh.triangles.empty())
    std::memcpy(mesh.triangles.data(), triangles.data(), sizeof(std::uint32_t) * 3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle)
      if (corner >= mesh.vertices.size())
        throw Error(ErrorKind::bad_input, "triangles", "an index is past the last vertex");
  for (const auto& vertex : mesh.vertices)
    for (const float number : vertex)
      if (!std::isfinite(number)) throw Error(ErrorKind::bad_input, "vertices", "a position is not a number");
  return mesh;
}

}  // namespace

void bind_results(py::module_& module) {
  py::class_<TriangleMesh>(module, "Mesh", "A triangle mesh; its arrays are views of the kernel's own memory.")
      .def(py::init(&mesh_of), py::arg("vertices"), py::arg("triangles"),
           "Of (n, 3) positions in mm and (m, 3) indices, counter-clockwise from outside.")
      .def_property_readonly(
          "vertices",
          [](py::object self) {
            auto& mesh = self.cast<TriangleMesh&>();
            return view(mesh.vertices.empty() ? nullptr : mesh.vertices[0].data(),
                        {static_cast<py::ssize_t>(mesh.vertices.size()), 3}, self);
          },
          "(n, 3) float32, mm")
      .def_property_readonly(
          "triangles",
          [](py::object self) {
            auto& mesh = self.cast<TriangleMesh&>();
            return view(mesh.triangles.empty() ? nullptr : mesh.triangles[0].data(),
                        {static_cast<py::ssize_t>(mesh.triangles.size()), 3}, self);
          },
          "(m, 3) uint32, counter-clockwise from outside")
      .def_property_readonly("volume", &TriangleMesh::volume)
      .def_property_readonly("area", &TriangleMesh::area)
      .def(
          "save",
          [](const TriangleMesh& mesh, const std::filesystem::path& path, const std::optional<py::iterable>& parts) {
            Model model;
            for (const PythonPart& part : parts ? parts_given(*parts) : std::vector<PythonPart>()) {
              model.parts.push_back(*solid_of(part.what));
              model.parts.back().colour = part.colour;
            }
            const py::gil_scoped_release release;
            if (model.parts.empty()) return write_mesh(mesh, path);
            if (path.extension() != ".ply")
              throw Error(ErrorKind::bad_input, path.string(), "only .ply files have colours of vertices");
            write_ply(mesh, path, {vertex_colours(mesh, model)});
          },
          py::arg("filename"), py::arg("parts") = py::none(),
          "Writes .stl .ply .off .obj .3mf or .glb. `parts`: of a .ply file, (solid, name, colour) each; a vertex has "
          "the colour "
          "of the part whose surface it is on.")
      .def_static("load", &read_mesh, py::arg("filename"))
      .def(
          "bms",
          [](const TriangleMesh& mesh) {
            std::string bytes;
            {
              py::gil_scoped_release release;
              bytes = to_bms(mesh);
            }
            return py::bytes(bytes);
          },
          "The bytes of FreeCAD's own mesh file.")
      .def(
          "solid",
          [](const TriangleMesh& mesh, const py::object& progress, bool close_holes) {
            FieldPtr field = long_work(progress, [&](Progress& p) {
              const Lids lids = close_holes ? lids_of(mesh) : Lids();
              return mesh_field(lids.are_good(mesh) ? closed_by(lids, mesh) : mesh, p);
            });
            return SolidValue(fieldfab::solid_of(std::move(field), "mesh"));
          },
          py::arg("progress") = py::none(), py::arg("close_holes") = false,
          "The solid that it bounds: distances; inside is where it winds around. With close_holes small holes get "
          "lids, "
          "which are surface like all of it: as load() reads mesh files.");
  py::class_<Certainty>(module, "Certainty", "Whether a mesh is proved to show all of its solid, and where not.")
      .def_property_readonly("certain", &Certainty::certain)
      .def_readonly("count", &Certainty::count, "places where something may be missing")
      .def_readonly("largest", &Certainty::largest, "mm: longest side of the largest place")
      .def_readonly("thickness", &Certainty::thickness, "mm: what may be missing is thinner than this somewhere")
      .def_readonly("finest", &Certainty::finest, "mm: edge of the smallest cells that were looked at")
      .def_property_readonly(
          "places",
          [](const Certainty& certainty) {
            py::list places;
            for (const UncertainPlace& place : certainty.places) places.append(bounds_to_python(place.box));
            return places;
          },
          "bounds of the places, mm, the largest first; at most 1000")
      .def("__str__", &Certainty::text);
  py::class_<ContourMesh, TriangleMesh>(module, "ContourMesh", "The mesh of a solid, and how certain it is.")
      .def_readonly("certainty", &ContourMesh::certainty);
  module.def(
      "save_parts",
      [](const py::iterable& parts, const std::filesystem::path& path, const py::object& progress) {
        std::vector<MeshPart> meshes;
        for (const PythonPart& part : parts_given(parts))
          meshes.push_back({part.what.cast<const TriangleMesh&>(), part.name, part.colour});
        long_work(progress, [&](Progress& p) { return write_mesh_parts(meshes, path, p), 0; });
      },
      py::arg("parts"), py::arg("filename"), py::arg("progress") = py::none(),
      "Writes meshes to one file: (mesh, name, colour) each; None for no name and no colour. .3mf, .glb and .obj keep "
      "all three, "
      ".ply the colours, .stl and .off the triangles.");
  module.def(
      "mesh",
      [](const py::object& solid, const py::object& bounds, std::optional<double> voxel,
         std::optional<double> resolution, std::optional<double> max_error, bool features, const py::object& progress,
         bool exact, int depth) {
        const auto wanted = solid_of(solid);
        const bool whole = bounds.is_none();
        return long_work(progress, [&](Progress& p) {
          if (auto faces = exact && whole && wanted->faces != nullptr ? wanted->faces(std::nullopt, p) : std::nullopt) {
            // checked although it has no effect here
            if (!(cell_of(faces->bounds(), voxel, resolution, *wanted) > 0))
              throw Error(ErrorKind::bad_input, "voxel", "must be a positive number of mm");
            return ContourMesh{*std::move(faces), {}};
          }
          const Box region = region_of(*wanted, bounds, p);
          return contour(*wanted->field, region,
                         {cell_of(region, voxel, resolution, *wanted), max_error.value_or(-1), features, depth}, p);
        });
      },
      py::arg("solid"), py::arg("bounds") = py::none(), py::arg("voxel") = py::none(),
      py::arg("resolution") = py::none(), py::arg("max_error") = py::none(), py::arg("features") = true,
      py::arg("progress") = py::none(), py::arg("exact") = true, py::arg("depth") = ContourSettings().depth,
      "A watertight mesh of a solid: closed, manifold, without self-intersections, sharp edges kept. An OpenSCAD "
      "design has its "
      "own faces (see Solid.faces), whatever the cells, unless bounds are given or exact is False. Its certainty says "
      "whether "
      "anything may be missing; cells are halved up to depth times to see that, and with 0 it is not looked for.");

  module.def(
      "certainty",
      [](const py::object& solid, const py::object& bounds, std::optional<double> voxel,
         std::optional<double> resolution, const py::object& progress) {
        const auto wanted = solid_of(solid);
        return long_work(progress, [&](Progress& p) {
          const Box region = region_of(*wanted, bounds, p);
          return certainty_of_cells(*wanted->field, region, cell_of(region, voxel, resolution, *wanted), p);
        });
      },
      py::arg("solid"), py::arg("bounds") = py::none(), py::arg("voxel") = py::none(),
      py::arg("resolution") = py::none(), py::arg("progress") = py::none(),
      "Whether cells of this size show all of a solid, as those of an Asdf that is built of it; a mesh has its own "
      "certainty.");

  const auto pair = [](const Enclosed& number) { return std::pair(number.lower, number.upper); };
  py::class_<Measures>(module, "Measures", "Volume and area of a solid, with bounds that hold.")
      .def_property_readonly(
          "volume", [pair](const Measures& m) { return pair(m.volume); }, "(least, most), mm3")
      .def_property_readonly(
          "area", [pair](const Measures& m) { return pair(m.area); },
          "(least, most), mm2; infinite where nothing bounds it")
      .def("__str__", &Measures::text);
  module.def(
      "measure",
      [](const py::object& solid, const py::object& bounds, std::size_t boxes, const py::object& progress) {
        const auto wanted = solid_of(solid);
        return long_work(progress, [&](Progress& p) {
          const Box region = region_of(*wanted, bounds, p);
          MeasureSettings settings;
          settings.most_boxes = boxes;
          return measure(*wanted->field, bounds.is_none() ? region.grown(1e-3 * region.diagonal()) : region, settings,
                         p);
        });
      },
      py::arg("solid"), py::arg("bounds") = py::none(), py::arg("boxes") = MeasureSettings().most_boxes,
      py::arg("progress") = py::none(),
      "Volume and area of a solid, or of its part in the bounds, from the Field itself: as exactly as so many boxes "
      "can tell.");

  py::class_<DetailMesh>(
      module, "DetailMesh",
      "A solid in parts that are meshed when someone looks at them, finely where the eye is near; for display.")
      .def(py::init([](const py::object& solid, const py::object& bounds, int cells, int deepest, double angle,
                       std::size_t most) {
             const auto wanted = solid_of(solid);
             const Box region = long_work(py::none(), [&](Progress& p) { return region_of(*wanted, bounds, p); });
             return std::make_unique<DetailMesh>(wanted->field, region, DetailSettings{cells, deepest, angle, most});
           }),
           py::arg("solid"), py::arg("bounds") = py::none(), py::arg("cells") = DetailSettings{}.cells,
           py::arg("deepest") = DetailSettings{}.deepest, py::arg("angle") = DetailSettings{}.angle,
           py::arg("most_triangles") = DetailSettings{}.most_triangles)
      .def(
          "refine",
          [](DetailMesh& mesh, std::array<double, 3> eye, const py::object& progress) {
            return long_work(progress, [&](Progress& p) { return mesh.refine({eye[0], eye[1], eye[2]}, p); });
          },
          py::arg("eye"), py::arg("progress") = py::none(),
          "Meshes a few of the parts that are missed most; False once all is fine.")
      .def(
          "parts",
          [](const DetailMesh& mesh, std::array<double, 3> eye) {
            py::list all;
            for (const DetailMesh::Part& part : mesh.parts({eye[0], eye[1], eye[2]}))
              all.append(py::make_tuple(bounds_to_python(part.box), part.level, *part.mesh));
            return all;
          },
          py::arg("eye"), "What to draw: a list of (bounds, level, mesh).");

  py::class_<Image>(module, "Image", "Pixels; rows from the top (Keeter, Appendix C.2).")
      .def_property_readonly(
          "pixels",
          [](py::object self) {
            auto& image = self.cast<Image&>();
            std::vector<py::ssize_t> shape{image.height, image.width};
            if (image.channels > 1) shape.push_back(image.channels);
            return image.depth == 16 ? py::object(view(image.pixels16.data(), shape, self))
                                     : py::object(view(image.pixels8.data(), shape, self));
          },
          "(height, width) or (height, width, 3); uint8 or, where depth is 16, uint16")
      .def_readonly("width", &Image::width)
      .def_readonly("height", &Image::height)
      .def_readonly("channels", &Image::channels)
      .def_readonly("depth", &Image::depth)
      .def_readonly("pixels_per_mm", &Image::pixels_per_mm)
      .def_property_readonly("zmin", [](const Image& i) { return i.bounds.lower.z(); })
      .def_property_readonly("zmax", [](const Image& i) { return i.bounds.upper.z(); })
      .def(
          "save", [](const Image& image, const std::filesystem::path& path) { write_png(image, path); },
          py::arg("filename"), py::call_guard<py::gil_scoped_release>(), "Writes a .png file.")
      .def_static("load", &read_png, py::arg("filename"));
  module.def(
      "render",
      [](const py::object& solid, const std::string& mode, int size, double alpha, double beta,
         const py::object& bounds, const py::object& progress, double perspective, int samples,
         std::optional<std::array<double, 4>> window, const py::iterable& parts) {
        const auto wanted = solid_of(solid);
        std::vector<ColouredPart> coloured;
        for (const PythonPart& part : parts_given(parts)) coloured.push_back({solid_of(part.what)->field, part.colour});
        const RenderSettings settings{
            render_mode(mode),
            size,
            alpha,
            beta,
            perspective,
            samples,
            window ? std::optional(Box{{(*window)[0], (*window)[1], 0}, {(*window)[2], (*window)[3], 0}})
                   : std::nullopt};
        return long_work(progress, [&](Progress& p) {
          if (settings.mode != RenderMode::bitmap)
            return render(*wanted->field, region_of(*wanted, bounds, p), settings, p, coloured);
          std::optional<Box> plane;
          {
            py::gil_scoped_acquire acquire;
            plane = bounds_of(bounds);
          }
          return render(*wanted->field, plane ? *plane : region_of(*wanted, bounds, p), settings, p);
        });
      },
      py::arg("solid"), py::arg("mode") = "shaded", py::arg("size") = 512, py::arg("alpha") = 0.0,
      py::arg("beta") = 0.0, py::arg("bounds") = py::none(), py::arg("progress") = py::none(),
      py::arg("perspective") = 0.0, py::arg("samples") = 1, py::arg("window") = py::none(),
      py::arg("parts") = py::tuple(),
      "A picture: bitmap, height, normals or shaded; alpha turns about z, beta then about x, in radians. `perspective` "
      "is the "
      "angle "
      "that the solid fills in the eye, 0 for a view from infinitely far; `samples` a pixel and axis smooth edges. "
      "`window` (x0, "
      "y0, x1, y1) is the part of the picture's plane to show, in mm after the "
      "turn. `parts`, (solid, name, colour) each, of which `solid` is the union, give a shaded picture their colours.");

  py::class_<CheckRow>(module, "CheckRow")
      .def_readonly("name", &CheckRow::name)
      .def_readonly("measured", &CheckRow::measured)
      .def_readonly("bound", &CheckRow::bound)
      .def_readonly("unit", &CheckRow::unit)
      .def_property_readonly("passed", &CheckRow::passed);
  py::class_<CheckReport>(module, "CheckReport")
      .def_readonly("rows", &CheckReport::rows)
      .def_readonly("certainty", &CheckReport::certainty, "of the mesh that was checked")
      .def_readonly("measures", &CheckReport::measures, "of the solid, from its Field")
      .def_property_readonly("passed", &CheckReport::passed)
      .def("__str__", [](const CheckReport& report) {
        std::string text;
        for (const CheckRow& row : report.rows)
          text += fmt::format("{:<58} {:>12.5g} <= {:>12.5g} {:<3} {}\n", row.name, row.measured, row.bound, row.unit,
                              row.passed() ? "pass" : "FAIL");
        return text;
      });
  module.def(
      "check",
      [](const py::object& solid, const py::object& bounds, std::optional<double> voxel,
         std::optional<double> resolution, std::optional<double> max_error, const py::object& progress) {
        const auto wanted = solid_of(solid);
        return long_work(progress, [&](Progress& p) {
          const Box region = region_of(*wanted, bounds, p);
          return check(*wanted->field, region, {cell_of(region, voxel, resolution, *wanted), max_error.value_or(-1)},
                       p);
        });
      },
      py::arg("solid"), py::arg("bounds") = py::none(), py::arg("voxel") = py::none(),
      py::arg("resolution") = py::none(), py::arg("max_error") = py::none(), py::arg("progress") = py::none(),
      "Cross-checks a solid's distance field and mesh against OpenVDB and CGAL.");
  module.def(
      "write_vdb",
      [](const py::object& solid, const std::filesystem::path& path, const py::object& bounds,
         std::optional<double> voxel, std::optional<double> resolution, const py::object& progress) {
        const auto wanted = solid_of(solid);
        long_work(progress, [&](Progress& p) {
          const Box region = region_of(*wanted, bounds, p);
          write_vdb(*wanted->field, region, cell_of(region, voxel, resolution, *wanted), path, p);
          return 0;
        });
      },
      py::arg("solid"), py::arg("filename"), py::arg("bounds") = py::none(), py::arg("voxel") = py::none(),
      py::arg("resolution") = py::none(), py::arg("progress") = py::none(),
      "Writes a solid's level set for OpenVDB: distances within four voxels of its surface.");
  py::class_<MeshVerdict>(module, "MeshVerdict")
      .def_readonly("manifold", &MeshVerdict::manifold)
      .def_readonly("closed", &MeshVerdict::closed)
      .def_readonly("outward", &MeshVerdict::outward)
      .def_readonly("self_intersections", &MeshVerdict::self_intersections)
      .def_readonly("degenerate", &MeshVerdict::degenerate)
      .def_readonly("components", &MeshVerdict::components)
      .def_readonly("volume", &MeshVerdict::volume)
      .def_property_readonly("valid", &MeshVerdict::valid);
  module.def("inspect", &inspect, py::arg("mesh"), py::call_guard<py::gil_scoped_release>(),
             "What CGAL says of a mesh.");
}

}  // namespace fieldfab::python
