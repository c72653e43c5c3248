// build, mesh and check: what is made of a solid.
#include <fmt/format.h>

#include <chrono>

#include "fieldfab/asdf/asdf.h"
#include "fieldfab/check/check.h"
#include "fieldfab/core/error.h"
#include "fieldfab/mesh/contour.h"
#include "json.h"
#include "verbs.h"

namespace fieldfab::cli {
namespace {

class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Adds to the answer whether it shows all of the solid; `wanted`: it has to.
void tell_certainty(const Certainty& certainty, bool wanted, Outcome& outcome) {
  outcome.json["certain"] = certainty.certain();
  if (!certainty.certain()) outcome.json["uncertain"] = json_of(certainty);
  if (wanted && !certainty.certain()) outcome.code = 1;
}

class BuildVerb final : public Verb {
 public:
  void declare(CLI::App& app) override {
    verb_ = app.add_subcommand("build", "build the distance field (ASDF) of a solid");
    options_.declare(*verb_, "the .asdf file to write");
    verb_->add_option("--levels", file_.levels, "resolutions to keep in the file, each half of the one before")
        ->check(CLI::Range(1, 32));
    verb_->add_option("--quantum", file_.quantum,
                      "keep distances as multiples of this many mm; the default is 1/1024 of a voxel");
    verb_->add_flag("--certain", certain_, "exit 1 unless the distance field is proved to show all of the solid");
  }
  Outcome run(Progress& progress) override {
    if (options_.takes_samples()) return import(progress);
    const Stopwatch clock;
    const Model model = options_.load(progress);
    const Box bounds = working_bounds(model, options_.region(), progress);
    const auto asdf =
        Asdf::build(*model.field, bounds, {options_.cell(bounds, model), options_.max_error.value_or(-1), true}, progress);
    const Certainty certainty = certainty_of_cells(*model.field, bounds, asdf->voxel(), progress);
    asdf->save(options_.output, file_, progress);
    const AsdfStatistics counts = asdf->statistics();
    const auto& n = asdf->lattice();
    Outcome outcome;
    outcome.line =
        fmt::format("{}: {} x {} x {} lattice, {} cells ({} leafs), {:.1f} bytes a cell, {}, {:.2f} s", options_.output, n[0],
                    n[1], n[2], counts.cells(), counts.leafs,
                    static_cast<double>(counts.bytes) / static_cast<double>(counts.cells()), certainty.text(), clock.seconds());
    outcome.json = {{"output", options_.output}, {"lattice", n},
                    {"bounds", json_of(bounds)}, {"cells", counts.cells()},
                    {"leafs", counts.leafs},     {"filled", counts.filled},
                    {"empty", counts.empty},     {"branches", counts.branches},
                    {"bytes", counts.bytes},     {"seconds", clock.seconds()}};
    tell_certainty(certainty, certain_, outcome);
    return outcome;
  }

 private:
  /// A volume goes into the file sample by sample, whatever its size.
  Outcome import(Progress& progress) const {
    const Stopwatch clock;
    const ScanOptions wanted = options_.scan.parsed();
    const Scan scan = open_scan(options_.model, wanted, progress);
    const ImportCounts counts =
        import_scan(scan, options_.output, {options_.max_error.value_or(-1), file_, wanted.memory}, progress);
    const SampleLattice& lattice = scan.volume->lattice();
    const auto bytes = std::filesystem::file_size(options_.output);
    return {
        fmt::format(
            "{}: {} x {} x {} samples of {:.4g} x {:.4g} x {:.4g} mm, threshold {:.6g}, {} cells ({} leafs), {:.2f} MB, {:.2f} s",
            options_.output, lattice.size[0], lattice.size[1], lattice.size[2], lattice.spacing.x(), lattice.spacing.y(),
            lattice.spacing.z(), scan.surface.threshold, counts.cells, counts.leafs, static_cast<double>(bytes) / 1e6,
            clock.seconds()),
        {{"output", options_.output},
         {"samples", lattice.size},
         {"spacing", {lattice.spacing.x(), lattice.spacing.y(), lattice.spacing.z()}},
         {"threshold", scan.surface.threshold},
         {"cells", counts.cells},
         {"leafs", counts.leafs},
         {"blocks", counts.blocks},
         {"bytes", bytes},
         {"seconds", clock.seconds()}},
        0};
  }

