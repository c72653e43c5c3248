// Mesh files of several parts: names, colours, positions and sizes, as far as each format supports
// them.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/mesh/mesh_parts.h"
#include "mesh/mesh_file.h"
#include "mesh/zip_archive.h"

namespace fieldfab {
namespace {

using Notes = std::vector<std::string>;
using Json = nlohmann::json;

const std::vector<std::string> extensions{".stl", ".ply", ".off", ".obj", ".3mf", ".glb"};
const std::string awkward = "Zahnrad \"groß\" <1> & 'zwei' 歯車 🔩";

/// A tetrahedron of `size` with its right angle at (at, 0, 0).
TriangleMesh tetrahedron(float at = 0, float size = 1) {
  return {{{at, 0, 0}, {at + size, 0, 0}, {at, size, 0}, {at, 0, size}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

class MeshParts : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  [[nodiscard]] std::set<std::string> names_in_folder() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) names.insert(entry.path().filename());
    return names;
  }
  [[nodiscard]] std::vector<MeshPart> there_and_back(const std::vector<MeshPart>& parts) const {
    write_mesh_parts(parts, path("a.3mf"));
    Notes notes;
    std::vector<MeshPart> read = load_mesh_parts(path("a.3mf"), Progress::none(), notes);
    EXPECT_EQ(notes, Notes());
    return read;
  }
  /// Parts of a .3mf file with these resources and items, as another program may write it.
  [[nodiscard]] std::vector<MeshPart> read(const std::string& resources, const std::string& build, Notes& notes) const {
    const std::string relationships =
        R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="r" )"
        R"(Target="/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>)"
        "</Relationships>";
    {
      PendingFile file(path("b.3mf"));
      ZipWriter zip(file);
      zip.add_part("_rels/.rels", relationships);
      zip.add_part(
          "3D/3dmodel.model",
          fmt::format(R"(<model unit="centimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" )"
                      R"(xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02">)"
                      "<resources>{}</resources><build>{}</build></model>",
                      resources, build));
      zip.finish();
      file.commit();
    }
    return load_mesh_parts(path("b.3mf"), Progress::none(), notes);
  }

  std::filesystem::path folder_ = std::filesystem::temp_directory_path() / fmt::format("fieldfab_parts_{}", ::getpid());
};

TEST_F(MeshParts, OfA3mfFileComeBackToTheLastBit) {
  const std::vector<MeshPart> parts{{tetrahedron(0.1F), awkward, Colour{255, 128, 1}},
                                    {tetrahedron(2, 1e-3F), "", std::nullopt},
                                    {tetrahedron(-3, 7), "plain", Colour{0, 0, 0}},
                                    {tetrahedron(9), "the same colour", Colour{255, 128, 1}}};
  const std::vector<MeshPart> back = there_and_back(parts);
  ASSERT_EQ(back.size(), parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ(back[i].name, parts[i].name);
    EXPECT_EQ(back[i].colour, parts[i].colour);
    EXPECT_EQ(back[i].mesh.vertices, parts[i].mesh.vertices);
    EXPECT_EQ(back[i].mesh.triangles, parts[i].mesh.triangles);
  }
  std::string model;
  ZipReader(read_file(path("a.3mf")), path("a.3mf")).read("3D/3dmodel.model", [&](std::string_view text) {
    model += text;
  });
  EXPECT_NE(model.find("name=\"Zahnrad &quot;groß&quot; &lt;1&gt; &amp; 'zwei' 歯車 🔩\""), std::string::npos);
  EXPECT_EQ(model.find("displaycolor=\"#ff8001\""), model.rfind("displaycolor=\"#ff8001\""))
      << "a colour is written once";
  const MeshFromFile merged = load_mesh(path("a.3mf"));
  EXPECT_EQ(merged.mesh.triangles.size(), 16U);
  EXPECT_EQ(merged.notes, Notes{"a.3mf: left out: colours and materials, names of objects"});
}

/// XML excludes control characters, invalid UTF-8, and U+FFFE and U+FFFF.
TEST_F(MeshParts, WithNamesThatXmlCannotSayAreStillRead) {
  const std::vector<MeshPart> back = there_and_back({{tetrahedron(),
                                                      "a\x01"
                                                      "b\n\tc\xff\xEF\xBF\xBE\xEF\xBF\xBF]]>",
                                                      {}}});
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back[0].name, "a b  c\uFFFD\uFFFD\uFFFD]]>");
}

