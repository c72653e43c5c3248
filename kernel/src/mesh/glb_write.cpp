// glTF 2.0, binary. Our own writer, since tinygltf keeps all numbers in memory, and copies them
// once more to write them.
#include <cmath>
#include <nlohmann/json.hpp>

#include "fieldfab/core/error.h"
#include "fieldfab/core/text.h"
#include "mesh_file.h"

namespace fieldfab {
namespace {

using Json = nlohmann::ordered_json;

// Constants of the specification.
constexpr std::uint32_t magic = 0x46546c67, version = 2, json_chunk = 0x4e4f534a, binary_chunk = 0x004e4942;
constexpr int float_component = 5126, unsigned_int_component = 5125, vertex_buffer = 34962, index_buffer = 34963,
              triangles_mode = 4;

/// Converts a channel of sRGB (0 to 255) to linear light (0 to 1): IEC 61966-2-1.
double linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

Json material_of(const PartView& part) {
  Json material = Json::object();
  if (part.colour) material["name"] = text_of(*part.colour);
  Json& surface = material["pbrMetallicRoughness"] = Json::object();
  if (part.colour)
    surface["baseColorFactor"] = {linear(part.colour->red), linear(part.colour->green), linear(part.colour->blue), 1};
  surface["metallicFactor"] = 0;  // the default, 1, is a dark mirror in most viewers
  surface["roughnessFactor"] = 0.6;
  material["doubleSided"] = false;
  return material;
}

Json numbers_of(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// The JSON chunk, which describes the binary one: the vertices of each part, then its triangles.
class Description {
 public:
  explicit Description(std::span<const PartView> parts) {
    Json children = Json::array();
    for (std::size_t i = 1; i <= parts.size(); ++i) children.push_back(i);
    // glTF uses metres and y up. Vertices stay in mm with z up, to the last bit; the root node
    // rotates and scales them.
    nodes_.push_back({{"name", "Fieldfab"},
                      {"children", children},
                      {"matrix", {0.001, 0, 0, 0, 0, 0, -0.001, 0, 0, 0.001, 0, 0, 0, 0, 0, 1}}});
    for (const PartView& part : parts) add(part);
  }

  [[nodiscard]] std::string text() const {
    Json all{{"asset", {{"version", "2.0"}, {"generator", "Fieldfab"}}},
             {"scene", 0},
             {"scenes", Json::array({{{"nodes", Json::array({0})}}})},
             {"nodes", nodes_}};
    if (!meshes_.empty())
      all.update({{"meshes", meshes_},
                  {"materials", materials_},
                  {"accessors", accessors_},
                  {"bufferViews", views_},
                  {"buffers", Json::array({{{"byteLength", bytes_}}})}});
    std::string text = all.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    return text;
  }

 private:
  void add(const PartView& part) {
    Json node = Json::object();
    if (!part.name.empty()) node["name"] = printable(part.name);
    if (!part.mesh.triangles.empty()) {  // glTF does not permit empty meshes
      node["mesh"] = meshes_.size();
      const Box bounds = part.mesh.bounds();
      const std::size_t places = add_accessor(12 * part.mesh.vertices.size(), vertex_buffer,
                                              {{"componentType", float_component},
                                               {"count", part.mesh.vertices.size()},
                                               {"type", "VEC3"},
                                               {"min", numbers_of(bounds.lower)},
                                               {"max", numbers_of(bounds.upper)}});
      const std::size_t corners = add_accessor(
          12 * part.mesh.triangles.size(), index_buffer,
          {{"componentType", unsigned_int_component}, {"count", 3 * part.mesh.triangles.size()}, {"type", "SCALAR"}});
      Json mesh = Json::object();
      if (!part.name.empty()) mesh["name"] = node["name"];
      mesh["primitives"] = Json::array({{{"attributes", {{"POSITION", places}}},
                                         {"indices", corners},
                                         {"material", materials_.size()},
                                         {"mode", triangles_mode}}});
      meshes_.push_back(std::move(mesh));
      materials_.push_back(material_of(part));
    }
    nodes_.push_back(std::move(node));
  }

  /// Adds an accessor for the next bytes; returns its number.
  std::size_t add_accessor(std::uint64_t bytes, int target, const Json& described) {
    Json accessor{{"bufferView", views_.size()}};
    accessor.update(described);
    views_.push_back({{"buffer", 0}, {"byteOffset", bytes_}, {"byteLength", bytes}, {"target", target}});
    accessors_.push_back(std::move(accessor));
    bytes_ += bytes;
    return accessors_.size() - 1;
  }

  Json nodes_ = Json::array(), meshes_ = Json::array(), materials_ = Json::array(), accessors_ = Json::array(),
       views_ = Json::array();
  std::uint64_t bytes_ = 0;
};

void write_words(PendingFile& file, std::initializer_list<std::uint64_t> words) {
  for (const std::uint64_t word : words) {
    const auto narrow = static_cast<std::uint32_t>(word);
    file.write(&narrow, sizeof narrow);
  }
}

}  // namespace

void write_glb(std::span<const PartView> parts, PendingFile& file, const std::filesystem::path& path,
               Progress& progress) {
  std::uint64_t items = 0;
  for (const PartView& part : parts)
    if (!part.mesh.triangles.empty()) items += part.mesh.vertices.size() + part.mesh.triangles.size();
  const std::string json = Description(parts).text();
  const std::uint64_t binary = 12 * items, total = 12 + 8 + json.size() + (binary > 0 ? 8 + binary : 0);
  if (total > 0xffffffff)
    throw Error(ErrorKind::too_large, path.string(), "a .glb file holds at most 4 GiB; .3mf and .ply files hold more");
  write_words(file, {magic, version, total, json.size(), json_chunk});
  file.write(json);
  if (binary > 0) write_words(file, {binary, binary_chunk});
  WritingProgress written(progress, items);
  const auto write_each = [&](const auto& triples) {
    for (const auto& triple : triples) {
      static_assert(sizeof triple == 12);
      written.step();
      file.write(triple.data(), sizeof triple);
    }
  };
  for (const PartView& part : parts) {
    if (part.mesh.triangles.empty()) continue;
    write_each(part.mesh.vertices);
    write_each(part.mesh.triangles);
  }
}

}  // namespace fieldfab
