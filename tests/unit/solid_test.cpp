#include "fieldfab/solid/solid.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>

#include "fieldfab/asdf/asdf.h"
#include "fieldfab/core/error.h"
#include "fieldfab/field/bounds.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"
#include "fieldfab/openscad/design.h"
#include "fieldfab/solid/open.h"
#include "fieldfab/solid/surface.h"

namespace fieldfab {
namespace {

/// A folder with files of each kind.
class Solids : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_);
    write("ball.frep", "sphere(2)");
    write("lever.csg", "multmatrix([[1,0,0,1],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { cube(size = [4, 2, 1]); }");
    const FieldPtr ball = frep::make_field(frep::shapes::sphere(2));
    Asdf::build(*ball, {Vec3::Constant(-3), Vec3::Constant(3)}, {0.1, -1, true})->save(path("ball.asdf"));
    write_mesh(contour(*ball, {Vec3::Constant(-3), Vec3::Constant(3)}, {0.25, -1, true}), path("ball.stl"));
    settings_.formats = &openscad::all_formats();
  }

  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }
  [[nodiscard]] Model model(const std::string& text) const { return parse_model(text, "t", folder_, settings_); }
  [[nodiscard]] Solid solid(const std::string& text) const { return united(model(text)); }
  [[nodiscard]] std::string refusal(const std::string& text) const {
    try {
      (void)model(text);
    } catch (const Error& error) {
      EXPECT_NE(error.kind(), ErrorKind::internal);
      return error.what();
    }
    return "accepted";
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("fieldfab_solid_" + std::to_string(::getpid()));
  OpenSettings settings_;
};

TEST_F(Solids, OfAllKindsAreOneLanguage) {
  for (const char* file : {"ball.frep", "ball.asdf", "ball.stl"}) {
    const Solid cut = solid("open(\"" + std::string(file) + "\") - move(cylinder(0.5, 9), 1)");
    EXPECT_LT(cut.field->value({0, 0, 0}), 0) << file;
    EXPECT_GT(cut.field->value({1, 0, 0}), 0) << file;
    EXPECT_GT(cut.field->value({0, 0, 2.3}), 0) << file;
  }
  EXPECT_LT(solid("open(\"lever.csg\") | sphere(0.5)").field->value({4.5, 1, 0.5}), 0);
}

TEST_F(Solids, WrittenAsTextAreTheSameSolids) {
  for (const char* text : {"rotate_z(open(\"ball.asdf\", level = 0), 30) | move(open(\"ball.stl\"), 1, 2, 3)",
                           "open(\"lever.csg\", smooth = 1)",
                           "blend(open(\"ball.stl\"), open(\"lever.csg\"), 0.5) - open(\"ball.frep\")"}) {
    const Solid one = solid(text);
    const std::string written = print_model({{one}, {}}, folder_);
    EXPECT_EQ(written.find(folder_.string()), std::string::npos) << "names are relative to the folder: " << written;
    const Solid other = solid(written);
    for (int i = 0; i < 200; ++i) {
      const Vec3 p(i % 7 - 3.1, i % 11 - 5.2, i % 13 - 6.3);
      EXPECT_EQ(one.field->value(p), other.field->value(p)) << written;
    }
  }
  EXPECT_THROW((void)print_model({{solid_of(solid("open(\"ball.stl\")").field, "mesh")}, {}}), Error)
      << "made in memory";
}

TEST_F(Solids, KeepWhatStaysTrue) {
  const Solid lever = solid("open(\"lever.csg\")"), moved = solid("rotate_z(move(open(\"lever.csg\"), 0, 0, 3), 30)");
  ASSERT_NE(lever.faces, nullptr);
  ASSERT_NE(moved.faces, nullptr);
  const auto faces = moved.faces(std::nullopt, Progress::none());
  ASSERT_TRUE(faces.has_value());
  EXPECT_EQ(faces->triangles.size(), lever.faces(std::nullopt, Progress::none())->triangles.size());
  EXPECT_NEAR(faces->volume(), 8, 1e-4);
  for (const auto& corner : faces->vertices)
    EXPECT_NEAR(moved.field->value({corner[0], corner[1], corner[2]}), 0, 1e-4)
        << "the Field and the faces are one solid";
  EXPECT_EQ(solid("mirror_x(open(\"lever.csg\"))").faces, nullptr) << "mirrored faces would face inward";
  EXPECT_EQ(solid("open(\"lever.csg\") | sphere(1)").faces, nullptr);

  const Solid scan = solid("open(\"ball.asdf\")"), large = solid("scale(open(\"ball.asdf\"), 4)");
  ASSERT_TRUE(scan.voxel && large.voxel && scan.bounds);
  EXPECT_NEAR(*large.voxel, 4 * *scan.voxel, 1e-9);
  EXPECT_EQ(default_voxel(scan, *scan.bounds), *scan.voxel);
  EXPECT_EQ(solid("open(\"ball.asdf\")").kind, "asdf");
  EXPECT_EQ(solid("open(\"ball.asdf\") - box(1, 1, 1)").kind, "f-rep");
}