TEST_F(MeshParts, ThirtyFiveAreThirtyFive) {
  std::vector<MeshPart> parts;
  for (int i = 0; i < 35; ++i)
    parts.push_back({tetrahedron(static_cast<float>(2 * i)), fmt::format("part {}", i),
                     Colour{static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(7 * i), 200}});
  const std::vector<MeshPart> back = there_and_back(parts);
  ASSERT_EQ(back.size(), 35U);
  for (std::size_t i = 0; i < 35; ++i) {
    EXPECT_EQ(back[i].name, parts[i].name);
    EXPECT_EQ(back[i].colour, parts[i].colour);
    EXPECT_EQ(back[i].mesh.bounds().lower.x(), 2.0 * static_cast<double>(i));
  }
}

TEST_F(MeshParts, OfOneNameGetNumbers) {
  std::vector<MeshPart> parts;
  for (const char* name : {"a", "a 2", "a", "", "a", "", "a 2"}) parts.push_back({tetrahedron(), name, {}});
  std::vector<std::string> names;
  for (const MeshPart& part : there_and_back(parts)) names.push_back(part.name);
  EXPECT_EQ(names, (std::vector<std::string>{"a", "a 2", "a 3", "", "a 4", "", "a 2 2"}));
}

TEST_F(MeshParts, OnePlainPartIsThePlainFile) {
  for (const std::string& extension : extensions) {
    write_mesh(tetrahedron(), path("plain" + extension));
    const MeshPart part{tetrahedron(), "", std::nullopt};
    write_mesh_parts({&part, 1}, path("part" + extension));
    EXPECT_EQ(read_file(path("part" + extension)), read_file(path("plain" + extension))) << extension;
  }
}

const std::string mesh_element =
    R"(<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/>)"
    R"(<vertex x="0" y="0" z="1"/></vertices><triangles><triangle v1="0" v2="2" v3="1"/>)"
    R"(<triangle v1="0" v2="1" v3="3"/><triangle v1="1" v2="2" v3="3"/>)"
    R"(<triangle v1="2" v2="0" v3="3"/></triangles></mesh>)";
const std::string two_colours = R"(<basematerials id="9"><base name="red" displaycolor="#FF0000"/>)"
                                R"(<base name="blue" displaycolor=" #0000ffFF "/></basematerials>)";

TEST_F(MeshParts, OfItemsArePlacedAndNamed) {
  Notes notes;
  const auto parts =
      read(two_colours + "<object id=\"1\" name=\"gear\" pid=\"9\" pindex=\"1\">" + mesh_element + "</object>" +
               "<object id=\"2\" type=\"support\">" + mesh_element + "</object><object id=\"3\">" + mesh_element +
               "</object>",
           "<item objectid=\"1\" partnumber=\"17\"/><item objectid=\"2\" partnumber=\"18\"/>"
           "<item objectid=\"3\" partnumber=\"19\" transform=\"-1 0 0 0 1 0 0 0 1 5 6 7\"/><item objectid=\"1\"/>",
           notes);
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[0].name, "gear");
  EXPECT_EQ(parts[0].colour, (Colour{0, 0, 255}));
  EXPECT_EQ(parts[0].mesh.bounds().upper, Vec3(10, 10, 10));
  EXPECT_EQ(parts[1].name, "19");
  EXPECT_EQ(parts[1].colour, std::nullopt);
  EXPECT_EQ(parts[1].mesh.bounds().lower, Vec3(40, 60, 70));
  EXPECT_EQ(parts[1].mesh.bounds().upper, Vec3(50, 70, 80));
  EXPECT_NEAR(parts[1].mesh.volume(), 1000.0 / 6, 1e-3);
  EXPECT_EQ(parts[2].name, "gear 2");
  EXPECT_EQ(notes, Notes{"b.3mf: left out: 1 object of another type than 'model'"});
}

