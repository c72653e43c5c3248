/// Mesh formats with a source file of their own, and functions that readers and writers share.
#pragma once

#include <unordered_map>
#include <unordered_set>

#include "fieldfab/core/file.h"
#include "fieldfab/mesh/load_mesh.h"
#include "fieldfab/mesh/mesh_parts.h"

namespace fieldfab {

/// A MeshPart that refers to a mesh owned elsewhere.
struct PartView {
  const TriangleMesh& mesh;
  std::string_view name = {};
  std::optional<Colour> colour = std::nullopt;
};

/// Reports the progress of writing items, and checks for cancellation, once in thousands of items.
class WritingProgress {
 public:
  WritingProgress(Progress& progress, std::uint64_t items) : progress_(progress), items_(items) {}
  void step() {
    if (done_++ % 16384 != 0) return;
    progress_.check();
    progress_.report(static_cast<double>(done_) / static_cast<double>(items_), "writing the mesh");
  }

 private:
  Progress& progress_;
  std::uint64_t items_, done_ = 0;
};

void write_3mf(std::span<const PartView> parts, PendingFile& file, Progress& progress);
/// Throws too_large for more than 4 GiB; `path` is for messages.
void write_glb(std::span<const PartView> parts, PendingFile& file, const std::filesystem::path& path,
               Progress& progress);

/// Returns all triangles that the build of the file places, together, in mm, unmerged. `bytes` is
/// the content of the file.
MeshFromFile read_3mf(std::string_view bytes, const std::filesystem::path& path, Progress& progress);
/// Returns one part for each item of the build that has triangles, with its name and colour in the
/// file.
std::vector<MeshPart> read_3mf_parts(std::string_view bytes, const std::filesystem::path& path, Progress& progress,
                                     std::vector<std::string>& notes);

/// Unique names: a name that was used before gets the separator and 2, 3 and so on appended.
class PartNames {
 public:
  explicit PartNames(char separator) : separator_(separator) {}
  /// Returns `name`, or `name` with a number.
  std::string unique(std::string name);

 private:
  char separator_;
  std::unordered_set<std::string> given_;
  std::unordered_map<std::string, std::uint32_t> last_;  ///< last number appended, by the original name
};

}  // namespace fieldfab
