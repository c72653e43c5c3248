// A model written as .frep text and read again is the same model, for all sources of its solids.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <fstream>

#include "fieldfab/asdf/asdf.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"
#include "fieldfab/mesh/mesh_parts.h"
#include "fieldfab/openscad/design.h"
#include "fieldfab/solid/open.h"
#include "random_expression.h"

namespace fieldfab {
namespace {

/// A folder with files of all kinds, each of a ball of radius 2 or of a solid with several parts.
class Files {
 public:
  Files() {
    std::filesystem::create_directories(folder_ / "inner");
    const FieldPtr ball = frep::make_field(frep::shapes::sphere(2));
    const Box box{Vec3::Constant(-3), Vec3::Constant(3)};
    Asdf::build(*ball, box, {0.2, -1, true})->save(folder_ / "ball.asdf", {-1, 2});
    const TriangleMesh mesh = contour(*ball, box, {0.5, -1, true});
    write_mesh(mesh, folder_ / "ball.stl");
    write_mesh_parts(std::vector<MeshPart>{{mesh, "a: b", Colour{1, 2, 3}}, {mesh, "ö", {}}},
                     folder_ / "two parts.3mf");
    constexpr int side = 24;
    std::string samples;
    for (int i = 0; i < side * side * side; ++i) {
      const Vec3 at = (Vec3(i % side, i / side % side, i / side / side) - Vec3::Constant((side - 1) / 2.0)) * 0.25;
      samples += static_cast<char>(std::clamp(128 - 60 * ball->value(at), 0.0F, 255.0F));
    }
    write("ball.raw", samples);
    write(
        "ball.nrrd",
        "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 24 24 24\nspacings: 0.25 0.25 0.25\nencoding: raw\n\n" + samples);
    write("lever.csg", "union() { cube(size = [4, 2, 1]); sphere($fn = 12, $fa = 12, $fs = 2, r = 1); }");
    write("inner/nested.frep",
          "part(open(\"../ball.stl\") - box(1, 1, 9), \"cut\", \"teal\")\npart(open(\"../ball.asdf\"), \"ball\")");
    settings_.formats = &openscad::all_formats();
  }
  ~Files() { std::filesystem::remove_all(folder_); }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;

  [[nodiscard]] Model parse(const std::string& text) const { return parse_model(text, "text", folder_, settings_); }
  [[nodiscard]] std::string print(const Model& model) const { return print_model(model, folder_); }

 private:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / fmt::format("fieldfab solid text {}", ::getpid());
  OpenSettings settings_;
};

/// The text of one solid of each kind.
const std::vector<std::string> leaves{
    "sphere(1.5)",
    "gyroid(3)",
    "open(\"ball.asdf\")",
    "open(\"ball.asdf\", level = 1)",
    "open(\"ball.stl\")",
    "open(\"two parts.3mf\")",
    "open(\"two parts.3mf\", part = \"a: b\")",
    "open(\"two parts.3mf\", part = \"ö\")",
#ifdef FIELDFAB_HAS_ITK  // not in the sanitizer build
    "open(\"ball.nrrd\", threshold = 128)",
    "open(\"ball.nrrd\", threshold = \"otsu\", below = 1, denoise = \"median:1\")",
    "open(\"ball.nrrd\", threshold = \"40%\", keep_largest = 1, crop = \"2,2,2,20,21,22\")",
#endif
    "open(\"ball.raw\", dims = \"24,24,24\", type = \"uint8\", spacing = \"0.25,0.3,0.2\", threshold = 100.1)",
    "open(\"lever.csg\")",
    "open(\"lever.csg\", smooth = 1)",
    "open(\"inner/nested.frep\")",
    "open(\"inner/nested.frep\", part = \"cut\")",
};

double number(double low, double high) { return low + (high - low) * draw(0, 10001) / 10000.0; }

/// The text of leaves that are moved, bent, joined and blended; each function is called with a
/// leaf.
std::string random_text(int depth) {
  if (depth == 0) return leaves[static_cast<std::size_t>(draw(0, static_cast<int>(leaves.size())))];
  const std::string a = random_text(depth - 1);
  const auto b = [&] { return random_text(draw(0, depth)); };
  switch (draw(0, 10)) {
    case 0: return fmt::format("union({}, {})", a, b());
    case 1: return fmt::format("{} - {}", a, b());
    case 2: return fmt::format("move({}, {}, {}, {})", a, number(-3, 3), number(-3, 3), number(-3, 3));
    case 3: return fmt::format("rotate_x({}, {})", a, number(-180, 180));
    case 4: return fmt::format("scale({}, {})", a, number(0.3, 3));
    case 5: return fmt::format("smooth_union({}, {}, {})", a, b(), number(0.1, 1));
    case 6: return fmt::format("shell({}, {})", a, number(0.1, 1));
    case 7: return fmt::format("twist({}, {})", a, number(-20, 20));
    case 8: return fmt::format("array_polar({}, {})", a, draw(1, 6));
    default: return fmt::format("morph({}, {}, {})", a, b(), number(0, 1));
  }
}

RC_GTEST_PROP(ModelText, IsReadAsTheSameModel, ()) {
  static const Files files;
  const std::vector<std::string> colours{"", ", \"tomato\"", ", \"#01fe80\""};
  std::string text;
  const int parts = draw(1, 4);
  if (parts == 1) text = random_text(draw(0, 4));
  for (int i = 0; parts > 1 && i < parts; ++i)
    text += fmt::format("part({}, \"part {} ü\"{})\n", random_text(draw(0, 4)), i,
                        colours[static_cast<std::size_t>(draw(0, 3))]);
  const Model one = files.parse(text);
  const std::string written = files.print(one);
  RC_LOG() << text << "\n" << written;
  const Model other = files.parse(written);
  RC_ASSERT(files.print(other) == written);
  RC_ASSERT(one.parts.size() == static_cast<std::size_t>(parts));
  RC_ASSERT(other.parts.size() == one.parts.size());
  for (std::size_t i = 0; i < one.parts.size(); ++i) {
    const Solid &a = one.parts[i], &b = other.parts[i];
    RC_ASSERT(a.name == b.name);
    RC_ASSERT(a.colour == b.colour);
    RC_ASSERT(a.kind == b.kind);
    RC_ASSERT(a.flat == b.flat);
    RC_ASSERT((a.faces == nullptr) == (b.faces == nullptr));
    RC_ASSERT(a.voxel == b.voxel);
    for (int j = 0; j < 30; ++j) {
      const Vec3 p(number(-4, 4), number(-4, 4), number(-4, 4));
      const float wanted = a.field->value(p), got = b.field->value(p);
      RC_ASSERT((wanted == got || (std::isnan(wanted) && std::isnan(got))));
    }
  }
}

TEST(ModelText, OfEachKindIsReadAsTheSameSolid) {
  const Files files;
  for (const std::string& leaf : leaves) {
    const Model one = files.parse(leaf);
    const std::string written = files.print(one);
    const Solid a = united(one), b = united(files.parse(written));
    EXPECT_EQ(a.kind, b.kind) << written;
    for (int i = 0; i < 500; ++i) {
      const Vec3 p(i % 7 - 3.1, i % 11 * 0.5 - 2.6, i % 13 * 0.4 - 2.4);
      EXPECT_EQ(a.field->value(p), b.field->value(p)) << written;
    }
  }
}

}  // namespace
}  // namespace fieldfab