TEST_F(MeshParts, OfComponentsAreMerged) {
  const std::string red = "<object id=\"1\" name=\"tooth\" pid=\"9\" pindex=\"0\">" + mesh_element + "</object>";
  const std::string blue = "<object id=\"2\" pid=\"9\" pindex=\"1\">" + mesh_element + "</object>";
  const auto holding = [](int id, const std::string& components) {
    return fmt::format("<object id=\"{}\" name=\"whole\"><components>{}</components></object>", id, components);
  };
  const std::string one = "<component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 1 0 0\"/>",
                    other = "<component objectid=\"2\"/>";
  Notes notes;
  const auto alike = read(two_colours + red + holding(3, one + one), "<item objectid=\"3\"/>", notes);
  ASSERT_EQ(alike.size(), 1U);
  EXPECT_EQ(alike[0].name, "whole");
  EXPECT_EQ(alike[0].colour, (Colour{255, 0, 0}));
  EXPECT_EQ(alike[0].mesh.bounds().lower, Vec3(10, 0, 0));
  EXPECT_EQ(notes, Notes{"b.3mf: left out: names of components"});
  notes.clear();
  const auto mixed = read(two_colours + red + blue + holding(3, one + other), "<item objectid=\"3\"/>", notes);
  ASSERT_EQ(mixed.size(), 1U);
  EXPECT_EQ(mixed[0].colour, std::nullopt);
  EXPECT_EQ(mixed[0].mesh.triangles.size(), 8U);
  EXPECT_EQ(notes, Notes{"b.3mf: left out: colours and materials other than one opaque base material an object, "
                         "names of components"});
}

/// Colours other than a base material of a whole object give a note. A reference to a missing
/// material is no error.
TEST_F(MeshParts, WithOtherColoursAreTold) {
  const Notes told{"b.3mf: left out: colours and materials other than one opaque base material an object"};
  const auto object_with = [](const std::string& attributes) {
    return "<object id=\"1\" " + attributes + ">" + mesh_element + "</object>";
  };
  std::string of_triangles = object_with("pid=\"9\" pindex=\"0\"");
  of_triangles.replace(of_triangles.find("v3=\"1\""), 6, "v3=\"1\" pid=\"9\" p1=\"1\"");
  const std::vector<std::pair<std::string, std::optional<Colour>>> cases{
      {R"(<m:colorgroup id="8"><m:color color="#00FF00"/></m:colorgroup>)" + object_with("pid=\"8\" pindex=\"0\""),
       std::nullopt},
      {R"(<basematerials id="7"><base name="glass" displaycolor="#11223344"/></basematerials>)" +
           object_with("pid=\"7\""),
       Colour{0x11, 0x22, 0x33}},
      {two_colours + of_triangles, Colour{255, 0, 0}}};
  for (const auto& [resources, colour] : cases) {
    Notes notes;
    const auto parts = read(resources, "<item objectid=\"1\"/>", notes);
    ASSERT_EQ(parts.size(), 1U) << resources;
    EXPECT_EQ(parts[0].colour, colour) << resources;
    EXPECT_EQ(notes, told) << resources;
  }
  for (const std::string attributes :
       {"pid=\"9\" pindex=\"2\"", "pid=\"10\" pindex=\"0\"", "pid=\"x\"", "pid=\"9\" pindex=\"-1\""}) {
    Notes notes;
    const auto parts = read(two_colours + object_with(attributes), "<item objectid=\"1\"/>", notes);
    ASSERT_EQ(parts.size(), 1U) << attributes;
    EXPECT_EQ(parts[0].colour, std::nullopt) << attributes;
  }
  for (const std::string colour : {"red", "#12345", "#GG0000", "", "#1"}) {
    Notes notes;
    const auto parts = read(
        "<basematerials id=\"9\"><base displaycolor=\"" + colour + "\"/></basematerials>" + object_with("pid=\"9\""),
        "<item objectid=\"1\"/>", notes);
    ASSERT_EQ(parts.size(), 1U) << colour;
    EXPECT_EQ(parts[0].colour, std::nullopt) << colour;
  }
}

