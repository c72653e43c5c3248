// build, mesh and check: results computed from a solid.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "fieldfab/asdf/asdf.h"
#include "fieldfab/check/check.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/text.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/mesh/mesh_parts.h"
#include "fieldfab/mesh/ply.h"
#include "fieldfab/solid/scan_solid.h"
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

/// Computes the surfaces of all parts. The outcome describes them together, and each if there are
/// several.
std::vector<MeshPart> surfaces_of(const Model& model, const ModelOptions& options, Outcome& outcome,
                                  Progress& progress) {
  const Resolution wanted = options.wanted();
  std::vector<MeshPart> parts;
  std::size_t triangles = 0, vertices = 0;
  double volume = 0, area = 0;
  bool exact = true;
  Certainty certainty;
  Box bounds;
  double voxel = 0;
  auto described = nlohmann::ordered_json::array();
  for (const Solid& solid : model.parts) {
    Surface made = surface(solid, wanted, progress, model.parts.size() > 1 ? EmptySolid::allowed : EmptySolid::refused);
    const TriangleMesh& mesh = made.mesh;
    const std::string place = place_of(solid, model, options.model);
    if (mesh.triangles.empty() && !wanted.region) {
      const std::string found = made.mesh.certainty.certain() ? "the solid is empty" : "no surface was found";
      const std::string more = made.mesh.certainty.certain() ? "" : "; " + made.mesh.certainty.text();
      if (model.parts.size() == 1) throw Error(ErrorKind::bad_input, place, found + ", and no mesh was written" + more);
      print_notes({place + ": " + found + more});
      continue;
    }
    const double enclosed = mesh.volume(), covered = mesh.area();
    described.push_back({{"name", solid.name},
                         {"colour", solid.colour ? nlohmann::ordered_json(text_of(*solid.colour)) : nullptr},
                         {"triangles", mesh.triangles.size()},
                         {"volume", enclosed},
                         {"area", covered},
                         {"bounds", json_of(mesh.bounds())},
                         {"certain", made.mesh.certainty.certain()}});
    triangles += mesh.triangles.size(), vertices += mesh.vertices.size();
    volume += enclosed, area += covered;
    exact = exact && made.exact;
    bounds = parts.empty() ? made.region : hull(bounds, made.region);
    voxel = parts.empty() ? made.voxel : std::min(voxel, made.voxel);
    certainty.add(made.mesh.certainty);
    parts.push_back({std::move(made.mesh), solid.name, solid.colour});
  }
  if (parts.empty()) throw Error(ErrorKind::bad_input, options.model, "all parts are empty, and no mesh was written");
  outcome.line = fmt::format("{} triangles, {} vertices, volume {:.6g} mm3, {}", triangles, vertices, volume,
                             exact ? "exact faces" : certainty.text());
  outcome.json = {{"output", options.output},
                  {"triangles", triangles},
                  {"vertices", vertices},
                  {"volume", volume},
                  {"area", area},
                  {"voxel", voxel},
                  {"exact", exact},
                  {"bounds", json_of(bounds)}};
  if (model.parts.size() > 1) outcome.json["parts"] = described;
  tell_certainty(certainty, outcome);
  return parts;
}

class BuildVerb final : public Verb {
 public:
  void declare(CLI::App& app) override {
    verb_ = app.add_subcommand("build", "build an adaptively sampled distance field (ASDF) of a solid");
    options_.declare(*verb_, "the .asdf file to write");
    verb_->add_option("--levels", file_.levels, "resolutions to keep in the file, each half of the one before")
        ->check(CLI::Range(1, 32));
    verb_->add_option("--quantum", file_.quantum,
                      "store distances as multiples of this many mm; the default is 1/1024 of a voxel");
    verb_->add_flag("--certain", certain_, "exit 1 unless the distance field is proved to represent the whole solid");
  }
  Outcome run(Progress& progress) override {
    if (options_.takes_samples()) return import(progress);
    const Stopwatch clock;
    const Solid solid = options_.open_solid(progress);
    const Box bounds = working_bounds(solid, options_.region(), progress);
    const auto [voxel, certainty] = options_.lattice_cells(bounds, solid, progress);
    const auto asdf = Asdf::build(*solid.field, bounds, {voxel, options_.max_error.value_or(-1), true}, progress);
    asdf->save(options_.output, file_, progress);
    const AsdfStatistics counts = asdf->statistics();
    const auto& n = asdf->lattice();
    Outcome outcome;
    outcome.line = fmt::format("{}: {} x {} x {} lattice, {} cells ({} leafs), {:.1f} bytes a cell, {}, {:.2f} s",
                               options_.output, n[0], n[1], n[2], counts.cells(), counts.leafs,
                               static_cast<double>(counts.bytes) / static_cast<double>(counts.cells()),
                               certainty.text(), clock.seconds());
    outcome.json = {{"output", options_.output}, {"lattice", n},
                    {"bounds", json_of(bounds)}, {"cells", counts.cells()},
                    {"leafs", counts.leafs},     {"filled", counts.filled},
                    {"empty", counts.empty},     {"branches", counts.branches},
                    {"bytes", counts.bytes},     {"seconds", clock.seconds()}};
    tell_certainty(certainty, outcome);
    if (certain_ && !certainty.certain()) outcome.code = 1;
    return outcome;
  }

