// Exact faces of OpenSCAD designs: valid by CGAL, with volumes and corners of closed forms, and
// equal to the Field that is contoured.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iomanip>
#include <numbers>
#include <random>
#include <sstream>

#include "fieldfab/check/check.h"
#include "fieldfab/core/error.h"
#include "fieldfab/openscad/design.h"

namespace fieldfab::openscad {
namespace {

OpenedSolid design(std::string_view text, bool smooth = false) {
  return *make_design(parse_csg(text, "t"), "/nowhere", {smooth, false});
}

std::optional<TriangleMesh> faces(std::string_view text, std::optional<double> thickness = {}) {
  const OpenedSolid made = design(text);
  return made.faces ? made.faces(thickness, Progress::none()) : std::nullopt;
}

std::string moved(double x, double y, double z, const std::string& text) {
  return "multmatrix([[1,0,0," + std::to_string(x) + "],[0,1,0," + std::to_string(y) + "],[0,0,1," + std::to_string(z) +
         "],[0,0,0,1]]) { " + text + " }";
}
/// Rotated by an angle with irrational sine and cosine.
std::string turned(const std::string& text) {
  return "multmatrix([[0.8660254037844387,-0.5,0,0],[0.5,0.8660254037844387,0,0],[0,0,1,0],[0,0,0,1]]) { "
         "multmatrix([[1,0,0,0],[0,0.9659258262890683,-0.2588190451025207,0],[0,0.2588190451025207,0.9659258262890683,"
         "0],"
         "[0,0,0,1]]) { " +
         text + " } }";
}

/// Volume of a solid, which must be valid.
double volume(const std::string& text, std::optional<double> thickness = {}) {
  const auto surface = faces(text, thickness);
  if (!surface) return std::nan("");
  const MeshVerdict verdict = inspect(*surface);
  EXPECT_TRUE(verdict.valid()) << text;
  return verdict.volume;
}

const std::string block = "cube(size = [4, 4, 4]);";
const std::string beam = "cylinder($fn = 64, h = 4, r1 = 1, r2 = 1);";
const double beam_volume = 4 * 32 * std::sin(std::numbers::pi / 32);

TEST(CsgFaces, HaveTheVolumesOfClosedForms) {
  for (const bool tilted : {false, true}) {
    const auto check = [&](const std::string& text, double wanted) {
      EXPECT_NEAR(volume(tilted ? turned(text) : text), wanted, 1e-5 * wanted) << text;
    };
    check(block, 64);
    check(block + moved(4, 0, 0, block), 128);  // a common face
    // a part of a face in common
    check(block + moved(4, 1, 0, block), 128);
    // flush at both ends
    check("difference() { " + block + moved(2, 2, 0, beam) + " }", 64 - beam_volume);
    check("difference() { " + block + moved(2, 2, -1, beam) + " }", 64 - 0.75 * beam_volume);
    check("intersection() { " + block + moved(3, 0, 0, block) + " }", 16);
    check("difference() { " + block + " difference() { " + moved(1, 1, 1, block) + moved(2, 2, 2, block) + " } }",
          64 - 27 + 8);
    // one on top of another, one separate
    check(beam + moved(0, 0, 4, beam) + moved(5, 0, 0, beam), 3 * beam_volume);
    check("difference() { " + moved(0, 0, 0, "cylinder($fn = 360, h = 4, r1 = 2, r2 = 2);") +
              "cylinder($fn = 360, h = 4, r1 = 1, r2 = 1); }",
          4 * 3 * 180 * std::sin(std::numbers::pi / 180));  // coplanar ends of long thin triangles
  }
  EXPECT_NEAR(volume("difference() { square(size = 4); " + moved(1, 1, 0, "square(size = 1);") + " }", 3), 45, 1e-4);
}

/// Rotated randomly about the origin, written with six digits as OpenSCAD does.
std::string turned_anyhow(std::mt19937& random, const std::string& text) {
  std::normal_distribution<double> number;
  const Eigen::Matrix3d turn = Eigen::Quaterniond(number(random), number(random), number(random), number(random))
                                   .normalized()
                                   .toRotationMatrix();
  std::ostringstream matrix;
  matrix << std::setprecision(6) << "multmatrix([";
  for (Eigen::Index row = 0; row < 3; ++row)
    matrix << '[' << turn(row, 0) << ',' << turn(row, 1) << ',' << turn(row, 2) << ",0],";
  return matrix.str() + "[0,0,0,1]]) { " + text + " }";
}

TEST(CsgFaces, AreThoseOfAssembliesTurnedEachItsOwnWay) {
  const std::string assembly = "difference() { " + block + moved(2, 2, 0, beam) + " }" +  // flush at both ends
                               moved(0, 0, 4, block) + moved(4, 1, 1, "cube(size = [2, 2, 2]);") + moved(2, 2, 8, beam);
  const double solid = 64 + 64 + 8, hull_side = 30;
  for (unsigned seed = 0; seed < 25; ++seed) {
    std::mt19937 random(seed);
    std::string row;
    const int count = 2 + static_cast<int>(random() % 3);
    for (int i = 0; i < count; ++i) row += moved(25 * i, 0, 0, turned_anyhow(random, assembly));
    EXPECT_NEAR(volume(row), count * solid, 1e-4 * count * solid) << seed;
    const std::string around = turned_anyhow(random, "cube(size = [30, 30, 30], center = true);");
    const double whole = std::pow(hull_side, 3);
    EXPECT_NEAR(volume("difference() { " + around + turned_anyhow(random, assembly) + " }"), whole - solid,
                1e-5 * whole)
        << seed;
    EXPECT_NEAR(volume("intersection() { " + around + turned_anyhow(random, assembly) + " }"), solid, 1e-4 * solid)
        << seed;
  }
}

TEST(CsgFaces, AreSetApartWhereTheyTouchAlongAnEdge) {
  for (const bool tilted : {false, true}) {
    const std::string text = block + moved(4, 4, 0, block);
    const auto surface = faces(tilted ? turned(text) : text);
    ASSERT_TRUE(surface);
    EXPECT_TRUE(inspect(*surface).valid());
    EXPECT_NEAR(surface->volume(), 128, 0.05);
    // A hole that is flush at both ends leaves no thin skin.
    const std::string bored = "difference() { group() { " + text + " } " + moved(2, 2, 0, beam) + " }";
    EXPECT_NEAR(volume(tilted ? turned(bored) : bored), 128 - beam_volume, 0.05);
  }
}

TEST(CsgFaces, AreFewAndHaveTheCornersOfTheDesign) {
  const auto surface = faces(block + moved(4, 0, 0, block));
  ASSERT_TRUE(surface);
  for (const auto& p : surface->vertices)
    for (const float x : p) EXPECT_TRUE(x == 0 || x == 4 || x == 8) << x;
  EXPECT_LE(surface->triangles.size(), 20U);
}

TEST(CsgFaces, AreNotHadOfWhatIsRoundOrEmptyOrOpen) {
  EXPECT_EQ(design("sphere(r = 3);", true).faces, nullptr);
  EXPECT_EQ(faces("intersection() { " + block + moved(9, 0, 0, block) + " }"), std::nullopt);
  // a common corner
  EXPECT_EQ(faces("intersection() { " + block + turned(moved(-4, -4, -4, block)) + " }"), std::nullopt);
  EXPECT_EQ(faces("polyhedron(points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], faces = [[0,1,2],[0,3,1],[0,2,3]]);"),
            std::nullopt);
  EXPECT_EQ(faces("square(size = 2);"), std::nullopt);
  EXPECT_EQ(faces(block, 2.0), std::nullopt);
}

/// Leaves of a random tree.
std::string leaf(std::mt19937& random) {
  std::uniform_real_distribution<double> number(1, 4);
  const std::string a = std::to_string(number(random)), b = std::to_string(number(random)),
                    c = std::to_string(number(random));
  switch (random() % 4) {
    case 0: return "cube(size = [" + a + "," + b + "," + c + "]);";
    case 1:
      return "cylinder($fn = " + std::to_string(3 + random() % 20) + ", h = " + a + ", r1 = " + b + ", r2 = " + c +
             ");";
    case 2: return "sphere($fn = " + std::to_string(4 + random() % 12) + ", r = " + a + ");";
    default: return "linear_extrude(height = " + a + ", twist = " + c + "0) { square(size = [" + b + ", " + c + "]); }";
  }
}
std::string tree(std::mt19937& random, int depth) {
  std::uniform_real_distribution<double> shift(-3, 3);
  if (depth == 0) {
    const std::string text = moved(shift(random), shift(random), std::round(shift(random)), leaf(random));
    return random() % 2 == 0 ? turned(text) : text;
  }
  const char* const names[] = {"group", "difference", "intersection"};
  return std::string(names[random() % 3]) + "() { " + tree(random, depth - 1) + tree(random, depth - 1) + " }";
}

TEST(CsgFaces, AreTheSolidThatTheFieldIs) {
  std::mt19937 random(3);
  int had = 0;
  for (int i = 0; i < 150; ++i) {
    const std::string text = tree(random, 1 + static_cast<int>(random() % 3));
    const OpenedSolid made = design(text);
    if (made.field == nullptr || !made.faces) continue;
    const auto surface = made.faces({}, Progress::none());
    if (!surface) continue;
    ++had;
    ASSERT_TRUE(inspect(*surface).valid()) << text;
    // The Field is 0 at every corner and centre of a face, within the last digits of single
    // precision. Faces that were separated deviate by some millionths of the size more.
    float farthest = 0;
    for (const auto& t : surface->triangles) {
      Vec3 middle = Vec3::Zero();
      for (const std::uint32_t corner : t) {
        const auto& p = surface->vertices[corner];
        middle += Vec3(p[0], p[1], p[2]) / 3;
        farthest = std::max(farthest, std::abs(made.field->value(Vec3(p[0], p[1], p[2]))));
      }
      farthest = std::max(farthest, std::abs(made.field->value(middle)));
    }
    EXPECT_LT(farthest, 1e-3) << text;
  }
  EXPECT_GT(had, 90);
}

/// Sets of unit cells in a block: the slow, obvious twin.
constexpr int across = 7;
using Cells = std::array<bool, across * across * across>;

/// A random tree of boxes with integer coordinates, as text and as the set of its cells.
std::pair<std::string, Cells> boxes(std::mt19937& random, int depth) {
  if (depth == 0) {
    std::array<int, 3> lower{}, upper{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lower[axis] = static_cast<int>(random() % (across - 1));
      upper[axis] = lower[axis] + 1 + static_cast<int>(random() % static_cast<unsigned>(across - lower[axis]));
    }
    Cells cells{};
    for (int z = lower[2]; z < upper[2]; ++z)
      for (int y = lower[1]; y < upper[1]; ++y)
        for (int x = lower[0]; x < upper[0]; ++x) cells[static_cast<std::size_t>((z * across + y) * across + x)] = true;
    const std::string width = std::to_string(upper[0] - lower[0]), depth_of = std::to_string(upper[1] - lower[1]),
                      height = std::to_string(upper[2] - lower[2]);
    return {moved(lower[0], lower[1], lower[2], "cube(size = [" + width + ", " + depth_of + ", " + height + "]);"),
            cells};
  }
  const std::size_t operation = random() % 4;  // unions are twice as likely
  const char* const names[] = {"group", "difference", "intersection", "group"};
  auto [text, cells] = boxes(random, depth - 1);
  for (auto others = 1 + random() % 3; others > 0; --others) {
    const auto [more, other] = boxes(random, static_cast<int>(random() % static_cast<unsigned>(depth)));
    text += more;
    for (std::size_t i = 0; i < cells.size(); ++i)
      cells[i] = operation == 1 ? cells[i] && !other[i] : operation == 2 ? cells[i] && other[i] : cells[i] || other[i];
  }
  return {std::string(names[operation]) + "() { " + text + " }", cells};
}

TEST(BoxFaces, AreThoseOfTheCellsInThem) {
  // As OpenSCAD writes them: rotate([0,0,90]), rotate([20,30,40]), mirror([1,2,0]) and
  // scale([1.5,0.7,-2]), with six digits.
  struct Placement {
    std::string matrix;
    double volume;
  };
  const Placement placements[] = {
      {"[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]", 1},
      {"[[0,-1,0,0],[1,0,0,0],[0,0,1,0],[0,0,0,1]]", 1},
      {"[[0.663414,-0.473021,0.579769,0],[0.55667,0.829769,0.040009,0],[-0.5,0.296198,0.813798,0],[0,0,0,1]]", 1},
      {"[[0.6,-0.8,0,0],[-0.8,-0.6,0,0],[0,0,1,0],[0,0,0,1]]", 1},
      {"[[1.5,0,0,0],[0,0.7,0,0],[0,0,-2,0],[0,0,0,1]]", 2.1},
  };
  std::mt19937 random(5);
  int exact = 0, had = 0;
  for (int i = 0; i < 300; ++i) {
    const auto [text, cells] = boxes(random, 1 + static_cast<int>(random() % 4));
    const auto count = static_cast<double>(std::count(cells.begin(), cells.end(), true));
    for (const Placement& placement : placements) {
      const std::string placed = "multmatrix(" + placement.matrix + ") { " + text + " }";
      const auto surface = faces(placed);
      ASSERT_EQ(surface.has_value(), count > 0) << placed;
      if (!surface) continue;
      const MeshVerdict verdict = inspect(*surface);
      ASSERT_TRUE(verdict.valid()) << placed;
      const double wanted = count * placement.volume;
      // If cells only touch, all are grown by 4 millionths of the largest coordinate.
      ASSERT_NEAR(verdict.volume, wanted, 6e-5 * surface->area()) << placed;
      ++had;
      if (std::abs(verdict.volume - wanted) < 3e-6 * wanted) ++exact;
    }
  }
  EXPECT_GT(exact, had / 2) << had;
}

TEST(BoxFaces, AreHadOfASponge) {
  // Three levels of bars are subtracted, in a tilted position; the volume is known.
  std::string bars;
  const std::function<void(double, double, double, int)> add = [&](double y, double z, double side, int level) {
    const double third = side / 3;
    const std::string size = std::to_string(third);
    bars += moved(-40.5, y - third / 2, z - third / 2, "cube(size = [81, " + size + ", " + size + "]);");
    if (level == 1) return;
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        if (i != 0 || j != 0) add(y + i * third, z + j * third, third, level - 1);
  };
  add(0, 0, 81, 3);
  const std::string whole = moved(-40.5, -40.5, -40.5, "cube(size = [81, 81, 81]);");
  const std::string along_y = "multmatrix([[0,0,1,0],[1,0,0,0],[0,1,0,0],[0,0,0,1]]) { " + bars + " }";
  const std::string along_z = "multmatrix([[0,1,0,0],[0,0,1,0],[1,0,0,0],[0,0,0,1]]) { " + bars + " }";
  const std::string sponge = "difference() { " + whole + bars + along_y + along_z + " }";
  const double wanted = 81.0 * 81 * 81 * std::pow(20.0 / 27, 3);
  EXPECT_NEAR(volume(turned(sponge)), wanted, 1e-5 * wanted);
  // One half, cut along a plane that is not a plane of the bars.
  const std::string half =
      "difference() { " + turned(sponge) + moved(-100, -100, 0, "cube(size = [200, 200, 200]);") + " }";
  EXPECT_NEAR(volume(half), wanted / 2, 1e-5 * wanted);
}

TEST(BoxFaces, AreInOnePlaneWhereSixDigitsPutThemApart) {
  const std::string third = "cube(size = [10, 10, 3.33333]);";
  const auto surface = faces("difference() { cube(size = [10, 10, 10]); " + moved(0, 0, 3.33333, third) +
                             moved(0, 0, 6.66667, "cube(size = [10, 10, 3.33333]);") + " }");
  ASSERT_TRUE(surface);
  EXPECT_EQ(surface->triangles.size(), 12U);
  EXPECT_NEAR(surface->volume(), 333.333, 1e-3);
}

}  // namespace
}  // namespace fieldfab::openscad