TEST_F(MeshParts, OfOtherFilesAreOne) {
  const std::vector<MeshPart> parts{{tetrahedron(), "a", Colour{1, 2, 3}}, {tetrahedron(5, 2), "b", std::nullopt}};
  for (const std::string extension : {".stl", ".ply", ".off", ".obj"}) {
    write_mesh_parts(parts, path("two" + extension));
    Notes notes;
    const auto back = load_mesh_parts(path("two" + extension), Progress::none(), notes);
    ASSERT_EQ(back.size(), 1U);
    EXPECT_EQ(back[0].name, "");
    EXPECT_EQ(back[0].colour, std::nullopt);
    EXPECT_EQ(back[0].mesh.vertices.size(), 8U) << extension;
    EXPECT_NEAR(back[0].mesh.volume(), 9.0 / 6, 1e-6) << extension;
    EXPECT_EQ(back[0].mesh.bounds().upper, Vec3(7, 2, 2)) << extension;
  }
}

TEST_F(MeshParts, OfAnObjFileAreObjectsWithMaterials) {
  const std::vector<MeshPart> parts{{tetrahedron(), "a b#\\\n", Colour{255, 51, 0}},
                                    {tetrahedron(2), "a b##\\", std::nullopt},
                                    {tetrahedron(3), "a_b____", Colour{255, 51, 0}},
                                    {tetrahedron(4), "", Colour{0, 0, 1}}};
  write_mesh_parts(parts, path("my parts.obj"));
  const std::string text = read_file(path("my parts.obj"));
  std::vector<std::string> lines;
  for (std::size_t at = 0, end = 0; (end = text.find('\n', at)) != std::string::npos; at = end + 1)
    if (const std::string line = text.substr(at, end - at); !line.starts_with("v ") && !line.starts_with("f "))
      lines.push_back(line);
  EXPECT_EQ(lines, (std::vector<std::string>{"# by Fieldfab, mm", "mtllib my parts.mtl", "o a_b___",
                                             "usemtl colour_ff3300", "o a_b____2", "usemtl colourless", "o a_b____",
                                             "usemtl colour_ff3300", "o part", "usemtl colour_000001"}));
  EXPECT_NE(text.find("\nf 5 7 6\n"), std::string::npos) << "indices go on from part to part";
  EXPECT_EQ(read_file(path("my parts.mtl")),
            "# by Fieldfab\nnewmtl colour_ff3300\nKd 1 0.2 0\nnewmtl colourless\nKd 0.8 0.8 0.8\nnewmtl colour_000001\n"
            "Kd 0 0 0.00392157\n");
}

TEST_F(MeshParts, OfAnObjFileWithoutColoursHaveNoMaterials) {
  const std::vector<MeshPart> parts{{tetrahedron(), "a", {}}, {tetrahedron(2), "b", {}}};
  write_mesh_parts(parts, path("a.obj"));
  EXPECT_EQ(names_in_folder(), std::set<std::string>{"a.obj"});
  EXPECT_EQ(read_file(path("a.obj")).find("mtl"), std::string::npos);
}

TEST_F(MeshParts, OfAnObjFileThatCannotBeWrittenLeaveNoMaterials) {
  const MeshPart part{tetrahedron(), "a", Colour{1, 2, 3}};
  std::filesystem::create_symlink("/dev/full", path("a.obj"));
  EXPECT_THROW(write_mesh_parts({&part, 1}, path("a.obj")), Error);
  EXPECT_EQ(names_in_folder(), std::set<std::string>{"a.obj"});
  std::filesystem::create_directory(path("b.mtl"));  // the path of the material file
  write_file(path("b.obj"), "old");
  EXPECT_THROW(write_mesh_parts({&part, 1}, path("b.obj")), Error);
  EXPECT_EQ(read_file(path("b.obj")), "old");
}

TEST_F(MeshParts, OfAPlyFileColourTheirVertices) {
  const std::vector<MeshPart> parts{{tetrahedron(), "a", Colour{1, 2, 3}}, {tetrahedron(2), "b", std::nullopt}};
  write_mesh_parts(parts, path("a.ply"));
  const std::string bytes = read_file(path("a.ply")), end = "end_header\n";
  EXPECT_NE(
      bytes.find("property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face 8\n"),
      std::string::npos);
  const std::size_t first = bytes.find(end) + end.size();
  ASSERT_EQ(bytes.size(), first + 8 * 15 + 8 * 13);
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_EQ(bytes.substr(first + 15 * i + 12, 3), i < 4 ? "\x01\x02\x03" : "\xcc\xcc\xcc") << i;
  std::uint32_t corner = 0;
  std::memcpy(&corner, bytes.data() + first + 8 * 15 + 4 * 13 + 1, 4);
  EXPECT_EQ(corner, 4U) << "indices go on from part to part";
}

