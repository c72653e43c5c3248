// Meshes in text formats: a reader that parses floats and one that parses doubles both get the mesh
// that was written, and it is valid. The readers here are independent of the kernel's.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "../family.h"
#include "fieldfab/check/check.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/core/file.h"
#include "fieldfab/field/bounds.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/text.h"
#include "fieldfab/solid/open.h"
#include "mesh/zip_archive.h"
#include "thin_solid.h"

namespace fieldfab {
namespace {

namespace fs = std::filesystem;

/// A mesh as read from a text: numbers as floats and as doubles.
struct TextMesh {
  std::vector<std::array<double, 3>> doubles;
  std::vector<std::array<float, 3>> floats;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// Reads three numbers at `at`, each after `before`, and advances `at`.
  void add_vertex(const char*& at, std::array<std::string_view, 3> before) {
    std::array<double, 3> wide;
    std::array<float, 3> narrow;
    for (std::size_t i = 0; i < 3; ++i) {
      at += before[i].size();
      char* end = nullptr;
      wide[i] = std::strtod(at, &end);
      narrow[i] = std::strtof(at, nullptr);
      ASSERT_NE(at, end);
      at = end;
    }
    doubles.push_back(wide);
    floats.push_back(narrow);
  }
  void add_triangle(const char*& at, std::array<std::string_view, 3> before, std::uint32_t first) {
    std::array<std::uint32_t, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      at += before[i].size();
      char* end = nullptr;
      corners[i] = static_cast<std::uint32_t>(std::strtoul(at, &end, 10)) - first;
      ASSERT_NE(at, end);
      at = end;
    }
    triangles.push_back(corners);
  }
};

/// Calls act() with the rest of each line that starts with the given text.
template <class Act>
void each_line(const std::string& text, std::string_view begins, const Act& act) {
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = text.find('\n', at);
    if (end == std::string::npos) end = text.size();
    if (std::string_view(text).substr(at, end - at).starts_with(begins)) act(text.data() + at + begins.size());
    at = end + 1;
  }
}

TextMesh read_obj(const std::string& text) {
  TextMesh mesh;
  each_line(text, "v", [&](const char* at) { mesh.add_vertex(at, {" ", " ", " "}); });
  each_line(text, "f", [&](const char* at) { mesh.add_triangle(at, {" ", " ", " "}, 1); });
  return mesh;
}

TextMesh read_off(const std::string& text) {
  TextMesh mesh;
  char* at = nullptr;
  const unsigned long vertices = std::strtoul(text.data() + 4, &at, 10), triangles = std::strtoul(at, &at, 10);
  const char* line = text.data() + text.find('\n', 4) + 1;
  for (unsigned long i = 0; i < vertices; ++i, ++line) mesh.add_vertex(line, {"", " ", " "});
  for (unsigned long i = 0; i < triangles; ++i, ++line) mesh.add_triangle(line, {"3 ", " ", " "}, 0);
  return mesh;
}

TextMesh read_model_part(const std::string& archive, const fs::path& path) {
  std::string text;
  ZipReader(archive, path).read("3D/3dmodel.model", [&](std::string_view bytes) { text += bytes; });
  TextMesh mesh;
  each_line(text, "<vertex", [&](const char* at) { mesh.add_vertex(at, {" x=\"", "\" y=\"", "\" z=\""}); });
  each_line(text, "<triangle ", [&](const char* at) { mesh.add_triangle(at, {"v1=\"", "\" v2=\"", "\" v3=\""}, 0); });
  return mesh;
}

class TextForms : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  void expect_valid_and_the_same(const TriangleMesh& mesh, const std::string& what) {
    for (const char* extension : {".obj", ".off", ".3mf"}) {
      const fs::path path = folder_ / (std::string("mesh") + extension);
      write_mesh(mesh, path);
      const std::string bytes = read_file(path);
      const TextMesh read = std::string_view(extension) == ".obj"   ? read_obj(bytes)
                            : std::string_view(extension) == ".off" ? read_off(bytes)
                                                                    : read_model_part(bytes, path);
      ASSERT_EQ(read.floats, mesh.vertices) << what << ' ' << extension;
      ASSERT_EQ(read.triangles, mesh.triangles) << what << ' ' << extension;
      for (std::size_t i = 0; i < read.doubles.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
          ASSERT_EQ(read.doubles[i][axis], double{read.floats[i][axis]}) << what << ' ' << extension << " vertex " << i;
    }
    // All readings equal this mesh bit for bit.
    const MeshVerdict verdict = inspect(mesh);
    EXPECT_TRUE(verdict.valid()) << what << ": closed " << verdict.closed << " manifold " << verdict.manifold
                                 << " self-intersections " << verdict.self_intersections;
  }

  fs::path folder_ = fs::temp_directory_path() / fmt::format("fieldfab_text_forms_{}", ::getpid());
};

TEST_F(TextForms, OfTheGalleryAreValidReadEitherWay) {
  std::vector<fs::path> models;
  for (const auto& entry : fs::directory_iterator(fs::path(TEST_DATA) / ".." / ".." / "examples"))
    if (entry.path().extension() == ".frep") models.push_back(entry.path());
  EXPECT_GE(models.size(), 20U);
  std::sort(models.begin(), models.end());
  for (std::size_t i = 0; i < models.size(); i += sample_or_all(3, 1)) {
    const fs::path& path = models[i];
    const Solid model = united(open_model(path));
    FieldPtr solid = model.field;
    const SolidBounds found = solid_bounds(*solid);
    Box bounds = found.box.grown(0.5);
    if (!found.bounded[2]) {
      bounds.lower.z() = -1, bounds.upper.z() = 5;
      solid = intersect(solid, box_field({{-1e6, -1e6, 0}, {1e6, 1e6, 4}}));
    }
    ContourSettings settings{bounds.size().maxCoeff() / 24};
    settings.most_divided = 0;
    const ContourMesh mesh = contour(*solid, bounds, settings);
    ASSERT_FALSE(mesh.triangles.empty()) << path;
    expect_valid_and_the_same(mesh, path.filename().string());
  }
}

TEST_F(TextForms, OfRandomSolidsAreValidReadEitherWay) {
  const int count = sample_or_all(30, 500);
  std::mt19937 random(20261124);
  int meshes = 0;
  for (int i = 0; i < count; ++i) {
    const std::string text = random_thin_solid(random);
    ContourSettings settings{0.5};
    settings.most_divided = 0;
    const ContourMesh mesh =
        contour(*frep::make_field(frep::parse_infix(text)), {Vec3::Constant(-3), Vec3::Constant(3)}, settings);
    if (mesh.triangles.empty()) continue;
    expect_valid_and_the_same(mesh, text);
    ++meshes;
  }
  EXPECT_GE(meshes, count / 2);
}

}  // namespace
}  // namespace fieldfab
