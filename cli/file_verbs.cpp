// render, info and convert: images of solids, and recognition and conversion of files.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fieldfab/asdf/asdf.h"
#include "fieldfab/check/vdb.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/core/angle.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/text.h"
#include "fieldfab/field/bounds.h"
#include "fieldfab/frep/text.h"
#include "fieldfab/mesh/load_mesh.h"
#include "fieldfab/mesh/mesh_parts.h"
#include "fieldfab/openscad/design.h"
#include "fieldfab/render/chart.h"
#include "fieldfab/render/render.h"
#include "json.h"
#include "verbs.h"

namespace fieldfab::cli {
namespace {

class RenderVerb final : public Verb {
 public:
  void declare(CLI::App& app) override {
    verb_ = app.add_subcommand("render", "make a picture of a solid");
    options_.declare(*verb_, "the .png to write");
    verb_->add_option("--mode", mode_, "bitmap (the plane z = z0), height, normals or shaded");
    verb_->add_option("--size", size_, "pixels along the longer side")->check(CLI::Range(1, 16384));
    verb_->add_option("--alpha", alpha_, "turn about z in degrees");
    verb_->add_option("--beta", beta_, "then tilt about x in degrees");
    verb_
        ->add_option("--perspective", perspective_,
                     "angle of view that the solid fills, in degrees; 0 is a parallel projection")
        ->check(CLI::Range(0.0, 114.0));
    verb_
        ->add_option("--samples", samples_,
                     "smooth edges of shaded pictures by so many samples a pixel along each axis")
        ->check(CLI::Range(1, 4));
  }
  Outcome run(Progress& progress) override {
    if (extension_of(options_.output) != ".png")
      throw Error(ErrorKind::bad_input, options_.output, "pictures are written as .png");
    RenderSettings settings{render_mode(mode_),
                            size_,
                            alpha_ * radians_per_degree,
                            beta_ * radians_per_degree,
                            perspective_ * radians_per_degree,
                            samples_};
    const Model model = options_.open(progress);
    tell_empty_parts(model, options_.model, progress);
    const Solid solid = united(model);
    std::vector<ColouredPart> parts;
    for (const Solid& part : model.parts) parts.push_back({part.field, part.colour});
    const Box bounds = settings.mode == RenderMode::bitmap ? plane_bounds(solid, progress)
                                                           : working_bounds(solid, options_.region(), progress);
    const Image image = render(*solid.field, bounds, settings, progress, parts);
    write_png(image, options_.output);
    Outcome outcome;
    outcome.line = fmt::format("{}: {} x {} pixels, {}", options_.output, image.width, image.height, mode_);
    outcome.json = {{"output", options_.output},
                    {"width", image.width},
                    {"height", image.height},
                    {"mode", mode_},
                    {"pixels_per_mm", image.pixels_per_mm}};
    return outcome;
  }

 private:
  /// Bounds of a bitmap, which needs x and y only: it shows the plane z = z0, or z = 0 if the
  /// bounds are searched.
  Box plane_bounds(const Solid& solid, Progress& progress) const {
    if (const auto wanted = options_.region()) return *wanted;
    const SolidBounds found = solid_bounds(*solid.field, progress);
    if (found.empty) throw Error(ErrorKind::bad_input, "bounds", "the solid is empty");
    if (!found.bounded[0] || !found.bounded[1])
      throw Error(ErrorKind::bad_input, "bounds", "the solid is unbounded along x or y; give bounds x0,y0,z0,x1,y1,z1");
    Box box = found.box.grown(found.box.size().head<2>().maxCoeff() / 64);
    box.lower.z() = box.upper.z() = 0;
    return box;
  }

  ModelOptions options_;
  std::string mode_ = "shaded";
  int size_ = 512;
  double alpha_ = 0, beta_ = 0, perspective_ = 0;
  int samples_ = 1;
};

class InfoVerb final : public Verb {
 public:
  void declare(CLI::App& app) override {
    verb_ = app.add_subcommand("info", "describe the content of a file");
    verb_->add_option("FILE", file_, "a model, mesh, volume or .png")->required();
    verb_->add_option("--histogram", histogram_, "draw the histogram of a volume's densities: the .png to write");
    scan_.declare(*verb_);
  }
  Outcome run(Progress& progress) override {
    if (extension_of(file_) == ".png") return image_info();
    const Formats& formats = openscad::all_formats();
    if (formats.is_read_as(FormatKind::mesh, file_)) return mesh_info(progress);
    if (formats.is_read_as(FormatKind::distances, file_)) return asdf_info(*Asdf::load(file_));
    if (formats.is_read_as(FormatKind::volume, file_)) return volume_info(progress);
    OpenSettings settings;
    settings.scripts = Scripts::run;
    settings.formats = &formats;
    const Model model = open_model(file_, settings, progress);
    print_notes(model.notes);
    if (model.parts.size() > 1 || !model.parts.front().name.empty()) return parts_info(model, progress);
    const Solid& solid = model.parts.front();
    return solid.kind == "design" ? design_info(solid, model.notes, progress) : frep_info(solid, progress);
  }