/// Chunks of a .glb file.
struct Glb {
  Json json;
  std::string binary;

  explicit Glb(const std::string& bytes) {
    const auto word = [&](std::size_t at) {
      std::uint32_t value = 0;
      std::memcpy(&value, bytes.data() + at, 4);
      return value;
    };
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word(4), 2U);
    EXPECT_EQ(word(8), bytes.size());
    EXPECT_EQ(word(12) % 4, 0U);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    json = Json::parse(bytes.substr(20, word(12)));
    if (const std::size_t next = 20 + word(12); next < bytes.size()) {
      EXPECT_EQ(bytes.substr(next + 4, 4), std::string_view("BIN\0", 4));
      binary = bytes.substr(next + 8);
      EXPECT_EQ(binary.size(), word(next));
    }
  }
  /// The triples of an accessor.
  template <class Number>
  [[nodiscard]] std::vector<std::array<Number, 3>> triples(std::size_t accessor) const {
    const Json& view = json["bufferViews"][json["accessors"][accessor]["bufferView"].get<std::size_t>()];
    std::vector<std::array<Number, 3>> values(view["byteLength"].get<std::size_t>() / 12);
    std::memcpy(values.data(), binary.data() + view["byteOffset"].get<std::size_t>(), 12 * values.size());
    return values;
  }
};

