/// MODEL files: anything a Field can come from, chosen by the file's extension.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fieldfab/asdf/import.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"
#include "fieldfab/frep/expression.h"
#include "fieldfab/mesh/triangle_mesh.h"
#include "fieldfab/volume/scan.h"

namespace fieldfab {

/// A solid read from a file.
struct Model {
  FieldPtr field;
  std::string kind;                            ///< "f-rep", "asdf", "mesh", "volume" or "design"
  std::optional<frep::Expression> expression;  ///< where it came from text
  std::optional<double> voxel;                 ///< where the file has a resolution of its own
  std::optional<Box> bounds;                   ///< where the file has a region of its own
  /// Makes the surface of a solid that has flat faces only, exactly: valid as contour()'s is, with the corners that the solid
  /// has. Nothing where that is not possible, or would take long; a flat (2D) solid needs a thickness in mm. Null where contour()
  /// is all there is. Throws cancelled.
  std::function<std::optional<TriangleMesh>(std::optional<double> thickness, Progress& progress)> faces = {};
  std::vector<std::string> notes = {};  ///< what was left out or mended, for people, one line each
};

/// Whether a model may be a program: a .py script can do anything its user can, so only those run it who were told to by name.
enum class Scripts { refused, run };

/// How designs that are drawn with flat faces are taken: as drawn, or with true circles and spheres.
enum class Roundness { as_drawn, smooth };

/// Reads .math, .vm, .frep, .asdf, a mesh or a volume (`scan` says how; `part`, what of an .asdf file), or runs a .py script, or
/// what add_model_reader() has brought. Throws io, or bad_input (also for an extension no reader knows, with a list of those
/// known), or cancelled.
Model load_model(const std::filesystem::path& path, Scripts scripts = Scripts::refused, Progress& progress = Progress::none(),
                 const ScanOptions& scan = {}, const AsdfPart& part = {}, Roundness roundness = Roundness::as_drawn);

/// A reader that a library above this one brings.
struct ModelReader {
  std::vector<std::string> extensions;  ///< in lower case, with the dot
  std::function<Model(const std::filesystem::path& path, Roundness roundness, Progress& progress)> read;
};
/// From now on load_model() knows it. Call it before anything is loaded: when a program starts, or a module is initialised.
void add_model_reader(ModelReader reader);

/// Writes the .asdf file of a scan, in as much memory as the settings say, whatever its size (see import_asdf()); its levels are
/// halved volumes.
ImportCounts import_scan(const Scan& scan, const std::filesystem::path& path, const ImportSettings& settings,
                         Progress& progress = Progress::none());

/// The lattices that import_scan() reads: the scan's, and halves of it.
std::vector<LatticeSource> lattices_of(const Scan& scan, int levels);

/// A scan as a solid in memory.
Model model_of(const Scan& scan, Progress& progress = Progress::none());

/// The region to work in: `wanted` where given (checked), else what solid_bounds() finds, a little grown. Throws bad_input for
/// an unbounded solid, naming the axes and asking for --bounds, and for an empty one unless that is allowed (any box will do for
/// it then).
enum class EmptySolid { refused, allowed };
Box working_bounds(const Model& model, const std::optional<Box>& wanted, Progress& progress = Progress::none(),
                   EmptySolid empty = EmptySolid::refused);

}  // namespace fieldfab