 private:
  Outcome parts_info(const Model& model, Progress& progress) const {
    const std::size_t count = model.parts.size();
    Outcome outcome{
        fmt::format("{}: {} part{}", file_, count, count == 1 ? "" : "s"), {{"file", file_}, {"kind", "parts"}}, 0};
    auto parts = nlohmann::ordered_json::array();
    for (const Solid& solid : model.parts) {
      Outcome part;
      const SolidBounds found = exact_bounds(*solid.field, progress);
      const std::string bounds = tell_bounds(found, part);
      part.line =
          fmt::format("\n  {}: {}{}", printable(solid.name), solid.colour ? text_of(*solid.colour) + ", " : "", bounds);
      tell_measures(*solid.field, found, part, progress);
      part.json["name"] = solid.name;
      part.json["colour"] = solid.colour ? nlohmann::ordered_json(text_of(*solid.colour)) : nullptr;
      outcome.line += part.line;
      parts.push_back(std::move(part.json));
    }
    outcome.json["parts"] = std::move(parts);
    return outcome;
  }
  /// The bounds for people, who expect -20..20 of a box of 40 mm.
  static SolidBounds exact_bounds(const Field& field, Progress& progress) {
    SolidBounds found = solid_bounds(field, progress);
    if (!found.empty && found.is_bounded()) found.box = tight_bounds(field, found.box, progress);
    return found;
  }
  /// The bounds along an axis, to a millionth of the size: 0 instead of -1e-06.
  static std::string range_text(const SolidBounds& found, int axis) {
    const double size = found.is_bounded() ? found.box.size().maxCoeff() : found.box.size()[axis];
    const double unit = size > 0 ? std::pow(10, std::floor(std::log10(size)) - 5) : 1;
    const auto shown = [unit](double end) { return std::round(end / unit) * unit + 0.0; };
    return fmt::format("{} {:.4g}..{:.4g}", "xyz"[axis], shown(found.box.lower[axis]), shown(found.box.upper[axis]));
  }
  /// Returns the bounds as a text, and adds them to the JSON.
  static std::string tell_bounds(const SolidBounds& found, Outcome& outcome) {
    if (found.empty) {
      outcome.json["bounds"] = nullptr;
      return "empty";
    }
    std::string bounds;
    auto ranges = nlohmann::ordered_json::array();
    for (int axis = 0; axis < 3; ++axis) {
      const char name = "xyz"[axis];
      if (found.bounded[axis])
        ranges.push_back({found.box.lower[axis], found.box.upper[axis]});
      else
        ranges.push_back(nullptr);
      if (axis > 0) bounds += ' ';
      bounds += found.bounded[axis] ? range_text(found, axis) : fmt::format("{} unbounded", name);
    }
    outcome.json["bounds"] = ranges;
    return bounds;
  }
  Outcome frep_info(const Solid& solid, Progress& progress) const {
    const std::size_t nodes = frep::node_count(solid.expression),
                      simplified = frep::node_count(frep::simplify(solid.expression));
    const SolidBounds found = exact_bounds(*solid.field, progress);
    Outcome outcome;
    outcome.json = {{"file", file_}, {"kind", solid.kind}, {"nodes", nodes}, {"simplified", simplified}};
    const std::string bounds = tell_bounds(found, outcome);
    outcome.line = fmt::format("{}: f-rep, {} nodes ({} simplified), {}", file_, nodes, simplified, bounds);
    tell_measures(*solid.field, found, outcome, progress);
    return outcome;
  }
  /// Adds volume and area, if the solid is bounded and has a thickness.
  static void tell_measures(const Field& field, const SolidBounds& found, Outcome& outcome, Progress& progress) {
    if (found.empty || !found.is_bounded() || !(found.box.size().minCoeff() > 0)) return;
    // Grown, so that faces in the bounds lie inside the measured region.
    const Measures measures = measure(field, found.box.grown(1e-3 * found.box.diagonal()), {}, progress);
    outcome.line += ", " + measures.text();
    outcome.json.update(json_of(measures));
  }
  Outcome design_info(const Solid& solid, const std::vector<std::string>& notes, Progress& progress) const {
    const SolidBounds found = exact_bounds(*solid.field, progress);
    const Vec3 &a = found.box.lower, &b = found.box.upper;
    const bool flat = !found.bounded[2];
    const auto formula = std::dynamic_pointer_cast<const OpenedSolid>(solid.expression.source());
    Outcome outcome;
    outcome.json = {{"file", file_},
                    {"kind", solid.kind},
                    {"flat", flat},
                    {"formula", formula != nullptr && formula->formula.has_value()}};
    outcome.json["bounds"] = {{a.x(), b.x()}, {a.y(), b.y()}};
    outcome.json["bounds"].push_back(flat ? nlohmann::ordered_json() : nlohmann::ordered_json{a.z(), b.z()});
    outcome.json["notes"] = notes;
    outcome.line = fmt::format("{}: OpenSCAD design, {}, ", file_, flat ? "flat" : "solid");
    for (int axis = 0; axis < (flat ? 2 : 3); ++axis) outcome.line += (axis > 0 ? " " : "") + range_text(found, axis);
    tell_measures(*solid.field, found, outcome, progress);
    return outcome;
  }
  Outcome asdf_info(const Asdf& asdf) const {
    const AsdfStatistics counts = asdf.statistics();
    const AsdfFileInfo file = Asdf::look(file_);
    const auto& n = asdf.lattice();
    Outcome outcome{fmt::format("{}: ASDF, {} x {} x {} lattice, {} cells ({} leafs), {} bytes", file_, n[0], n[1],
                                n[2], counts.cells(), counts.leafs, counts.bytes),
                    {{"file", file_},
                     {"kind", "asdf"},
                     {"lattice", n},
                     {"cells", counts.cells()},
                     {"leafs", counts.leafs},
                     {"bytes", counts.bytes},
                     {"file_bytes", file.file_size},
                     {"depth", counts.depth},
                     {"max_error", asdf.max_error()},
                     {"quantum", file.quantum}},
                    0};
    if (file.levels.size() > 1) outcome.line += fmt::format(", {} levels", file.levels.size());
    for (const auto& level : file.levels)
      outcome.json["levels"].push_back(
          {{"lattice", level.lattice}, {"cells", level.cells}, {"blocks", level.blocks}, {"bytes", level.bytes}});
    return outcome;
  }
  Outcome volume_info(Progress& progress) const {
    const ScanOptions wanted = scan_.parsed();
    const VolumePtr volume = open_volume(file_, wanted.file, progress);
    const Histogram counts = histogram(*volume, wanted.memory, progress);
    const double otsu = otsu_threshold(counts), halfway = halfway_threshold(counts);
    if (!histogram_.empty())
      write_png(bar_chart(counts.counts,
                          (halfway - counts.first) / (counts.width * static_cast<double>(counts.counts.size()))),
                histogram_);
    const SampleLattice& lattice = volume->lattice();
    const auto vector = [](const Vec3& v) { return std::array{v.x(), v.y(), v.z()}; };
    return {
        fmt::format(
            "{}: volume, {} x {} x {} samples of {}, {:.4g} x {:.4g} x {:.4g} mm apart{}, densities {:.6g} to {:.6g}, "
            "thresholds: halfway {:.6g}, Otsu's {:.6g}",
            file_, lattice.size[0], lattice.size[1], lattice.size[2], name(volume->type()), lattice.spacing.x(),
            lattice.spacing.y(), lattice.spacing.z(), lattice.straight() ? "" : ", askew", counts.least,
            counts.greatest, halfway, otsu),
        {{"file", file_},
         {"kind", "volume"},
         {"samples", lattice.size},
         {"type", name(volume->type())},
         {"spacing", vector(lattice.spacing)},
         {"origin", vector(lattice.origin)},
         {"axes", {vector(lattice.axes.col(0)), vector(lattice.axes.col(1)), vector(lattice.axes.col(2))}},
         {"least", counts.least},
         {"greatest", counts.greatest},
         {"halfway", halfway},
         {"otsu", otsu}},
        0};
  }
  Outcome mesh_info(Progress& progress) const {
    std::vector<std::string> notes;
    const std::vector<MeshPart> parts = load_mesh_parts(file_, progress, notes);
    print_notes(notes);
    Outcome outcome{"", {{"file", file_}, {"kind", "mesh"}}, 0};
    std::size_t triangles = 0, vertices = 0;
    double volume = 0, area = 0;
    Box bounds = parts.front().mesh.bounds();
    auto list = nlohmann::ordered_json::array();
    std::string lines;
    for (const auto& [mesh, name, colour] : parts) {
      const Box box = mesh.bounds();
      triangles += mesh.triangles.size(), vertices += mesh.vertices.size(), volume += mesh.volume(),
          area += mesh.area();
      bounds = {bounds.lower.cwiseMin(box.lower), bounds.upper.cwiseMax(box.upper)};
      lines +=
          fmt::format("\n  {}: {}x {:.4g}..{:.4g} y {:.4g}..{:.4g} z {:.4g}..{:.4g}, {} triangles, volume {:.6g} mm3",
                      name, colour ? text_of(*colour) + ", " : "", box.lower.x(), box.upper.x(), box.lower.y(),
                      box.upper.y(), box.lower.z(), box.upper.z(), mesh.triangles.size(), mesh.volume());
      list.push_back({{"name", name}, {"colour", colour ? nlohmann::ordered_json(text_of(*colour)) : nullptr}});
      list.back().update(mesh_json(mesh.triangles.size(), mesh.vertices.size(), mesh.volume(), mesh.area(), box));
    }
    outcome.line =
        fmt::format("{}: mesh, {}{} triangles, {} vertices, volume {:.6g} mm3", file_,
                    parts.size() > 1 ? fmt::format("{} parts, ", parts.size()) : "", triangles, vertices, volume);
    outcome.json.update(mesh_json(triangles, vertices, volume, area, bounds));
    outcome.json["notes"] = notes;
    if (parts.size() > 1 || !parts.front().name.empty() || parts.front().colour)
      outcome.line += lines, outcome.json["parts"] = std::move(list);
    return outcome;
  }
  static nlohmann::ordered_json mesh_json(std::size_t triangles, std::size_t vertices, double volume, double area,
                                          const Box& bounds) {
    auto ranges = nlohmann::ordered_json::array();
    for (int axis = 0; axis < 3; ++axis) ranges.push_back({bounds.lower[axis], bounds.upper[axis]});
    return {{"triangles", triangles}, {"vertices", vertices}, {"volume", volume}, {"area", area}, {"bounds", ranges}};
  }
  Outcome image_info() const {
    const Image image = read_png(file_);
    Outcome outcome{fmt::format("{}: picture, {} x {} pixels, {} x {} bit", file_, image.width, image.height,
                                image.channels, image.depth),
                    {{"file", file_},
                     {"kind", "image"},
                     {"width", image.width},
                     {"height", image.height},
                     {"channels", image.channels},
                     {"depth", image.depth}},
                    0};
    if (image.pixels_per_mm > 0) {
      outcome.line += fmt::format(", {:.6g} pixels per mm", image.pixels_per_mm);
      outcome.json["pixels_per_mm"] = image.pixels_per_mm;
    }
    if (image.has_heights) {
      const double low = image.bounds.lower.z(), high = image.bounds.upper.z();
      outcome.line += fmt::format(", heights from {:.6g} to {:.6g} mm", low, high);
      outcome.json["heights"] = {low, high};
    }
    return outcome;
  }