TEST_F(MeshParts, OfAGlbFileAreNodes) {
  const std::vector<MeshPart> parts{{tetrahedron(0.1F), awkward, Colour{255, 128, 10}},
                                    {TriangleMesh{}, "empty", {}},
                                    {tetrahedron(-3, 7), "", std::nullopt}};
  write_mesh_parts(parts, path("a.glb"));
  const Glb file(read_file(path("a.glb")));
  const Json& json = file.json;
  EXPECT_EQ(json["asset"], (Json{{"version", "2.0"}, {"generator", "Fieldfab"}}));
  EXPECT_EQ(json["scenes"][0]["nodes"], Json::array({0}));
  EXPECT_EQ(json["nodes"][0]["children"], Json::array({1, 2, 3}));
  // Columns are the images of x, y and z. Metres; z up becomes y up.
  EXPECT_EQ(json["nodes"][0]["matrix"], Json::array({0.001, 0, 0, 0, 0, 0, -0.001, 0, 0, 0.001, 0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(json["nodes"][1], (Json{{"name", awkward}, {"mesh", 0}}));
  EXPECT_EQ(json["nodes"][2], (Json{{"name", "empty"}}));
  EXPECT_EQ(json["nodes"][3], (Json{{"mesh", 1}}));
  EXPECT_EQ(json["meshes"][0]["name"], awkward);
  EXPECT_EQ(json["buffers"], Json::array({{{"byteLength", file.binary.size()}}}));
  ASSERT_EQ(json["materials"].size(), 2U);
  const auto factor = json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"].get<std::vector<double>>();
  ASSERT_EQ(factor.size(), 4U);
  EXPECT_EQ(factor[0], 1);
  EXPECT_NEAR(factor[1], 0.2158605, 1e-7);  // 128 of 255 by sRGB's curve
  EXPECT_NEAR(factor[2], 10 / 255.0 / 12.92, 1e-12);
  EXPECT_EQ(factor[3], 1);
  EXPECT_FALSE(json["materials"][1]["pbrMetallicRoughness"].contains("baseColorFactor"));
  for (const std::size_t i : {0U, 1U}) {
    const TriangleMesh& mesh = parts[2 * i].mesh;
    const Json& primitive = json["meshes"][i]["primitives"][0];
    EXPECT_EQ(primitive["material"], i);
    EXPECT_EQ(json["materials"][i]["doubleSided"], false);
    const auto places = primitive["attributes"]["POSITION"].get<std::size_t>(),
               corners = primitive["indices"].get<std::size_t>();
    EXPECT_EQ(file.triples<float>(places), mesh.vertices);
    EXPECT_EQ(file.triples<std::uint32_t>(corners), mesh.triangles);
    const Json& accessor = json["accessors"][places];
    EXPECT_EQ(accessor["count"], 4);
    EXPECT_EQ(json["accessors"][corners]["count"], 12);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      float least = mesh.vertices[0][axis], greatest = least;
      for (const auto& p : mesh.vertices) least = std::min(least, p[axis]), greatest = std::max(greatest, p[axis]);
      EXPECT_EQ(accessor["min"][axis].get<float>(), least);
      EXPECT_EQ(accessor["max"][axis].get<float>(), greatest);
    }
  }
}

TEST_F(MeshParts, WithoutTrianglesAreAGlbFileWithoutNumbers) {
  write_mesh(TriangleMesh{}, path("a.glb"));
  const Glb file(read_file(path("a.glb")));
  EXPECT_EQ(file.binary, "");
  EXPECT_FALSE(file.json.contains("meshes"));
  EXPECT_EQ(file.json["nodes"].size(), 2U);
}

TEST_F(MeshParts, OfMoreThanFourGigabytesAreNoGlbFile) {
  TriangleMesh mesh = tetrahedron();
  mesh.triangles.resize(1'000'000);
  const std::vector<PartView> views(400, PartView{mesh});
  PendingFile file(path("a.glb"));
  try {
    write_glb(views, file, path("a.glb"), Progress::none());
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::too_large);
    EXPECT_EQ(error.what(),
              path("a.glb").string() + ": a .glb file holds at most 4 GiB; .3mf and .ply files hold more");
  }
}

TEST_F(MeshParts, ThatAreCancelledHarmNoFile) {
  std::vector<MeshPart> parts(3);
  for (MeshPart& part : parts) {
    part = {tetrahedron(), "a", Colour{1, 2, 3}};
    part.mesh.triangles.resize(100'000, {0, 1, 2});
  }
  for (const std::string& extension : extensions) {
    write_file(path("a" + extension), "old");
    write_file(path("a.mtl"), "old, too");
    const std::set<std::string> before = names_in_folder();
    Progress progress([&](double fraction, const std::string&) {
      EXPECT_LE(fraction, 1);
      if (fraction > 0.3) progress.cancel();
    });
    try {
      write_mesh_parts(parts, path("a" + extension), progress);
      ADD_FAILURE() << extension;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::cancelled) << extension;
    }
    EXPECT_EQ(read_file(path("a" + extension)), "old");
    EXPECT_EQ(read_file(path("a.mtl")), "old, too");
    EXPECT_EQ(names_in_folder(), before) << extension;
  }
}

TEST_F(MeshParts, ThatCannotBeAreRefused) {
  const auto message_of = [](const auto& act) {
    try {
      act();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      return std::string(error.what());
    }
    return std::string("none");
  };
  const MeshPart part{tetrahedron(), "a", {}};
  EXPECT_EQ(message_of([&] { write_mesh_parts({}, path("a.3mf")); }),
            path("a.3mf").string() + ": there is no part to write");
  EXPECT_EQ(message_of([&] {
              write_mesh_parts({&part, 1}, path("a.xyz"));
            }),
            path("a.xyz").string() + ": cannot write a mesh as '.xyz'; known are .stl .ply .off .obj .3mf .glb");
  write_mesh_parts({&part, 1}, path("a.glb"));
  const std::string not_read =
      path("a.glb").string() + ": is written, not read; meshes are read from .stl .ply .off .obj .3mf";
  Notes notes;
  EXPECT_EQ(message_of([&] { (void)load_mesh(path("a.glb")); }), not_read);
  EXPECT_EQ(message_of([&] { (void)load_mesh_parts(path("a.glb"), Progress::none(), notes); }), not_read);
  EXPECT_EQ(message_of([&] { (void)read("<object id=\"1\"></object>", "<item objectid=\"1\"/>", notes); }),
            path("b.3mf").string() + ": holds no triangles");
}

}  // namespace
}  // namespace fieldfab
