// .3mf files of other programs, and malicious ones: only items of the build count, and their size
// is computed first.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <limits>
#include <map>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/mesh/load_mesh.h"
#include "mesh/zip_archive.h"

namespace fieldfab {
namespace {

const std::string core = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
const std::string production = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
const std::string relationships =
    R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="r" )"
    R"(Target="/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>)"
    "</Relationships>";
/// A tetrahedron of volume 1/6.
const std::string tetrahedron =
    R"(<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/>)"
    R"(<vertex x="0" y="0" z="1"/></vertices><triangles><triangle v1="0" v2="2" v3="1"/>)"
    R"(<triangle v1="0" v2="1" v3="3"/><triangle v1="1" v2="2" v3="3"/>)"
    R"(<triangle v1="2" v2="0" v3="3"/></triangles></mesh>)";

std::string object(int id, const std::string& content, const std::string& attributes = "") {
  return fmt::format("<object id=\"{}\" {}>{}</object>", id, attributes, content);
}
std::string components(const std::string& of) { return "<components>" + of + "</components>"; }
std::string component(int id, const std::string& attributes = "") {
  return fmt::format("<component objectid=\"{}\" {}/>", id, attributes);
}
std::string item(int id, const std::string& transform = "1 0 0 0 1 0 0 0 1 0 0 0") {
  return fmt::format("<item objectid=\"{}\" transform=\"{}\"/>", id, transform);
}
std::string model(const std::string& resources, const std::string& build, const std::string& attributes = "") {
  return fmt::format("<model {} xmlns=\"{}\" xmlns:p=\"{}\"><resources>{}</resources><build>{}</build></model>",
                     attributes, core, production, resources, build);
}

class ThreeMf : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write_archive(const std::map<std::string, std::string>& parts) const {
    PendingFile file(path_);
    ZipWriter zip(file);
    for (const auto& [name, text] : parts) zip.add_part(name, text);
    zip.finish();
    file.commit();
  }
  MeshFromFile read(const std::string& text, const std::map<std::string, std::string>& more = {}) const {
    std::map<std::string, std::string> parts = more;
    parts.emplace("_rels/.rels", relationships);
    parts.emplace("3D/3dmodel.model", text);
    write_archive(parts);
    return load_mesh(path_);
  }
  void expect_refused(const std::string& text, ErrorKind kind, const std::string& words,
                      const std::map<std::string, std::string>& more = {}) const {
    try {
      read(text, more);
      ADD_FAILURE() << "read: " << words;
    } catch (const Error& error) {
      const std::string message = error.what();
      EXPECT_EQ(error.kind(), kind) << message;
      EXPECT_NE(message.find(words), std::string::npos) << message << " does not say: " << words;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      EXPECT_NE(message.find(path_.string()), std::string::npos) << message;
    }
  }

  std::filesystem::path folder_ = std::filesystem::temp_directory_path() / fmt::format("fieldfab_3mf_{}", ::getpid());
  std::filesystem::path path_ = folder_ / "a.3mf";
};

TEST_F(ThreeMf, WrittenFilesAreReadToTheLastBitAndAreTheSameEachTime) {
  TriangleMesh mesh;
  for (int i = 0; i < 30'000; ++i) {
    const auto x = static_cast<float>(i);
    mesh.vertices.push_back({0.1F * x, 1 / (x + 3), -1e-7F * x - 1e-30F});
  }
  for (std::uint32_t i = 0; i + 2 < mesh.vertices.size(); ++i) mesh.triangles.push_back({i, i + 1, i + 2});
  mesh.vertices[7] = {std::numeric_limits<float>::max(), std::numeric_limits<float>::denorm_min(), -0.1F};
  write_mesh(mesh, path_);
  const std::string bytes = read_file(path_);
  const MeshFromFile again = load_mesh(path_);
  EXPECT_EQ(again.mesh.vertices, mesh.vertices);
  EXPECT_EQ(again.mesh.triangles, mesh.triangles);
  EXPECT_TRUE(again.notes.empty());
  const ThreadLimit one(1);
  write_mesh(mesh, path_);
  EXPECT_EQ(read_file(path_), bytes);
}