  std::string file_, histogram_;
  ScanArguments scan_;
};

class ConvertVerb final : public Verb {
 public:
  void declare(CLI::App& app) override {
    verb_ = app.add_subcommand(
        "convert", "turn a file into another form: f-rep texts, distance fields, level sets, meshes, volumes");
    const Formats& formats = openscad::all_formats();
    options_.declare(*verb_,
                     fmt::format("the file to write: {}; a volume also as {}",
                                 formats.writable({FormatKind::formula, FormatKind::distances, FormatKind::mesh}),
                                 formats.writable({FormatKind::volume})));
  }
  Outcome run(Progress& progress) override {
    const Formats& formats = openscad::all_formats();
    const std::optional<FormatKind> to = formats.written(options_.output);
    if (!to)
      throw Error(
          ErrorKind::bad_input, options_.output,
          fmt::format("there is no writer for '{}'; known are {}, and {} for volumes", extension_of(options_.output),
                      formats.writable({FormatKind::formula, FormatKind::distances, FormatKind::mesh}),
                      formats.writable({FormatKind::volume})));
    Outcome outcome{fmt::format("{}: from {}", options_.output, options_.model),
                    {{"input", options_.model}, {"output", options_.output}},
                    0};
    write(*to, outcome, progress);
    return outcome;
  }

