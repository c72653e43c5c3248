/// Verbs of the `fieldfab` command, and functions that they share.
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

/// Returns the end of a file name that determines its format, in lower case: ".stl", ".nii.gz".
std::string extension_of(const std::filesystem::path& path);

/// Result of a verb: one line for people, the same as JSON, and the exit code.
struct Outcome {
  std::string line;
  nlohmann::ordered_json json;
  int code = 0;
};

/// Adds to the JSON whether the result represents the whole solid.
void tell_certainty(const Certainty& certainty, Outcome& outcome);

/// Options of each verb on a MODEL for reading volumes.
struct ScanArguments {
  std::string threshold, size, type, byte_order, spacing, series, crop, denoise, memory = "512M";
  std::optional<std::uint64_t> skip;
  std::optional<double> least_island, least_hole;
  bool below = false, keep_largest = false, fill_holes = false;

  void declare(CLI::App& verb);
  /// Returns the options given, by the names that open() uses.
  [[nodiscard]] std::vector<frep::OpenOption> options() const;
  /// Returns the options for a volume that the caller reads. Throws bad_input for invalid text.
  [[nodiscard]] ScanOptions parsed() const;
};

/// Options of each verb on a MODEL.
struct ModelOptions {
  std::string model, output, part;
  std::optional<double> resolution, voxel, max_error, thickness;
  std::string bounds;
  int level = 0;
  bool smooth = false;
  ScanArguments scan;

  /// Declares the options; `output` gets the given description if the verb writes a file.
  void declare(CLI::App& verb, const std::string& output_help);
  /// Returns the region given. Throws bad_input unless the text is six numbers.
  [[nodiscard]] std::optional<Box> region() const;
  /// Opens the model, or runs it if it is a script. Keeps the part wanted, and gives flat parts
  /// --thickness.
  [[nodiscard]] Model open(Progress& progress) const;
  /// Opens the model as one solid, for a file that holds one.
  [[nodiscard]] Solid open_solid(Progress& progress) const { return as_one(open(progress), progress); }
  /// Returns a model as one solid, for a file that holds one. Reports the metadata of several parts
  /// that are lost.
  [[nodiscard]] Solid as_one(const Model& opened, Progress& progress) const;
  /// Makes a plate of a solid that proves to be flat, unless bounds or a thickness were given: 512
  /// cells across its outlines, and 8 cells thick. Returns the thickness, mm, or nullopt if the
  /// solid is unchanged.
  std::optional<double> make_plate_if_flat(Solid& solid, Progress& progress);
  /// Returns the resolution given. Throws bad_input unless it is positive.
  [[nodiscard]] Resolution wanted() const;
  /// Returns the smallest cell, mm: as given, or the solid's default.
  [[nodiscard]] double cell(const Box& bounds, const Solid& solid) const;
  /// Returns the cells of a lattice, as given or from lattice_cells(), and whether they represent
  /// the whole solid.
  [[nodiscard]] LatticeCells lattice_cells(const Box& bounds, const Solid& solid, Progress& progress) const;
  /// Whether the model is a volume to be imported sample by sample, since no other lattice was
  /// requested.
  [[nodiscard]] bool takes_samples() const;
  /// Throws bad_input unless `output` is given.
  void need_output() const;
};

/// Prints notes of a reader or a planner to stderr, one per line.
void print_notes(const std::vector<std::string>& notes);

/// Replaces the process by a module of the Python package, run as a program with these arguments.
/// Throws io on failure.
[[noreturn]] void become_python(const std::string& module, const std::vector<std::string>& arguments);

/// Writes the surface of a model, like `fieldfab mesh`; `options.output` is the name of a mesh
/// file. The outcome describes it.
Outcome write_surface(const ModelOptions& options, Progress& progress);

/// Returns the place of a part for messages: the place in its text that makes it, or else `file`;
/// with its name if the model has several parts.
std::string place_of(const Solid& part, const Model& model, const std::string& file);

/// Reports that a file holds several parts as one.
void tell_parts_lost(std::size_t parts, const std::string& output);

/// Reports the parts that are empty, as far as intervals prove it, if there are several parts.
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