TEST_F(ThreeMf, UnitsAreHonoured) {
  const std::map<std::string, double> units{{"micron", 0.001}, {"millimeter", 1}, {"centimeter", 10},
                                            {"inch", 25.4},    {"foot", 304.8},   {"meter", 1000}};
  for (const auto& [unit, mm] : units) {
    const TriangleMesh mesh =
        read(model(object(1, tetrahedron), item(1, "1 0 0 0 1 0 0 0 1 2 0 0"), "unit=\"" + unit + "\"")).mesh;
    EXPECT_NEAR(mesh.bounds().lower.x(), 2 * mm, 1e-6 * mm) << unit;
    EXPECT_NEAR(mesh.bounds().upper.x(), 3 * mm, 1e-6 * mm) << unit;
    EXPECT_NEAR(mesh.volume(), mm * mm * mm / 6, 1e-6 * mm * mm * mm) << unit;
  }
  EXPECT_NEAR(read(model(object(1, tetrahedron), item(1))).mesh.volume(), 1.0 / 6, 1e-7);
}

TEST_F(ThreeMf, TheBuildIsPlacedAndNothingElse) {
  const MeshFromFile read_once = read(model(object(1, tetrahedron) + object(2, tetrahedron), item(2)));
  EXPECT_EQ(read_once.mesh.triangles.size(), 4U);
  ASSERT_EQ(read_once.notes.size(), 1U);
  EXPECT_EQ(read_once.notes[0], "a.3mf: left out: 1 object that the build does not place");
  const MeshFromFile twice = read(model(object(1, tetrahedron), item(1) + item(1, "1 0 0 0 1 0 0 0 1 5 6 7")));
  EXPECT_EQ(twice.mesh.triangles.size(), 8U);
  EXPECT_EQ(twice.mesh.bounds().upper, Vec3(6, 7, 8));
  EXPECT_TRUE(twice.notes.empty());
}

/// Inner transforms apply first: rows are images of the axes.
TEST_F(ThreeMf, ComponentsAreTransformedFromWithin) {
  // x to y, y to -x; then 10 along x
  const std::string turned = "transform=\"0 1 0 -1 0 0 0 0 1 10 0 0\"";
  const std::string moved = "1 0 0 0 1 0 0 0 2 0 100 0";  // z doubled; then 100 along y
  const TriangleMesh mesh = read(model(object(1, tetrahedron) + object(2, components(component(1, turned))) +
                                           object(3, components(component(2))),
                                       item(3, moved)))
                                .mesh;
  EXPECT_EQ(mesh.bounds().lower, Vec3(9, 100, 0));
  EXPECT_EQ(mesh.bounds().upper, Vec3(10, 101, 2));
  EXPECT_NEAR(mesh.volume(), 2.0 / 6, 1e-6);
}

TEST_F(ThreeMf, MirroredObjectsKeepTheirVolume) {
  const std::string mirrored = "transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"";
  EXPECT_NEAR(read(model(object(1, tetrahedron), item(1, "1 0 0 0 1 0 0 0 -1 0 0 0"))).mesh.volume(), 1.0 / 6, 1e-7);
  EXPECT_NEAR(
      read(model(object(1, tetrahedron) + object(2, components(component(1, mirrored))), item(2))).mesh.volume(),
      1.0 / 6, 1e-7);
  EXPECT_NEAR(read(model(object(1, tetrahedron) + object(2, components(component(1, mirrored))),
                         item(2, "-1 0 0 0 1 0 0 0 1 0 0 0")))
                  .mesh.volume(),
              1.0 / 6, 1e-7);
}

TEST_F(ThreeMf, OnlyModelsAreSolids) {
  for (const std::string type : {"support", "solidsupport", "surface", "other"}) {
    const std::string other = object(2, tetrahedron, "type=\"" + type + "\"");
    // The type of an object with components is that of the components.
    const std::string both = object(3, components(component(1) + component(2)), "type=\"" + type + "\"");
    const MeshFromFile file = read(model(object(1, tetrahedron, "type=\"model\"") + other + both, item(3)));
    EXPECT_EQ(file.mesh.triangles.size(), 4U) << type;
    ASSERT_EQ(file.notes.size(), 1U);
    EXPECT_EQ(file.notes[0], "a.3mf: left out: 1 object of another type than 'model'");
    expect_refused(model(other, item(2)), ErrorKind::bad_input, "places no object of type 'model'");
  }
  expect_refused(model(object(1, tetrahedron, "type=\"gear\""), item(1)), ErrorKind::bad_input,
                 "of type 'gear'; known are model");
}

