#include "fieldfab/solid/open.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "fieldfab/asdf/asdf.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/text.h"
#include "fieldfab/mesh/mesh_distances.h"
#include "fieldfab/mesh/mesh_field.h"
#include "fieldfab/mesh/mesh_parts.h"
#include "fieldfab/solid/scan_solid.h"
#include "fieldfab/solid/script.h"
#include "readers.h"

namespace fieldfab {

/// The files of one model.
struct OpenFiles {
  std::vector<std::filesystem::path> being_read;  ///< the outermost first
  std::map<std::string, frep::Expression> known;  ///< by path and options
  std::map<std::string, Model> models;            ///< by path and options: all parts of a file
  std::vector<std::string> notes;
};

namespace {

constexpr std::uintmax_t most_text = 256'000'000;  // bytes

const Formats& formats_of(const OpenSettings& settings) {
  return settings.formats != nullptr ? *settings.formats : kernel_formats();
}

/// Returns the canonical path, or the path itself if it cannot be resolved; reading it reports the
/// reason.
std::filesystem::path resolved(const std::filesystem::path& path) {
  std::error_code failure;
  std::filesystem::path found = std::filesystem::canonical(path, failure);
  return failure ? std::filesystem::absolute(path, failure).lexically_normal() : found;
}

/// Formats options as open() takes them: "threshold = 300, denoise = "median"".
std::string text_of(std::span<const frep::OpenOption> options) {
  std::string text;
  for (const frep::OpenOption& option : options) {
    text += fmt::format("{}{} = ", text.empty() ? "" : ", ", option.name);
    if (const double* number = std::get_if<double>(&option.value))
      text += fmt::format("{}", *number);
    else
      text += frep::in_quotes(std::get<std::string>(option.value));
  }
  return text;
}

std::string key_of(const std::filesystem::path& path, std::span<const frep::OpenOption> options) {
  return resolved(path).string() + "\n" + text_of(options);
}

/// Removes `part = "NAME"` from options, and returns the name.
std::optional<std::string> part_wanted(std::vector<frep::OpenOption>& options) {
  const auto found =
      std::find_if(options.begin(), options.end(), [](const auto& option) { return option.name == "part"; });
  if (found == options.end()) return std::nullopt;
  const std::string* const name = std::get_if<std::string>(&found->value);
  if (name == nullptr) throw Error(ErrorKind::bad_input, "part", "the name of a part stands in quotes");
  std::string wanted = *name;
  options.erase(found);
  return wanted;
}

/// Throws bad_input for options that a format does not have.
void check_options(std::span<const frep::OpenOption> options, const Format& format, const std::string& path) {
  for (const frep::OpenOption& option : options) {
    std::vector<std::string_view> known{"part"};
    const OpenOptionInfo* info = nullptr;
    for (const OpenOptionInfo& other : open_options()) {
      known.push_back(other.name);
      if (other.name == option.name) info = &other;
    }
    if (info == nullptr)
      throw Error(ErrorKind::bad_input, path,
                  fmt::format("'open' has no option '{:.40}'{}", option.name, suggestion(option.name, known)));
    if (info->kind != format.kind)
      throw Error(ErrorKind::bad_input, path,
                  fmt::format("'{}' is an option of a {}, and this is a {}", option.name, name_of(info->kind),
                              name_of(format.kind)));
  }
}

/// Opens the files that a text names.
class FileOpener {
 public:
  FileOpener(const std::filesystem::path& folder, const OpenSettings& settings, Progress& progress)
      : folder_(folder), settings_(settings), progress_(progress) {}

  frep::Expression operator()(const std::string& name, std::span<const frep::OpenOption> options) const {
    const std::filesystem::path path = folder_ / name;
    const std::string key = key_of(path, options);
    if (const auto known = settings_.files->known.find(key); known != settings_.files->known.end())
      return known->second;
    const frep::Expression expression = open_solid(path, options, settings_, progress_).expression;
    settings_.files->known.emplace(key, expression);
    return expression;
  }

