/// The verbs of the `fieldfab` command, and what they share.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "fieldfab/core/progress.h"
#include "fieldfab/openscad/design.h"
#include "fieldfab/solid/open.h"
#include "fieldfab/solid/surface.h"

namespace fieldfab::cli {

/// The end of a file's name that tells its format, in lower case: ".stl", ".nii.gz".
std::string extension_of(const std::filesystem::path& path);

/// What a verb came to: one line for people, the same for programs, and the exit code.
struct Outcome {
  std::string line;
  nlohmann::ordered_json json;
  int code = 0;
};

/// Adds to the answer as JSON whether it shows all of the solid.
void tell_certainty(const Certainty& certainty, Outcome& outcome);

/// How to take a volume: options of every verb on a MODEL.
struct ScanArguments {
  std::string threshold, size, type, byte_order, spacing, series, crop, denoise, memory = "512M";
  std::optional<std::uint64_t> skip;
  std::optional<double> least_island, least_hole;
  bool below = false, keep_largest = false, fill_holes = false;

  void declare(CLI::App& verb);
  /// What was given, by the names that open() has.
  [[nodiscard]] std::vector<frep::OpenOption> options() const;
  /// The same for a volume that is read here. Throws bad_input for text that means nothing.
  [[nodiscard]] ScanOptions parsed() const;
};

/// Options that every verb on a MODEL takes.
struct ModelOptions {
  std::string model, output, part;
  std::optional<double> resolution, voxel, max_error, thickness;
  std::string bounds;
  int level = 0;
  bool smooth = false;
  ScanArguments scan;

  /// Declares them; `output` with the given description where the verb writes a file.
  void declare(CLI::App& verb, const std::string& output_help);
  /// The region asked for. Throws bad_input for text that is not six numbers.
  [[nodiscard]] std::optional<Box> region() const;
  /// Opens the model, or runs it where it is a script; keeps the part wanted; flat ones are given --thickness.
  [[nodiscard]] Model open(Progress& progress) const;
  /// The same as one solid, for a file that holds one.
  [[nodiscard]] Solid open_solid(Progress& progress) const { return as_one(open(progress), progress); }
  /// A model as one solid, for a file that holds one: tells what that leaves out of several parts.
  [[nodiscard]] Solid as_one(const Model& opened, Progress& progress) const;
  /// Makes a plate of a solid that turns out to be flat where neither bounds nor a thickness were given: its outlines are then
  /// divided into 512 cells, and it is 8 cells thick. Returns the thickness, mm; nothing where the solid was left alone.
  std::optional<double> make_plate_if_flat(Solid& solid, Progress& progress);
  /// As asked for. Throws bad_input for what is not positive.
  [[nodiscard]] Resolution wanted() const;
  /// The smallest cell, mm: as asked for, or the solid's default.
  [[nodiscard]] double cell(const Box& bounds, const Solid& solid) const;
  /// The cells of a lattice, as asked for or lattice_cells(), and whether they show all of the solid.
  [[nodiscard]] LatticeCells lattice_cells(const Box& bounds, const Solid& solid, Progress& progress) const;
  /// Whether the model is a volume to be taken sample by sample: no other lattice was asked for.
  [[nodiscard]] bool takes_samples() const;
  /// Throws bad_input unless `output` is given.
  void need_output() const;
};

/// Tells what a reader or a planner noticed, a line each, on stderr.
void print_notes(const std::vector<std::string>& notes);

/// Becomes a module of the Python package, run as a program with these arguments. Throws io where it cannot.
[[noreturn]] void become_python(const std::string& module, const std::vector<std::string>& arguments);

/// Writes the surface of a model, as `fieldfab mesh` does: `options.output` is a mesh file's name. The outcome tells of it.
Outcome write_surface(const ModelOptions& options, Progress& progress);

/// The place of a part for messages: where its text makes it, or else `file`; with its name where the model has several.
std::string place_of(const Solid& part, const Model& model, const std::string& file);

/// Tells that a file holds several parts as one.
void tell_parts_lost(std::size_t parts, const std::string& output);

/// Tells which of several parts are empty, as far as intervals show.
void tell_empty_parts(const Model& model, const std::string& file, Progress& progress);

/// A verb: declared on the command line, then run.
class Verb {
 public:
  virtual ~Verb() = default;
  virtual void declare(CLI::App& app) = 0;
  virtual Outcome run(Progress& progress) = 0;
  [[nodiscard]] bool chosen() const { return verb_ != nullptr && verb_->parsed(); }

 protected:
  CLI::App* verb_ = nullptr;
};

std::unique_ptr<Verb> build_verb();
std::unique_ptr<Verb> mesh_verb();
std::unique_ptr<Verb> render_verb();
std::unique_ptr<Verb> check_verb();
std::unique_ptr<Verb> info_verb();
std::unique_ptr<Verb> convert_verb();
std::unique_ptr<Verb> edit_verb();
std::unique_ptr<Verb> cam_verb();
std::unique_ptr<Verb> simulate_verb();
std::unique_ptr<Verb> openscad_verb();
std::unique_ptr<Verb> serve_verb();

}  // namespace fieldfab::cli
