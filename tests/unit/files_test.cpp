// Mesh files and PNGs: round trips are exact; damaged files are errors.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <random>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/mesh/openmesh.h"
#include "fieldfab/mesh/ply.h"
#include "fieldfab/mesh/triangle_mesh.h"
#include "fieldfab/render/image.h"

namespace fieldfab {
namespace {

class TemporaryFolder : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("fieldfab_files_" + std::to_string(::getpid()));
};
using MeshFiles = TemporaryFolder;
using Pictures = TemporaryFolder;

/// A tetrahedron with coordinates that test the round trip of floats.
TriangleMesh tetrahedron() {
  return {{{0.1F, 1e-7F, 0}, {1.3333334F, 0, 0}, {0, 123456.7F, 0}, {0, 0, -0.3F}},
          {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
}

TEST(Meshes, KnowTheirVolumeAreaAndBounds) {
  TriangleMesh cube;
  for (int i = 0; i < 8; ++i)
    cube.vertices.push_back({10.0F + 2.0F * static_cast<float>(i & 1), 2.0F * static_cast<float>(i >> 1 & 1),
                             2.0F * static_cast<float>(i >> 2)});
  cube.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  EXPECT_DOUBLE_EQ(cube.volume(), 8);
  EXPECT_DOUBLE_EQ(cube.area(), 24);
  EXPECT_EQ(cube.bounds(), (Box{{10, 0, 0}, {12, 2, 2}}));
  EXPECT_EQ(to_openmesh(cube).n_edges(), 18U);
  EXPECT_EQ(from_openmesh(to_openmesh(cube)).vertices, cube.vertices);
  cube.triangles.push_back(cube.triangles[0]);
  EXPECT_THROW(to_openmesh(cube), Error);
}

TEST_F(MeshFiles, OfPlyHoldPropertiesOfVertices) {
  const TriangleMesh mesh = tetrahedron();
  const std::vector<Colour> colours{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {250, 251, 252}};
  const std::vector<float> off{0.5F, -0.25F, 0, 10};
  const std::vector<int> line{0, -7, 123456, 8};
  const auto path = folder / "properties.ply";
  write_ply(mesh, path, {colours, {{"deviation", off}}, {{"line", line}}});
  const TriangleMesh back = read_mesh(path);
  EXPECT_EQ(back.vertices, mesh.vertices);
  EXPECT_EQ(back.triangles, mesh.triangles);
  const std::string bytes = read_file(path), end = "end_header\n";
  const std::size_t first = bytes.find(end) + end.size(), stride = 12 + 3 + 4 + 4;
  EXPECT_NE(bytes.find("property uchar blue\nproperty float deviation\nproperty int line\nelement face"),
            std::string::npos);
  ASSERT_EQ(bytes.size(), first + 4 * stride + 4 * 13);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(std::memcmp(bytes.data() + first + i * stride + 12, &colours[i], 3), 0);
    EXPECT_EQ(std::memcmp(bytes.data() + first + i * stride + 15, &off[i], 4), 0);
    EXPECT_EQ(std::memcmp(bytes.data() + first + i * stride + 19, &line[i], 4), 0);
  }
  EXPECT_THROW(write_ply(mesh, path, {{}, {{"deviation", std::span(off).first(3)}}}), Error);
  EXPECT_EQ(read_file(path), bytes);
}

TEST_F(MeshFiles, ReadBackTheSame) {
  const TriangleMesh mesh = tetrahedron();
  for (const char* extension : {".stl", ".ply", ".off", ".obj", ".3mf"}) {
    const auto path = folder / (std::string("mesh") + extension);
    write_mesh(mesh, path);
    const TriangleMesh again = read_mesh(path);
    EXPECT_EQ(again.triangles.size(), 4U) << extension;
    EXPECT_EQ(again.vertices.size(), 4U) << extension;
    EXPECT_NEAR(again.volume(), mesh.volume(), 1e-4 * std::abs(mesh.volume())) << extension;
    if (const std::string e = extension; e == ".ply" || e == ".off" || e == ".obj") {
      EXPECT_EQ(again.vertices, mesh.vertices) << extension;
    }
  }
  EXPECT_THROW(write_mesh(mesh, folder / "mesh.xyz"), Error);
}

TEST_F(MeshFiles, ThatAreDamagedDoNotCrash) {
  std::mt19937 random(4);
  for (const char* extension : {".stl", ".ply", ".off", ".obj"}) {
    const auto path = folder / (std::string("mesh") + extension);
    write_mesh(tetrahedron(), path);
    const std::string whole = read_file(path);
    for (int i = 0; i < 60; ++i) {
      std::string bytes = whole;
      if (i % 2 == 0)
        bytes[bytes.size() / 3 + random() % (bytes.size() * 2 / 3)] ^= static_cast<char>(1U << random() % 7);
      else
        bytes.resize(random() % bytes.size());
      write_file(path, bytes);
      try {
        (void)read_mesh(path).volume();
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      }
    }
  }
}

TEST_F(MeshFiles, WithCountsThatCannotBeAreRefusedAtOnce) {
  const std::vector<std::pair<const char*, const char*>> files{
      {"a.ply", "ply\nformat ascii 1.0\nelement nothing 9999999999\nend_header\n0 0 0\n"},
      {"b.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 9999999999\nend_header\n0 0 0\n"},
      {"c.off", "OFF\n3 9999999999 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"d.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 4294967298\n"},
      {"e.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4294967299\n"}};
  for (const auto& [name, text] : files) {
    write_file(folder / name, text);
    EXPECT_THROW((void)read_mesh(folder / name), Error) << name;
  }
}

TEST_F(Pictures, ReadBackTheSame) {
  for (const int channels : {1, 3})
    for (const int depth : {8, 16}) {
      Image image;
      image.width = 5, image.height = 3, image.channels = channels, image.depth = depth;
      for (int i = 0; i < 15 * channels; ++i)
        if (depth == 16)
          image.pixels16.push_back(static_cast<std::uint16_t>(i * 1000));
        else
          image.pixels8.push_back(static_cast<std::uint8_t>(i * 5));
      image.pixels_per_mm = 12.5;
      image.bounds = {{0, 0, -1.25}, {1, 1, 7.5}};
      image.has_heights = channels == 1;
      write_png(image, folder / "i.png");
      const Image again = read_png(folder / "i.png");
      EXPECT_EQ(again.pixels8, image.pixels8);
      EXPECT_EQ(again.pixels16, image.pixels16);
      EXPECT_EQ(again.depth, depth);
      EXPECT_NEAR(again.pixels_per_mm, 12.5, 1e-9);
      EXPECT_EQ(again.has_heights, channels == 1);
      if (channels == 1) {
        EXPECT_EQ(again.bounds.lower.z(), -1.25);
        EXPECT_EQ(again.bounds.upper.z(), 7.5);
      }
      const std::string whole = read_file(folder / "i.png");
      for (std::size_t cut = 0; cut < whole.size(); cut += 3) {
        write_file(folder / "cut.png", whole.substr(0, cut));
        EXPECT_THROW(read_png(folder / "cut.png"), Error) << cut;
      }
      std::string longer = whole;  // the first chunk after the header says that it has nearly 2 GiB
      longer.replace(33, 4, "\x7e\x22\x00\x07", 4);
      write_file(folder / "longer.png", longer);
      try {
        read_png(folder / "longer.png");
        ADD_FAILURE() << "read";
      } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("ends within a chunk"), std::string::npos) << error.what();
      }
    }
}

}  // namespace
}  // namespace fieldfab
