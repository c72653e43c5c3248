/// A model part of a .3mf file as written: objects, and references of the build; nothing is placed
/// yet.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "fieldfab/core/colour.h"
#include "fieldfab/core/geometry.h"
#include "fieldfab/core/progress.h"
#include "zip_archive.h"

namespace fieldfab {

/// Rows of the transform in the file's order: x, y, z and the translation. Points are row vectors:
/// p' = p M + t.
using ThreeMfTransform = std::array<double, 12>;
constexpr ThreeMfTransform three_mf_identity{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};

/// A component of an object, or an item of the build.
struct ThreeMfReference {
  std::uint32_t object = 0;
  std::uint32_t part = 0;  ///< index into ThreeMfModel::paths, from 1; 0: the same part
  ThreeMfTransform transform = three_mf_identity;
};

struct ThreeMfItem : ThreeMfReference {
  std::string part_number;
};

/// An entry of a group of base materials, or of another group of properties.
struct ThreeMfProperty {
  std::uint32_t group = 0, index = 0;
};

struct ThreeMfObject {
  bool printed = true;  ///< of type "model"
  std::string name;
  std::optional<ThreeMfProperty> property;  ///< of all its triangles
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< vertex indices, checked
  std::vector<ThreeMfReference> components;
};

struct ThreeMfModel {
  double unit = 1;  ///< mm
  std::unordered_map<std::uint32_t, ThreeMfObject> objects;
  std::vector<ThreeMfItem> build;
  std::vector<std::string> paths;  ///< names of other parts in references
  std::unordered_map<std::uint32_t, std::vector<std::optional<Colour>>> base_materials;
  std::set<std::string> left_out;  ///< in words, for people: "slices"
  bool has_names = false;          ///< of objects
  bool has_colours = false;        ///< or materials, of any kind
  bool has_other_colours = false;  ///< other than the base material of a whole object
};

/// Remaining limits for all parts of a file together.
struct ThreeMfBudget {
  std::uint64_t objects = std::uint64_t{1} << 20;
  std::uint64_t references = std::uint64_t{1} << 22;
  std::uint64_t letters = std::uint64_t{1} << 28;  ///< bytes of names
};

/// Reads a model part (3MF core specification 1.3, chapters 3 and 4). Elements in the namespace of
/// the root element are read, others are ignored. Throws bad_input with the part's line, too_large,
/// cancelled.
ThreeMfModel read_three_mf_model(const ZipReader& zip, const std::string& part, const std::filesystem::path& path,
                                 ThreeMfBudget& budget, Progress& progress);

/// Returns the name of the first model part of a package (Open Packaging Conventions). Throws
/// bad_input.
std::string first_model_part(const ZipReader& zip, const std::filesystem::path& path, Progress& progress);

}  // namespace fieldfab