 private:
  /// Imports a volume sample by sample, whatever its size.
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
            "{}: {} x {} x {} samples of {:.4g} x {:.4g} x {:.4g} mm, threshold {:.6g}, {} cells ({} leafs), {:.2f} "
            "MB, {}, {:.2f} s",
            options_.output, lattice.size[0], lattice.size[1], lattice.size[2], lattice.spacing.x(),
            lattice.spacing.y(), lattice.spacing.z(), scan.surface.threshold, counts.cells, counts.leafs,
            static_cast<double>(bytes) / 1e6, Certainty{}.text(), clock.seconds()),
        {{"output", options_.output},
         {"samples", lattice.size},
         {"spacing", {lattice.spacing.x(), lattice.spacing.y(), lattice.spacing.z()}},
         {"threshold", scan.surface.threshold},
         {"cells", counts.cells},
         {"leafs", counts.leafs},
         {"blocks", counts.blocks},
         {"bytes", bytes},
         {"certain", true},  // cells lie between neighbouring samples
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
    options_.declare(*verb_, "the mesh to write: " + openscad::all_formats().writable({FormatKind::mesh}));
    verb_->add_flag("--certain", certain_, "exit 1 unless the mesh is proved to represent the whole solid");
  }
  Outcome run(Progress& progress) override {
    const Formats& formats = openscad::all_formats();
    if (formats.written(options_.output) != FormatKind::mesh)
      throw Error(ErrorKind::bad_input, options_.output,
                  fmt::format("cannot write a mesh as '{}'; known are {}", extension_of(options_.output),
                              formats.writable({FormatKind::mesh})));
    Outcome outcome = write_surface(options_, progress);
    if (certain_ && !outcome.json["certain"]) outcome.code = 1;
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
        "check",
        "cross-check a solid's distance field and mesh against OpenVDB and CGAL; exit 1 if any bound is broken");
    options_.declare(*verb_, "");
    verb_->add_option("--seed", seed_, "seed of the random points");
  }
  Outcome run(Progress& progress) override {
    const Stopwatch clock;
    Model model = options_.open(progress);
    Outcome outcome;
    bool passed = true;
    auto described = nlohmann::ordered_json::array();
    for (Solid& solid : model.parts) {
      const Outcome of_part = check_solid(solid, progress);
      passed = passed && of_part.code == 0;
      if (model.parts.size() > 1) outcome.line += fmt::format("part '{}'\n", printable(solid.name));
      outcome.line += of_part.line;
      described.push_back(of_part.json);
      described.back()["name"] = solid.name;
    }
    if (model.parts.size() == 1) {
      outcome.json = {{"model", options_.model}};
      described.front().erase("name");
      outcome.json.update(described.front());
    } else {
      outcome.json = {{"model", options_.model}, {"passed", passed}, {"parts", described}};
      tell_overlaps(model, outcome, progress);
    }
    outcome.json["seconds"] = clock.seconds();
    outcome.line += fmt::format("{}: {} in {:.2f} s", options_.model, passed ? "all bounds hold" : "A BOUND IS BROKEN",
                                clock.seconds());
    outcome.code = passed ? 0 : 1;
    return outcome;
  }

 private:
  Outcome check_solid(Solid& solid, Progress& progress) {
    const std::optional<double> plate = options_.make_plate_if_flat(solid, progress);
    const Box bounds = working_bounds(solid, options_.region(), progress, EmptySolid::allowed);
    const double cell = options_.cell(bounds, solid);
    const CheckReport report = check(*solid.field, bounds, {cell, options_.max_error.value_or(-1), seed_}, progress);
    Outcome outcome;
    outcome.json = {{"passed", report.passed()}, {"voxel", cell}, {"bounds", json_of(bounds)}};
    if (plate) {
      outcome.json["plate"] = *plate;
      outcome.line += fmt::format("flat: checked as a plate {:.4g} mm thick, in cells of {:.4g} mm\n", *plate, cell);
    }
    auto rows = nlohmann::ordered_json::array();
    for (const CheckRow& row : report.rows) {
      outcome.line += fmt::format("{:<58} {:>12.5g} {:>3} {:>12.5g} {:<3} {}\n", row.name, row.measured,
                                  "<=", row.bound, row.unit, row.passed() ? "pass" : "FAIL");
      rows.push_back({{"name", row.name},
                      {"measured", row.measured},
                      {"bound", row.bound},
                      {"unit", row.unit},
                      {"passed", row.passed()}});
    }
    outcome.json["rows"] = rows;
    tell_certainty(report.certainty, outcome);
    outcome.line += fmt::format("the mesh is {}\n", report.certainty.text());
    outcome.json["measures"] = json_of(report.measures);
    outcome.line += fmt::format("the solid has {}\n", report.measures.text());
    outcome.code = report.passed() ? 0 : 1;
    return outcome;
  }

  /// Reports the parts that overlap, with a proved lower bound of the common volume.
  void tell_overlaps(const Model& model, Outcome& outcome, Progress& progress) const {
    auto overlaps = nlohmann::ordered_json::array();
    std::vector<Box> bounds;
    for (const Solid& solid : model.parts)
      bounds.push_back(working_bounds(solid, options_.region(), progress, EmptySolid::allowed));
    for (std::size_t i = 0; i < model.parts.size(); ++i)
      for (std::size_t j = i + 1; j < model.parts.size(); ++j) {
        const Box common{bounds[i].lower.cwiseMax(bounds[j].lower), bounds[i].upper.cwiseMin(bounds[j].upper)};
        if (!(common.size().minCoeff() > 0)) continue;
        const Measures shared = measure(*intersect(model.parts[i].field, model.parts[j].field), common, {}, progress);
        if (!(shared.volume.lower > 0)) continue;
        const std::string &a = model.parts[i].name, &b = model.parts[j].name;
        outcome.line += fmt::format("parts '{}' and '{}' overlap by at least {:.4g} mm3\n", printable(a), printable(b),
                                    shared.volume.lower);
        overlaps.push_back({{"parts", {a, b}}, {"volume", {shared.volume.lower, shared.volume.upper}}});
      }
    outcome.json["overlaps"] = overlaps;
  }

  ModelOptions options_;
  std::uint32_t seed_ = 1;
};

}  // namespace