TEST_F(ThreeMf, OtherPartsOfTheFileAreRead) {
  const std::string other = model(object(7, tetrahedron), "", "unit=\"inch\"");
  const std::string outside = component(7, "p:path=\"/3D/Other.model\" transform=\"1 0 0 0 1 0 0 0 1 3 0 0\"");
  const MeshFromFile file =
      read(model(object(1, components(outside)), item(1), "unit=\"centimeter\" requiredextensions=\"p\""),
           {{"3D/other.model", other}});
  EXPECT_NEAR(file.mesh.bounds().lower.x(), 30, 1e-5);
  EXPECT_NEAR(file.mesh.volume(), 25.4 * 25.4 * 25.4 / 6, 1e-2);
  EXPECT_TRUE(file.notes.empty());
  expect_refused(model(object(1, components(outside)), item(1)), ErrorKind::bad_input, "has no part '3D/Other.model'");
}

TEST_F(ThreeMf, NamespacesAreResolvedWhateverTheirPrefix) {
  std::string text = model(object(1, tetrahedron), item(1));
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos; ++at)
    text.insert(text[at + 1] == '/' ? at + 2 : at + 1, "m:");
  text.replace(text.find("xmlns="), 6, "xmlns:m=");
  EXPECT_EQ(read(text).mesh.triangles.size(), 4U);
  // Elements of the same names in another namespace are unrelated.
  const std::string foreign = "<triangle xmlns=\"http://example.com/mine\" v1=\"9\" v2=\"9\" v3=\"9\"/></triangles>";
  std::string mixed = model(object(1, tetrahedron), item(1));
  mixed.replace(mixed.find("</triangles>"), 12, foreign);
  const MeshFromFile file = read(mixed);
  EXPECT_EQ(file.mesh.triangles.size(), 4U);
  ASSERT_EQ(file.notes.size(), 1U);
  EXPECT_EQ(file.notes[0], "a.3mf: left out: elements of 'http://example.com/mine'");
}

TEST_F(ThreeMf, WhatIsLeftOutIsTold) {
  const std::string colours = "<basematerials id=\"9\"><base name=\"red\" displaycolor=\"#FF0000\"/></basematerials>";
  const std::string beams =
      "<b:beamlattice xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\"/></mesh>";
  std::string with_beams = tetrahedron;
  with_beams.replace(with_beams.find("</mesh>"), 7, beams);
  const MeshFromFile file = read(model(
      colours + "<s:slicestack xmlns:s=\"http://schemas.microsoft.com/3dmanufacturing/slice/2015/07\" id=\"4\"/>" +
          object(1, with_beams, "name=\"knob\" pid=\"9\" pindex=\"0\""),
      item(1)));
  ASSERT_EQ(file.notes.size(), 1U);
  EXPECT_EQ(file.notes[0], "a.3mf: left out: beam lattices, colours and materials, names of objects, slices");
  EXPECT_TRUE(
      read("<?xml version=\"1.0\"?>" + model(object(1, tetrahedron), item(1), "xml:lang=\"en\"")).notes.empty());
  expect_refused(
      model(object(1, tetrahedron), item(1), "requiredextensions=\"p x\" xmlns:x=\"http://example.com/sealed\""),
      ErrorKind::bad_input, "requires the extension 'http://example.com/sealed'");
}

TEST_F(ThreeMf, NumbersMayStandAsXmlAllows) {
  for (const std::string z : {"1", " 1\n", "+1", "1e0", "1.", "0.1E+1"}) {
    std::string text = model(object(1, tetrahedron), item(1));
    text.replace(text.find("z=\"1\""), 5, "z=\"" + z + "\"");
    EXPECT_EQ(read(text).mesh.bounds().upper.z(), 1) << z;
  }
  for (const std::string z : {"nan", "inf", "-inf", "1e400", "0x1", "", " ", "1,5", "1 2"}) {
    std::string text = model(object(1, tetrahedron), item(1));
    text.replace(text.find("z=\"1\""), 5, "z=\"" + z + "\"");
    expect_refused(text, ErrorKind::bad_input, "a.3mf/3D/3dmodel.model:1: expected a number, found '");
  }
  std::string far = model(object(1, tetrahedron), item(1));
  far.replace(far.find("z=\"1\""), 5, "z=\"1e39\"");
  expect_refused(far, ErrorKind::bad_input, "a vertex is not a finite number");
}