 private:
  void write(FormatKind to, Outcome& outcome, Progress& progress) const {
    const Formats& formats = openscad::all_formats();
    if (to == FormatKind::mesh) {
      // A mesh is converted as it is; `fieldfab mesh` contours it.
      if (formats.is_read_as(FormatKind::mesh, options_.model)) return rewrite_mesh(progress);
      const Outcome made = write_surface(options_, progress);
      for (const char* const key : {"certain", "uncertain"})
        if (made.json.contains(key)) outcome.json[key] = made.json[key];
    } else if (to == FormatKind::volume) {
      if (!formats.is_read_as(FormatKind::volume, options_.model))
        throw Error(ErrorKind::bad_input, options_.output,
                    fmt::format("only a volume can be written as '{}', and {} is none", extension_of(options_.output),
                                options_.model));
      const ScanOptions scan = options_.scan.parsed();
      VolumePtr volume = open_volume(options_.model, scan.file, progress);
      write_volume(*denoised(std::move(volume), scan.clean.denoise, progress), options_.output, progress);
    } else if (to == FormatKind::formula) {
      if (options_.thickness) throw Error(ErrorKind::bad_input, "--thickness", "a text holds the model as it is");
      write_file(options_.output,
                 text_of(formats.is_read_as(FormatKind::design, options_.model) ? design_as_formula(progress)
                                                                                : options_.open(progress),
                         progress));
    } else {
      const Solid solid = options_.open_solid(progress);
      const Box bounds = working_bounds(solid, options_.region(), progress);
      const auto [cell, certainty] = options_.lattice_cells(bounds, solid, progress);
      if (extension_of(options_.output) == ".vdb")
        write_vdb(*solid.field, bounds, cell, options_.output, progress);
      else
        Asdf::build(*solid.field, bounds, {cell, options_.max_error.value_or(-1), true}, progress)
            ->save(options_.output);
      outcome.line += ", " + certainty.text();
      tell_certainty(certainty, outcome);
    }
  }