Outcome write_surface(const ModelOptions& options, Progress& progress) {
  const Stopwatch clock;
  const Model model = options.open(progress);
  // Other formats get one mesh of all parts, so that it is valid if parts touch or overlap.
  const bool one = model.parts.size() > 1 && !openscad::all_formats().find(options.output)->parts;
  Outcome outcome;
  const std::vector<MeshPart> parts =
      surfaces_of(one ? Model{{options.as_one(model, progress)}} : model, options, outcome, progress);
  if (one && extension_of(options.output) == ".ply")
    write_ply(parts.front().mesh, options.output, {vertex_colours(parts.front().mesh, model)}, progress);
  else
    write_mesh_parts(parts, options.output, progress);
  outcome.line =
      fmt::format("{}: {}{}, {:.2f} s", options.output, parts.size() > 1 ? fmt::format("{} parts, ", parts.size()) : "",
                  outcome.line, clock.seconds());
  outcome.json["seconds"] = clock.seconds();
  return outcome;
}

std::unique_ptr<Verb> build_verb() { return std::make_unique<BuildVerb>(); }
std::unique_ptr<Verb> mesh_verb() { return std::make_unique<MeshVerb>(); }
std::unique_ptr<Verb> check_verb() { return std::make_unique<CheckVerb>(); }

}  // namespace fieldfab::cli