TEST_F(Solids, AreRefusedWithThePlaceOfTheCall) {
  EXPECT_NE(refusal("\n  open(\"missing.stl\")").find("t:2:3: "), std::string::npos);
  EXPECT_NE(refusal("open(\"ball.stl\", threshold = 3)").find("is an option of a volume"), std::string::npos);
  EXPECT_NE(refusal("open(\"ball.asdf\", levle = 3)").find("did you mean 'level'?"), std::string::npos);
  EXPECT_NE(refusal("open(\"ball.stl\", part = \"lid\")").find("no part 'lid'"), std::string::npos);
  write("script.py", "print('run')");
  EXPECT_NE(refusal("open(\"script.py\")").find("is a script"), std::string::npos);
  write("a.frep", "open(\"b.frep\")");
  write("b.frep", "open(\"a.frep\") | sphere(1)");
  EXPECT_NE(refusal("open(\"a.frep\")").find("opens itself: a.frep opens b.frep opens a.frep"), std::string::npos);
  OpenSettings closed = settings_;
  closed.opens_others = false;
  EXPECT_THROW((void)parse_model("open(\"ball.stl\")", "t", folder_, closed), Error);
}

TEST_F(Solids, OfOneModelAreParts) {
  write("two.frep", "part(sphere(1), \"ball\", \"red\")\npart(move(open(\"ball.stl\"), 9), \"far\")");
  const Model two = open_model(path("two.frep"), settings_);
  ASSERT_EQ(two.parts.size(), 2U);
  EXPECT_EQ(part_of(two, "far", "here").name, "far");
  EXPECT_THROW((void)part_of(two, "fr", "here"), Error);
  EXPECT_LT(united(two).field->value({9, 0, 0}), 0);
  EXPECT_GT(solid("open(\"two.frep\", part = \"ball\")").field->value({9, 0, 0}), 0);
  EXPECT_LT(solid("open(\"two.frep\")").field->value({9, 0, 0}), 0);
}

TEST(Formats, AreOneTable) {
  const Formats& all = openscad::all_formats();
  for (const Format& row : all.rows()) {
    EXPECT_FALSE(row.extensions.empty() || row.help.empty());
    EXPECT_TRUE(row.written || row.read != nullptr);
    // Readers and writers in the lower layers have the same extensions.
    for (const std::string& extension : row.extensions)
      EXPECT_EQ(is_mesh_extension(extension), row.kind == FormatKind::mesh) << extension;
    for (const std::string& extension : row.extensions) EXPECT_EQ(all.find("part" + extension), &row) << extension;
  }
  EXPECT_EQ(all.find("scan.NII.GZ")->kind, FormatKind::volume);
  EXPECT_EQ(all.find("part.xyz"), nullptr);
  EXPECT_EQ(kernel_formats().find("part.scad"), nullptr);
  EXPECT_EQ(all.find("part.scad")->kind, FormatKind::design);
  EXPECT_TRUE(all.is_read_as(FormatKind::design, "part.SCAD"));
  EXPECT_FALSE(all.is_read_as(FormatKind::mesh, "part.glb"));  // can only be written
  EXPECT_EQ(all.written("part.glb"), FormatKind::mesh);
  EXPECT_EQ(all.written("scan.vdb"), FormatKind::distances);
  EXPECT_EQ(all.written("scan.dcm"), std::nullopt);
  EXPECT_EQ(all.writable({FormatKind::distances}), ".asdf .vdb");
}

}  // namespace
}  // namespace fieldfab