  void rewrite_mesh(Progress& progress) const {
    std::vector<std::string> notes;
    std::vector<MeshPart> parts = load_mesh_parts(options_.model, progress, notes);
    print_notes(notes);
    if (!options_.part.empty()) parts = {part_of(std::move(parts), options_.part)};
    if (!openscad::all_formats().find(options_.output)->parts) tell_parts_lost(parts.size(), options_.output);
    write_mesh_parts(parts, options_.output, progress);
  }

  static MeshPart part_of(std::vector<MeshPart> parts, const std::string& name) {
    for (MeshPart& part : parts)
      if (part.name == name) return std::move(part);
    std::vector<std::string_view> names;
    for (const MeshPart& part : parts) names.push_back(part.name);
    throw Error(ErrorKind::bad_input, "--part",
                fmt::format("there is no part '{:.60}'{}", name, suggestion(name, names)));
  }

  [[nodiscard]] std::string text_of(const Model& model, Progress& progress) const {
    const std::string form = extension_of(options_.output);
    const std::filesystem::path folder = std::filesystem::absolute(options_.output).parent_path();
    if (form == ".frep") return print_model(model, folder);
    const frep::Expression expression = options_.as_one(model, progress).expression;
    if (frep::has_opened(expression))
      throw Error(
          ErrorKind::bad_input, options_.model,
          fmt::format("has parts that are no formulas, and cannot be written as '{}'; .frep text can name their files",
                      form));
    return form == ".math" ? frep::print_math(expression)
           : form == ".vm" ? frep::print_vm(expression)
                           : frep::print_dot(expression);
  }

  /// Returns an OpenSCAD design as one expression. Throws bad_input if it has none.
  [[nodiscard]] Model design_as_formula(Progress& progress) const {
    const std::filesystem::path path = options_.model;
    const auto design = openscad::make_design(openscad::read_tree(path, progress), path.parent_path(),
                                              {options_.smooth, true}, progress);
    if (!design->formula) throw Error(ErrorKind::bad_input, options_.model, "the design is empty");
    print_notes(design->notes);
    Model model;
    model.parts.push_back(solid_of(frep::simplify(*design->formula)));
    return model;
  }

  ModelOptions options_;
};

}  // namespace

std::unique_ptr<Verb> render_verb() { return std::make_unique<RenderVerb>(); }
std::unique_ptr<Verb> info_verb() { return std::make_unique<InfoVerb>(); }
std::unique_ptr<Verb> convert_verb() { return std::make_unique<ConvertVerb>(); }

}  // namespace fieldfab::cli