  ModelOptions options_;
  AsdfFileSettings file_;
  bool certain_ = false;
};

class MeshVerb final : public Verb {
 public:
  void declare(CLI::App& app) override {
    verb_ = app.add_subcommand("mesh", "make a watertight triangle mesh of a solid");
    options_.declare(*verb_, "the mesh to write: .stl .ply .off .obj .3mf .glb");
    verb_->add_flag("--certain", certain_, "exit 1 unless the mesh is proved to show all of the solid");
  }
  Outcome run(Progress& progress) override {
    if (const std::string extension = extension_of(options_.output); !is_mesh_extension(extension))
      throw Error(ErrorKind::bad_input, options_.output,
                  fmt::format("cannot write a mesh as '{}'; known are .stl .ply .off .obj .3mf .glb", extension));
    const Stopwatch clock;
    const Model model = options_.load(progress);
    std::optional<TriangleMesh> faces;
    if (model.faces && !options_.region()) faces = model.faces(options_.thickness, progress);
    const Box bounds = faces ? faces->bounds() : working_bounds(model, options_.region(), progress);
    const double cell = options_.cell(bounds, model);
    ContourMesh mesh;
    if (faces)
      static_cast<TriangleMesh&>(mesh) = std::move(*faces);
    else
      mesh = contour(*model.field, bounds, {cell, options_.max_error.value_or(-1), true}, progress);
    const Certainty& certainty = mesh.certainty;
    if (mesh.triangles.empty() && !options_.region())
      throw Error(ErrorKind::bad_input, options_.model,
                  certainty.certain() ? "the solid is empty, and no mesh was written"
                                      : "no surface was found, and no mesh was written; " + certainty.text());
    write_mesh(mesh, options_.output, progress);
    Outcome outcome;
    outcome.line =
        fmt::format("{}: {} triangles, {} vertices, volume {:.6g} mm3, {}, {:.2f} s", options_.output, mesh.triangles.size(),
                    mesh.vertices.size(), mesh.volume(), faces ? "exact faces" : certainty.text(), clock.seconds());
    outcome.json = {{"output", options_.output},
                    {"triangles", mesh.triangles.size()},
                    {"vertices", mesh.vertices.size()},
                    {"volume", mesh.volume()},
                    {"area", mesh.area()},
                    {"voxel", cell},
                    {"exact", faces.has_value()},
                    {"bounds", json_of(bounds)},
                    {"seconds", clock.seconds()}};
    tell_certainty(certainty, certain_, outcome);
    return outcome;
  }

 private:
  ModelOptions options_;
  bool certain_ = false;
};

class CheckVerb final : public Verb {
 public:
  void declare(CLI::App& app) override {
    verb_ = app.add_subcommand(
        "check", "cross-check a solid's distance field and mesh against OpenVDB and CGAL; exit 1 if any bound is broken");
    options_.declare(*verb_, "");
    verb_->add_option("--seed", seed_, "seed of the random points");
  }
  Outcome run(Progress& progress) override {
    const Stopwatch clock;
    Model model = options_.load(progress);
    const std::optional<double> plate = options_.make_plate_if_flat(model, progress);
    const Box bounds = working_bounds(model, options_.region(), progress, EmptySolid::allowed);
    const double cell = options_.cell(bounds, model);
    const CheckReport report = check(*model.field, bounds, {cell, options_.max_error.value_or(-1), seed_}, progress);
    Outcome outcome;
    outcome.json = {{"model", options_.model}, {"passed", report.passed()}, {"voxel", cell}, {"bounds", json_of(bounds)}};
    if (plate) {
      outcome.json["plate"] = *plate;
      outcome.line += fmt::format("flat: checked as a plate {:.4g} mm thick, in cells of {:.4g} mm\n", *plate, cell);
    }
    auto rows = nlohmann::ordered_json::array();
    for (const CheckRow& row : report.rows) {
      outcome.line += fmt::format("{:<58} {:>12.5g} {:>3} {:>12.5g} {:<3} {}\n", row.name, row.measured, "<=", row.bound,
                                  row.unit, row.passed() ? "pass" : "FAIL");
      rows.push_back(
          {{"name", row.name}, {"measured", row.measured}, {"bound", row.bound}, {"unit", row.unit}, {"passed", row.passed()}});
    }
    outcome.json["rows"] = rows;
    tell_certainty(report.certainty, false, outcome);
    outcome.line += fmt::format("the mesh is {}\n", report.certainty.text());
    outcome.json["measures"] = json_of(report.measures);
    outcome.line += fmt::format("the solid has {}\n", report.measures.text());
    outcome.json["seconds"] = clock.seconds();
    outcome.line += fmt::format("{}: {} in {:.2f} s", options_.model, report.passed() ? "all bounds hold" : "A BOUND IS BROKEN",
                                clock.seconds());
    outcome.code = report.passed() ? 0 : 1;
    return outcome;
  }

 private:
  ModelOptions options_;
  std::uint32_t seed_ = 1;
};

}  // namespace

std::unique_ptr<Verb> build_verb() { return std::make_unique<BuildVerb>(); }
std::unique_ptr<Verb> mesh_verb() { return std::make_unique<MeshVerb>(); }
std::unique_ptr<Verb> check_verb() { return std::make_unique<CheckVerb>(); }

}  // namespace fieldfab::cli