TEST_F(ThreeMf, DamageIsOneClearLine) {
  const auto replaced = [](std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  };
  const std::string good = model(object(1, tetrahedron), item(1));
  const std::vector<std::pair<std::string, std::string>> cases{
      {replaced(good, "v3=\"3\"", "v3=\"4\""), "triangle of vertices 0, 1 and 4 in an object of 4 vertices"},
      {replaced(good, "v3=\"3\"", "v3=\"-1\""), "expected a whole number below 2^31, found '-1'"},
      {replaced(good, "v3=\"3\"", "v3=\"4294967299\""), "expected a whole number below 2^31"},
      {replaced(good, "z=\"1\"", ""), "has a vertex without 'z'"},
      {replaced(good, "v3=\"3\"", ""), "has a triangle without 'v3'"},
      {replaced(good, "id=\"1\"", ""), "has an object without 'id'"},
      {replaced(good, "objectid=\"1\"", ""), "has an item without 'objectid'"},
      {replaced(good, "objectid=\"1\"", "objectid=\"2\""), "refers to an object 2 that is not there"},
      {replaced(good, "1 0 0 0 1 0 0 0 1 0 0 0", "1 0 0 0 1 0 0 0 1 0 0"),
       "expected the twelve numbers of a transform"},
      {replaced(good, "1 0 0 0 1 0 0 0 1 0 0 0", "1 0 0 0 1 0 0 0 1 0 0 0 0"), "more than twelve numbers"},
      {replaced(good, "1 0 0 0 1 0 0 0 1 0 0 0", "1 0 0 0 1 0 0 0 0 0 0 0"), "flattens object 1"},
      {replaced(good, "<model ", "<model unit=\"parsec\" "), "has the unit 'parsec'; known are micron"},
      {model(object(1, tetrahedron) + object(1, tetrahedron), item(1)), "two objects with the id 1"},
      {model(object(1, tetrahedron), ""), "its build has no item"},
      {model(object(1, ""), item(1)), "holds no triangles"},
      {model(object(1, components(component(1))), item(1)), "object 1 that is a component of itself"},
      {model(object(1, components(component(2))) + object(2, components(component(1))), item(2)),
       "is a component of itself"},
      {"<!DOCTYPE a [<!ENTITY b \"bbbb\"><!ENTITY c \"&b;&b;\">]>" + good, "document type declaration"},
      {good.substr(0, good.size() - 9), "3dmodel.model:1: "},
      {"<model><x:y/></model>", "unbound prefix"},
      {"<wrong/>", "begins with the element 'wrong' instead of 'model'"},
      {"", "no element found"},
      {model(object(1, tetrahedron) + "<!--" + std::string(3 << 20, 'x') + "-->", item(1)), "longer than 1 MiB"},
      {good + std::string(200, ' ') + "<again/>", "junk after document element"}};
  for (const auto& [text, words] : cases) expect_refused(text, ErrorKind::bad_input, words);
  std::string deep = good;
  for (int i = 0; i < 200; ++i) deep.insert(deep.find("<resources>"), "<a>");
  expect_refused(deep, ErrorKind::bad_input, "more than 100 elements within each other");
}

TEST_F(ThreeMf, ArchivesThatAreDamagedAreRefused) {
  write_file(path_, "not an archive");
  EXPECT_THROW(load_mesh(path_), Error);
  write_archive({{"3D/3dmodel.model", model(object(1, tetrahedron), item(1))}});
  EXPECT_THROW(load_mesh(path_), Error);  // no relationships
  write_archive({{"_rels/.rels", "<Relationships/>"}});
  EXPECT_THROW(load_mesh(path_), Error);
  ASSERT_EQ(read(model(object(1, tetrahedron), item(1))).mesh.triangles.size(), 4U);
  const std::string whole = read_file(path_);
  for (std::size_t cut = 0; cut < whole.size(); cut += 7) {
    write_file(path_, whole.substr(0, cut));
    EXPECT_THROW(load_mesh(path_), Error) << cut;
  }
  // Flips any bit: an Error, or the same mesh if the bit has no meaning.
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string bytes = whole;
    bytes[i] = static_cast<char>(bytes[i] ^ 1 << i % 8);
    write_file(path_, bytes);
    try {
      EXPECT_EQ(load_mesh(path_).mesh.triangles.size(), 4U) << i;
    } catch (const Error& error) {
      EXPECT_NE(error.kind(), ErrorKind::internal) << error.what();
    }
  }
}

