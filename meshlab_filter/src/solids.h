/// From layers to Fields and back: what all filters share.
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

/// How fine a result is, and what becomes of sharp edges.
struct Fineness {
  enum class Edges { automatic, kept, rounded };
  double voxel = 0;  ///< mm
  Edges edges = Edges::automatic;
};

/// The rows of a dialog that say so, and what was chosen. The voxel's help tells what it costs with this document.
std::vector<Parameter> fineness_parameters(const Document& document);
Fineness fineness_of(const Values& values);

/// A row for a length: `value` mm, with a slider from `least` to `most`.
Parameter length_parameter(std::string name, std::string label, std::string help, double value, double least, double most);
Parameter number_parameter(std::string name, std::string label, std::string help, double value);
Parameter whole_parameter(std::string name, std::string label, std::string help, int value);
Parameter choice_parameter(std::string name, std::string label, std::string help, std::vector<std::string> choices,
                           int value = 0);
Parameter layer_parameter(std::string name, std::string label, std::string help, std::size_t value);
Parameter text_parameter(std::string name, std::string label, std::string help, std::string value);
Parameter flag_parameter(std::string name, std::string label, std::string help, bool value);

/// The layer's triangles with vertices at the same place merged; those with places that are NaN, or without area, are left out
/// and counted in the log. Throws bad_input where none is left.
TriangleMesh usable_triangles(const Layer& layer, std::vector<std::string>& log);

/// Whether the solid's Field is exact, with edges to be kept.
inline bool is_sharp(const Solid& solid) { return !solid.field->sampled(); }

/// How often contour() may halve cells: what was sampled from a layer shows nothing more of it in smaller ones.
inline int depth_for(const Field& field) { return field.sampled() ? 0 : ContourSettings{}.depth; }

/// The layer as a solid with bounds: what its triangles wind around, holes closed by lids. Within `reach` mm of the surface its
/// values are distances (0: only next to it), as offsets and walls need. Exact where triangles are larger than a few voxels or
/// edges are to be kept, else sampled on a lattice. Throws bad_input, too_large (before anything is begun, with how much it would
/// take), cancelled.
Solid solid_of(const Layer& layer, const Fineness& fineness, double reach, std::vector<std::string>& log, Progress& progress);

/// The layer as an exact solid: where it is a drawn part, of triangles larger than a few voxels, and closed, and its edges are
/// not to be rounded. Throws bad_input, too_large, cancelled.
std::optional<ExactSolid> exact_solid_of(const Layer& layer, const Fineness& fineness, std::vector<std::string>& log,
                                         Progress& progress);

/// The same solid with distances within `reach` mm, whatever its values were.
FieldPtr with_distances(const FieldPtr& field, const Box& bounds, double reach, double voxel, Progress& progress);

/// An exact solid as a new layer; nothing where single precision cannot hold it.
std::optional<Layer> layer_of(const ExactSolid& solid, std::string name);

/// The solid's surface as a new layer: closed, manifold, without self-intersections. The log tells how certain it is that all of
/// the solid is in it. Throws bad_input for nothing, too_large, cancelled.
Layer layer_of(const FieldPtr& field, const Box& bounds, const Fineness& fineness, bool sharp, std::string name,
               std::vector<std::string>& log, Progress& progress);

/// The surface of all parts together as a new layer, in their colours; the own faces of a solid that has some. A `voxel` of 0 is
/// default_voxel(); `bounds` and `empty` are those of working_bounds(). The log tells its size and certainty, or that it is
/// empty. Throws too_large, and as surface() does.
Layer layer_of(const Model& model, const std::optional<Box>& bounds, double voxel, EmptySolid empty, std::string name,
               std::vector<std::string>& log, Progress& progress);

/// Extensions of all formats of a kind that are read, with the dot.
std::vector<std::string> extensions_read(FormatKind kind);

/// The model in a file of any kind that open_model() knows, scripts left aside.
Model model_of_file(const std::filesystem::path& file, Progress& progress);

/// The model of a file, or of infix text where the text is no file's name.
Model model_of_text(const std::string& text, Progress& progress);

/// 1.23 MB, 4 GB ...
std::string as_bytes(double bytes);

}  // namespace fieldfab::meshlab
