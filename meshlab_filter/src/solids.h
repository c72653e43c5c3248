/// Conversion of layers to Fields and back, for all filters.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fieldfab/mesh/exact_solid.h"
#include "fieldfab/solid/formats.h"
#include "fieldfab/solid/surface.h"
#include "filter.h"

namespace fieldfab::meshlab {

/// Resolution of a result, and treatment of sharp edges.
struct Fineness {
  enum class Edges { automatic, kept, rounded };
  double voxel = 0;  ///< mm
  Edges edges = Edges::automatic;
};

/// Rows of a dialog for the fineness, and the values chosen. The help of the voxel states its cost
/// for this document.
std::vector<Parameter> fineness_parameters(const Document& document);
Fineness fineness_of(const Values& values);

/// Row for a length: `value` mm, with a slider from `least` to `most`.
Parameter length_parameter(std::string name, std::string label, std::string help, double value, double least,
                           double most);
Parameter number_parameter(std::string name, std::string label, std::string help, double value);
Parameter whole_parameter(std::string name, std::string label, std::string help, int value);
Parameter choice_parameter(std::string name, std::string label, std::string help, std::vector<std::string> choices,
                           int value = 0);
Parameter layer_parameter(std::string name, std::string label, std::string help, std::size_t value);
Parameter text_parameter(std::string name, std::string label, std::string help, std::string value);
Parameter flag_parameter(std::string name, std::string label, std::string help, bool value);

/// Returns the triangles of the layer with coincident vertices merged. Triangles with NaN
/// coordinates or without area are left out and counted in the log. Throws bad_input if none
/// remains.
TriangleMesh usable_triangles(const Layer& layer, std::vector<std::string>& log);

/// Whether the solid's Field is exact, with edges to be kept.
inline bool is_sharp(const Solid& solid) { return !solid.field->sampled(); }

/// Returns how often contour() may halve cells: not at all if the Field is sampled from a layer,
/// since smaller cells show no more of it.
inline int depth_for(const Field& field) { return field.sampled() ? 0 : ContourSettings{}.depth; }

/// Returns the layer as a solid with bounds: the points around which its triangles wind, with holes
/// closed by lids. Values are distances within `reach` mm of the surface (0: only next to it), as
/// offsets and walls need. Exact if triangles are larger than a few voxels or edges are to be kept;
/// otherwise sampled on a lattice. Throws bad_input, too_large (before any work, with the memory
/// needed), cancelled.
Solid solid_of(const Layer& layer, const Fineness& fineness, double reach, std::vector<std::string>& log,
               Progress& progress);

/// Returns the layer as an exact solid if it is a drawn part: closed, with triangles larger than a
/// few voxels, and with edges not to be rounded; otherwise nullopt. Throws bad_input, too_large,
/// cancelled.
std::optional<ExactSolid> exact_solid_of(const Layer& layer, const Fineness& fineness, std::vector<std::string>& log,
                                         Progress& progress);

/// Returns the same solid with distances within `reach` mm, whatever its values were.
FieldPtr with_distances(const FieldPtr& field, const Box& bounds, double reach, double voxel, Progress& progress);

/// Returns an exact solid as a new layer; nullopt if single precision cannot represent it.
std::optional<Layer> layer_of(const ExactSolid& solid, std::string name);

/// Returns the solid's surface as a new layer: closed, manifold, without self-intersections. The
/// log states how certain it is to represent the whole solid. Throws bad_input for an empty solid,
/// too_large, cancelled.
Layer layer_of(const FieldPtr& field, const Box& bounds, const Fineness& fineness, bool sharp, std::string name,
               std::vector<std::string>& log, Progress& progress);

/// Returns the common surface of all parts as a new layer, in their colours; exact faces if a solid
/// has some. A `voxel` of 0 is default_voxel(); `bounds` and `empty` are those of working_bounds().
/// The log states size and certainty, or that the layer is empty. Throws too_large, and as
/// surface() does.
Layer layer_of(const Model& model, const std::optional<Box>& bounds, double voxel, EmptySolid empty, std::string name,
               std::vector<std::string>& log, Progress& progress);

/// Returns the extensions of all readable formats of a kind, with the dot.
std::vector<std::string> extensions_read(FormatKind kind);

/// Returns the model in a file of any kind that open_model() reads, except scripts.
Model model_of_file(const std::filesystem::path& file, Progress& progress);

/// Returns the model of a file, or of infix text if the text is not a file name.
Model model_of_text(const std::string& text, Progress& progress);

/// Formats a number of bytes: 1.23 MB, 4 GB ...
std::string as_bytes(double bytes);

}  // namespace fieldfab::meshlab