/// Usually tenths of a second; seconds under sanitizers.
template <class Act>
void expect_soon(const Act& act) {
  const auto start = std::chrono::steady_clock::now();
  act();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST_F(ThreeMf, BombsAreCountedAndRefusedAtOnce) {
  // Each object contains ten of the previous one: 4 * 10^10 triangles in 3 kB, and 10^10 empty
  // objects.
  for (const bool empty : {false, true}) {
    std::string resources = object(1, empty ? "" : tetrahedron);
    for (int id = 2; id <= 11; ++id) {
      std::string ten;
      for (int i = 0; i < 10; ++i) ten += component(id - 1);
      resources += object(id, components(ten));
    }
    expect_soon([&] {
      if (empty)
        expect_refused(model(resources, item(11)), ErrorKind::bad_input, "holds no triangles");
      else
        expect_refused(model(resources, item(11)), ErrorKind::too_large, "more than 2147483647 triangles or vertices");
    });
  }
  // More than the memory holds, or than can be traversed in reasonable time.
  std::string doubled = object(1, tetrahedron);
  for (int id = 2; id <= 28; ++id) doubled += object(id, components(component(id - 1) + component(id - 1)));
  expect_soon(
      [&] { expect_refused(model(doubled, item(28)), ErrorKind::too_large, "places more than 100000000 components"); });
  // A part that inflates to 300 times its size.
  std::string text = model(object(1, tetrahedron), item(1));
  text.insert(text.find("<resources>"), std::string(std::size_t{100} << 20, ' '));
  expect_soon([&] { expect_refused(text, ErrorKind::too_large, "would inflate to more than 67108864 bytes"); });
}

TEST_F(ThreeMf, AChainOfManyComponentsIsRead) {
  constexpr int many = 100'000;
  std::string resources = object(1, tetrahedron);
  for (int id = 2; id <= many; ++id) resources += object(id, components(component(id - 1)));
  expect_soon([&] { EXPECT_EQ(read(model(resources, item(many))).mesh.triangles.size(), 4U); });
}

TEST_F(ThreeMf, ReadingStopsWhenTold) {
  std::string resources = object(1, tetrahedron);
  for (int id = 2; id <= 7; ++id) {
    std::string ten;
    for (int i = 0; i < 10; ++i) ten += component(id - 1);
    resources += object(id, components(ten));
  }
  ASSERT_EQ(read(model(resources, item(4))).mesh.triangles.size(), 4000U);
  write_archive({{"_rels/.rels", relationships}, {"3D/3dmodel.model", model(resources, item(7))}});
  for (const double reached : {0.0, 0.1, 0.4}) {
    Progress* told = nullptr;
    Progress progress([&](double fraction, const std::string&) {
      if (fraction >= reached) told->cancel();
    });
    told = &progress;
    try {
      load_mesh(path_, progress);
      ADD_FAILURE() << "not cancelled at " << reached;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::cancelled);
    }
  }
}

TEST_F(ThreeMf, LargePartsHaveSizesOf64Bits) {
  PendingFile file(path_);
  ZipWriter zip(file);
  zip.add_part("_rels/.rels", relationships);
  zip.begin("3D/3dmodel.model", std::uint64_t{1} << 33);
  zip.add(deflated(model(object(1, tetrahedron), item(1))));
  zip.end();
  zip.finish();
  file.commit();
  // the directory's field of 24 bytes
  EXPECT_NE(read_file(path_).find(std::string("\x01\x00\x18\x00", 4)), std::string::npos);
  EXPECT_EQ(load_mesh(path_).mesh.triangles.size(), 4U);
}

}  // namespace
}  // namespace fieldfab