 private:
  std::filesystem::path folder_;
  const OpenSettings& settings_;
  Progress& progress_;
};

Model model_of_formula(const frep::Expression& expression) {
  Model model;
  model.parts.push_back(solid_of(expression));
  return model;
}

}  // namespace

const std::vector<OpenOptionInfo>& open_options() {
  using Kind = FormatKind;
  static const std::vector<OpenOptionInfo> options{
      {"threshold", Kind::volume,
       "threshold density of the solid: a number, a percentile such as 90%, otsu, or halfway"},
      {"below", Kind::volume, "1: densities below the threshold are solid"},
      {"dims", Kind::volume, "samples X,Y,Z of a .raw or .vol file"},
      {"type", Kind::volume, "type of the samples: uint8 int8 uint16 int16 uint32 int32 float32 float64"},
      {"byte_order", Kind::volume, "byte order of the samples: little or big"},
      {"skip", Kind::volume, "bytes before the samples"},
      {"spacing", Kind::volume, "mm between samples, X,Y,Z"},
      {"series", Kind::volume, "of a DICOM folder with several: its identifier, a part of it, or its number"},
      {"crop", Kind::volume, "only these samples: first X,Y,Z and last X,Y,Z"},
      {"denoise", Kind::volume, "median[:RADIUS in samples], gaussian[:SIGMA in mm] or anisotropic[:CONDUCTANCE]"},
      {"keep_largest", Kind::volume, "1: keep the largest piece only"},
      {"min_island", Kind::volume, "remove pieces smaller than this many mm3"},
      {"min_hole", Kind::volume, "fill cavities smaller than this many mm3"},
      {"fill_holes", Kind::volume, "1: fill all cavities"},
      {"level", Kind::distances, "level of a file with several resolutions; 0 is the finest"},
      {"smooth", Kind::design, "1: true circles and spheres, not faceted as OpenSCAD draws them"},
  };
  return options;
}

Model model_of_file(const std::shared_ptr<OpenedSolid>& opened, const std::filesystem::path& path,
                    const OpenSettings& settings) {
  opened->path = resolved(path);
  opened->options = text_of(settings.options);
  return model_of(opened);
}

Solid open_solid(const std::filesystem::path& path, std::span<const frep::OpenOption> given,
                 const OpenSettings& settings, Progress& progress) {
  OpenSettings inner = settings;
  inner.options.assign(given.begin(), given.end());
  const std::optional<std::string> part = part_wanted(inner.options);
  if (const Format* const format = formats_of(settings).find(path))
    check_options(inner.options, *format, path.string());
  inner.scripts = Scripts::refused;
  inner.region.reset();
  if (settings.files == nullptr) {
    const Model model = open_model(path, inner, progress);
    return part ? part_of(model, *part, path.string()) : united(model);
  }
  // Two parts of one file come from one reading: the same solid is the same leaf, however it was
  // requested.
  OpenFiles& files = *settings.files;
  const std::string key = key_of(path, inner.options);
  auto known = files.models.find(key);
  if (known == files.models.end()) {
    Model model = open_model(path, inner, progress);
    std::move(model.notes.begin(), model.notes.end(), std::back_inserter(files.notes));
    model.notes.clear();
    known = files.models.emplace(key, std::move(model)).first;
  }
  const Model& model = known->second;
  return part ? part_of(model, *part, path.string()) : united(model);
}

Model open_model(const std::filesystem::path& path, const OpenSettings& settings, Progress& progress) {
  const Formats& formats = formats_of(settings);
  const Format* const format = formats.find(path);
  if (format == nullptr || format->read == nullptr)
    throw Error(ErrorKind::bad_input, path.string(),
                format != nullptr ? fmt::format("is written, not read; known are {}", formats.readable())
                                  : fmt::format("there is no reader for '{}' yet; known are {}",
                                                path.extension().string(), formats.readable()));
  if (format->kind == FormatKind::script && settings.scripts == Scripts::refused)
    throw Error(ErrorKind::bad_input, path.string(),
                "is a script; scripts are run by the fieldfab command only, by their names");
  OpenSettings inner = settings;
  const bool first = inner.files == nullptr;
  if (first) inner.files = std::make_shared<OpenFiles>();
  std::vector<std::filesystem::path>& being_read = inner.files->being_read;
  const std::filesystem::path place = resolved(path);
  if (std::find(being_read.begin(), being_read.end(), place) != being_read.end()) {
    std::string circle;
    for (const auto& file : being_read) circle += file.filename().string() + " opens ";
    throw Error(ErrorKind::bad_input, path.string(), "opens itself: " + circle + place.filename().string());
  }
  constexpr std::size_t deepest = 100;
  if (being_read.size() >= deepest)
    throw Error(ErrorKind::bad_input, path.string(), fmt::format("files open each other more than {} deep", deepest));
  being_read.push_back(place);
  if (std::vector<std::filesystem::path>* const all = inner.files_read;
      all != nullptr && std::find(all->begin(), all->end(), place) == all->end())
    all->push_back(place);
  struct Leave {
    std::vector<std::filesystem::path>& being_read;
    ~Leave() { being_read.pop_back(); }
  } const leave{being_read};
  Model model = format->read(path, inner, progress);
  if (first) std::move(inner.files->notes.begin(), inner.files->notes.end(), std::back_inserter(model.notes));
  return model;
}

Model parse_model(std::string_view text, std::string_view name, const std::filesystem::path& folder,
                  const OpenSettings& settings, Progress& progress) {
  OpenSettings inner = settings;
  const bool first = inner.files == nullptr;
  if (first) inner.files = std::make_shared<OpenFiles>();
  frep::Opener opener;
  if (settings.opens_others) opener = FileOpener(folder, inner, progress);
  Model model;
  for (frep::TextPart& part : frep::parse_parts(text, name, opener)) {
    model.parts.push_back(solid_of(std::move(part.shape)));
    model.parts.back().name = std::move(part.name);
    model.parts.back().colour = part.colour;
    model.parts.back().place = std::move(part.place);
  }
  if (first) model.notes = std::move(inner.files->notes);
  return model;
}

std::vector<frep::Diagnostic> diagnose_model(std::string_view text, const std::filesystem::path& folder,
                                             const OpenSettings& settings, Progress& progress) {
  OpenSettings inner = settings;
  if (inner.files == nullptr) inner.files = std::make_shared<OpenFiles>();
  return frep::diagnostics(text, settings.opens_others ? frep::Opener(FileOpener(folder, inner, progress)) : nullptr);
}

Model model_of(const std::shared_ptr<const OpenedSolid>& opened) {
  Model model;
  model.parts.push_back(solid_of(opened));
  model.notes = opened->notes;
  return model;
}

std::string print_model(const Model& model, const std::filesystem::path& folder) {
  std::vector<frep::TextPart> parts;
  for (const Solid& solid : model.parts) parts.push_back({solid.expression, solid.name, solid.colour, {}});
  return frep::print_parts(parts, folder);
}

Model read_math(const std::filesystem::path& path, const OpenSettings& /*settings*/, Progress& /*progress*/) {
  return model_of_formula(frep::parse_math(read_file(path, most_text), path.string()));
}

Model read_vm(const std::filesystem::path& path, const OpenSettings& /*settings*/, Progress& /*progress*/) {
  return model_of_formula(frep::parse_vm(read_file(path, most_text), path.string()));
}

Model read_frep(const std::filesystem::path& path, const OpenSettings& settings, Progress& progress) {
  return parse_model(read_file(path, most_text), path.string(), path.parent_path(), settings, progress);
}

Model read_script(const std::filesystem::path& path, const OpenSettings& settings, Progress& progress) {
  Model model = parse_model(run_script(path, progress), path.string(), path.parent_path(), settings, progress);
  for (Solid& part : model.parts) part.place.clear();  // places in the script's output, which users do not see
  return model;
}

Model read_asdf(const std::filesystem::path& path, const OpenSettings& settings, Progress& /*progress*/) {
  AsdfPart part{static_cast<int>(option_number(settings.options, "level", 0)), settings.region};
  if (part.region) {  // into the file's coordinates
    const Eigen::Affine3d back = Asdf::look(path).placement.inverse();
    part.region = image_of(*part.region, back.linear(), back.translation());
  }
  const auto asdf = Asdf::load(path, part);
  auto opened = std::make_shared<OpenedSolid>();
  opened->kind = "asdf";
  opened->field = asdf->placed();
  opened->voxel = asdf->finest();
  opened->bounds = image_of(asdf->region(), asdf->placement().linear(), asdf->placement().translation());
  return model_of_file(opened, path, settings);
}

Model read_mesh_file(const std::filesystem::path& path, const OpenSettings& settings, Progress& progress) {
  Model model;
  std::vector<MeshPart> parts = load_mesh_parts(path, progress, model.notes);
  for (MeshPart& part : parts) {
    TriangleMesh& mesh = part.mesh;
    const std::string name = path.filename().string() + (part.name.empty() ? "" : ": " + part.name);
    if (const Lids lids = lids_of(mesh); lids.are_good(mesh)) {
      mesh = closed_by(lids, mesh);
      model.notes.push_back(fmt::format("{} is open: {} {} closed by lids of {:.3g} mm2", name, lids.rims,
                                        lids.rims == 1 ? "rim is" : "rims are", lids.area));
    } else if (!lids.triangles.empty()) {
      model.notes.push_back(fmt::format(
          "{} is open, and lids cannot close it: what is inside is found by winding numbers, which takes long", name));
    }
    auto opened = std::make_shared<OpenedSolid>();
    opened->kind = "mesh";
    opened->field = mesh_field(mesh, progress);
    opened->bounds = mesh.bounds().grown(mesh.bounds().size().maxCoeff() / 64);
    opened->path = resolved(path);
    // A part of several is identified by its name.
    std::vector<frep::OpenOption> options = settings.options;
    if (parts.size() > 1) options.push_back({"part", part.name});
    opened->options = text_of(options);
    model.parts.push_back(solid_of(opened));
    model.parts.back().name = part.name;
    model.parts.back().colour = part.colour;
  }
  return model;
}

Model read_volume(const std::filesystem::path& path, const OpenSettings& settings, Progress& progress) {
  return model_of_file(opened_scan(open_scan(path, scan_options(settings.options), progress), progress), path,
                       settings);
}

}  // namespace fieldfab
