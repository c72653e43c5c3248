/// The sides of mesh files that have a source file of their own, and what readers and writers share.
#pragma once

#include <unordered_map>
#include <unordered_set>

#include "fieldfab/core/file.h"
#include "fieldfab/mesh/load_mesh.h"
#include "fieldfab/mesh/mesh_parts.h"

namespace fieldfab {

/// A MeshPart of someone else's mesh.
struct PartView {
  const TriangleMesh& mesh;
  std::string_view name = {};
  std::optional<Colour> colour = std::nullopt;
};

/// Tells the progress of writing so many items, and looks whether to stop, once in thousands of them.
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
void write_glb(std::span<const PartView> parts, PendingFile& file, const std::filesystem::path& path, Progress& progress);

/// Triangles as they are in the file, all that its build places together, in mm. `bytes` are the file's.
MeshFromFile read_3mf(std::string_view bytes, const std::filesystem::path& path, Progress& progress);
/// The same, a part for each item of the build that has triangles, with the names and colours that the file gives them.
std::vector<MeshPart> read_3mf_parts(std::string_view bytes, const std::filesystem::path& path, Progress& progress,
                                     std::vector<std::string>& notes);

/// The extension in lower case, with the dot.
std::string lower_extension(const std::filesystem::path& path);

/// Names that no two parts share: one that was given before has the separator and 2, 3 and so on appended.
class PartNames {
 public:
  explicit PartNames(char separator) : separator_(separator) {}
  /// `name` as it is, or with a number.
  std::string unique(std::string name);

 private:
  char separator_;
  std::unordered_set<std::string> given_;
  std::unordered_map<std::string, std::uint32_t> last_;  ///< numbers appended, by the name without
};

}  // namespace fieldfab
