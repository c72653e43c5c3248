#include "three_mf_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "fieldfab/core/error.h"
#include "fieldfab/core/text.h"
#include "xml_reader.h"

namespace fieldfab {
namespace {

constexpr std::string_view production = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06",
                           path_attribute = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06 path",
                           materials = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
                           slices = "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07",
                           beams = "http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02",
                           triangle_sets = "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07";

[[noreturn]] void fail(const std::string& how) { throw Error(ErrorKind::bad_input, "", how); }

/// Words of an attribute's list, separated by white space.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}
  std::string_view next() {
    constexpr std::string_view space = " \t\r\n";
    text_.remove_prefix(std::min(text_.find_first_not_of(space), text_.size()));
    const std::string_view word = text_.substr(0, text_.find_first_of(space));
    text_.remove_prefix(word.size());
    return word;
  }

 private:
  std::string_view text_;
};

/// Returns an attribute's value without surrounding white space.
std::string_view trimmed(std::string_view text) {
  constexpr std::string_view space = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(space), text.size()));
  return text.substr(0, text.find_last_not_of(space) + 1);
}

double number(std::string_view word) {
  std::string_view digits = word;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double value = 0;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (failure != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value))
    fail(fmt::format("expected a number, found '{:.40}'", printable(word)));
  return value;
}

std::optional<std::uint32_t> whole_number_or_none(std::string_view text) {
  const std::string_view word = trimmed(text);
  std::uint32_t value = 0;
  const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (failure != std::errc{} || end != word.data() + word.size() || value > 0x7fffffff) return std::nullopt;
  return value;
}

std::uint32_t whole_number(std::string_view text) {
  const auto value = whole_number_or_none(text);
  if (!value) fail(fmt::format("expected a whole number below 2^31, found '{:.40}'", printable(text)));
  return *value;
}

ThreeMfTransform transform_of(std::string_view text) {
  ThreeMfTransform transform;
  Words words(text);
  for (double& value : transform) {
    const std::string_view word = words.next();
    if (word.empty()) fail(fmt::format("expected the twelve numbers of a transform, found '{:.100}'", printable(text)));
    value = number(word);
  }
  if (!words.next().empty()) fail("has a transform of more than twelve numbers");
  return transform;
}

double unit_of(std::string_view name) {
  if (name == "micron") return 0.001;
  if (name == "millimeter") return 1;
  if (name == "centimeter") return 10;
  if (name == "inch") return 25.4;
  if (name == "foot") return 304.8;
  if (name == "meter") return 1000;
  fail(fmt::format("has the unit '{:.40}'; known are micron, millimeter, centimeter, inch, foot and meter",
                   printable(name)));
}

class ModelReader final : public XmlHandler {
 public:
  ModelReader(ThreeMfModel& model, ThreeMfBudget& budget) : model_(model), budget_(budget) {}

  void declare(std::string_view prefix, std::string_view uri) override {
    if (open_.empty()) prefixes_[std::string(prefix)] = uri;
  }

  void begin(std::string_view uri, std::string_view name, const XmlAttributes& attributes) override {
    if (open_.empty()) core_ = uri;
    const Element parent = open_.empty() ? Element::none : open_.back();
    const Element element = uri == core_ ? element_of(parent, name) : Element::other;
    open_.push_back(element);
    switch (element) {
      case Element::none: fail(fmt::format("begins with the element '{:.40}' instead of 'model'", printable(name)));
      case Element::model: begin_model(attributes); break;
      case Element::object: begin_object(attributes); break;
      case Element::vertex: add_vertex(attributes); break;
      case Element::triangle: add_triangle(attributes); break;
      case Element::component: object_->components.push_back(reference_of(attributes)); break;
      case Element::item: add_item(attributes); break;
      case Element::base_materials: begin_base_materials(attributes); break;
      case Element::base: add_base(attributes); break;
      case Element::other:
        if (parent != Element::other) leave_out(uri);
        break;
      default: break;
    }
  }

  void end() override {
    if (open_.back() == Element::object) end_object();
    open_.pop_back();
  }

 private:
  enum class Element : std::uint8_t {
    none,
    model,
    resources,
    object,
    mesh,
    vertices,
    vertex,
    triangles,
    triangle,
    components,
    component,
    build,
    item,
    base_materials,
    base,
    other
  };

  static Element element_of(Element parent, std::string_view name) {
    struct Place {
      Element parent;
      std::string_view name;
      Element element;
    };
    // The most frequent first.
    static constexpr std::array<Place, 14> places{{{Element::triangles, "triangle", Element::triangle},
                                                   {Element::vertices, "vertex", Element::vertex},
                                                   {Element::components, "component", Element::component},
                                                   {Element::build, "item", Element::item},
                                                   {Element::resources, "object", Element::object},
                                                   {Element::object, "mesh", Element::mesh},
                                                   {Element::object, "components", Element::components},
                                                   {Element::mesh, "vertices", Element::vertices},
                                                   {Element::mesh, "triangles", Element::triangles},
                                                   {Element::none, "model", Element::model},
                                                   {Element::model, "resources", Element::resources},
                                                   {Element::model, "build", Element::build},
                                                   {Element::resources, "basematerials", Element::base_materials},
                                                   {Element::base_materials, "base", Element::base}}};
    for (const Place& place : places)
      if (place.parent == parent && place.name == name) return place.element;
    return parent == Element::none ? Element::none : Element::other;
  }

  void leave_out(std::string_view uri) {
    if (uri == core_) return;  // metadata
    if (uri == materials)
      model_.has_colours = model_.has_other_colours = true;
    else if (uri == slices)
      model_.left_out.insert("slices");
    else if (uri.starts_with(beams.substr(0, beams.rfind('/'))))
      model_.left_out.insert("beam lattices");
    else if (uri != triangle_sets && model_.left_out.size() < 20)
      model_.left_out.insert(fmt::format("elements of '{:.100}'", printable(uri)));
  }

  void begin_model(const XmlAttributes& attributes) {
    if (const auto unit = attributes.find("unit")) model_.unit = unit_of(trimmed(*unit));
    Words required(attributes.find("requiredextensions").value_or(""));
    for (std::string_view prefix = required.next(); !prefix.empty(); prefix = required.next()) {
      const auto at = prefixes_.find(std::string(prefix));
      const std::string uri = at == prefixes_.end() ? std::string(prefix) : at->second;
      constexpr std::array known{production, materials, slices, beams, triangle_sets};
      if (std::find(known.begin(), known.end(), uri) == known.end())
        fail(fmt::format("requires the extension '{:.100}', which is not read", printable(uri)));
    }
  }

  void begin_object(const XmlAttributes& attributes) {
    if (budget_.objects-- == 0)
      throw Error(ErrorKind::too_large, "", "has more than 2^20 objects and groups of materials");
    const std::uint32_t id = whole_number(needed(attributes, "id", "an object"));
    const auto [at, is_new] = model_.objects.try_emplace(id);
    if (!is_new) fail(fmt::format("has two objects with the id {}", id));
    object_ = &at->second;
    if (const auto type = attributes.find("type")) {
      constexpr std::array known{"model", "solidsupport", "support", "surface", "other"};
      if (std::find(known.begin(), known.end(), *type) == known.end())
        fail(fmt::format("has an object of type '{:.40}'; known are model, solidsupport, support, surface and other",
                         printable(*type)));
      object_->printed = *type == "model";
    }
    if (const auto name = attributes.find("name")) {
      object_->name = name_of(*name);
      model_.has_names = true;
    }
    if (const auto group = attributes.find("pid")) {
      // An object whose colour is missing is still a solid.
      const auto number = whole_number_or_none(*group);
      const auto index = whole_number_or_none(attributes.find("pindex").value_or("0"));
      if (number && index) object_->property = {*number, *index};
      model_.has_colours = true;
    }
  }

  void begin_base_materials(const XmlAttributes& attributes) {
    if (budget_.objects-- == 0)
      throw Error(ErrorKind::too_large, "", "has more than 2^20 objects and groups of materials");
    // A group without a valid number gets one that no object refers to.
    materials_ = &model_.base_materials[whole_number_or_none(attributes.find("id").value_or("")).value_or(0xffffffff)];
    model_.has_colours = true;
  }

  void add_base(const XmlAttributes& attributes) {
    require_room(*materials_);
    constexpr std::size_t opaque = std::string_view("#rrggbb").size(), with_opacity = opaque + 2;
    std::string_view text = trimmed(attributes.find("displaycolor").value_or(""));
    if (text.size() == with_opacity) {
      if (text.substr(opaque) != "FF" && text.substr(opaque) != "ff") model_.has_other_colours = true;
      text = text.substr(0, opaque);
    }
    materials_->push_back(text.size() == opaque ? colour_of_hex(text) : std::nullopt);
  }

  std::string name_of(std::string_view text) {
    if (text.size() > budget_.letters) throw Error(ErrorKind::too_large, "", "has more than 256 MiB of names");
    budget_.letters -= text.size();
    return printable(text);
  }

  void add_item(const XmlAttributes& attributes) {
    const ThreeMfReference reference = reference_of(attributes);
    model_.build.push_back({reference, name_of(attributes.find("partnumber").value_or(""))});
  }

  /// In rare files vertices follow triangles; so indices are checked once both are read.
  void end_object() const {
    for (const auto& triangle : object_->triangles)
      if (std::max({triangle[0], triangle[1], triangle[2]}) >= object_->vertices.size())
        fail(fmt::format("has a triangle of vertices {}, {} and {} in an object of {} vertices", triangle[0],
                         triangle[1], triangle[2], object_->vertices.size()));
  }

  static std::string_view needed(const XmlAttributes& attributes, const char* name, const char* what) {
    const auto value = attributes.find(name);
    if (!value) fail(fmt::format("has {} without '{}'", what, name));
    return *value;
  }

  template <class Items>
  void require_room(const Items& items) const {
    constexpr std::size_t often = std::size_t{1} << 20;
    if (items.size() % often == often - 1) require_memory(2 * items.size() * sizeof items[0], "the mesh");
  }

  void add_vertex(const XmlAttributes& attributes) {
    require_room(object_->vertices);
    std::array<double, 3> place;
    constexpr std::array names{"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i) place[i] = number(trimmed(needed(attributes, names[i], "a vertex")));
    object_->vertices.push_back(place);
  }

  void add_triangle(const XmlAttributes& attributes) {
    require_room(object_->triangles);
    std::array<std::uint32_t, 3> corners;
    constexpr std::array names{"v1", "v2", "v3"};
    for (std::size_t i = 0; i < 3; ++i) corners[i] = whole_number(needed(attributes, names[i], "a triangle"));
    if (attributes.find("pid") || attributes.find("p1")) model_.has_colours = model_.has_other_colours = true;
    object_->triangles.push_back(corners);
  }

  ThreeMfReference reference_of(const XmlAttributes& attributes) {
    if (budget_.references-- == 0) throw Error(ErrorKind::too_large, "", "has more than 2^22 components and items");
    ThreeMfReference reference;
    reference.object =
        whole_number(needed(attributes, "objectid", open_.back() == Element::item ? "an item" : "a component"));
    if (const auto transform = attributes.find("transform")) reference.transform = transform_of(*transform);
    if (const auto path = attributes.find(path_attribute)) {
      const auto [at, is_new] =
          path_numbers_.try_emplace(std::string(*path), static_cast<std::uint32_t>(model_.paths.size() + 1));
      if (is_new) model_.paths.emplace_back(*path);
      reference.part = at->second;
    }
    return reference;
  }

  ThreeMfModel& model_;
  ThreeMfBudget& budget_;
  std::string core_;  ///< namespace of the root element
  std::unordered_map<std::string, std::string> prefixes_;
  std::unordered_map<std::string, std::uint32_t> path_numbers_;
  std::vector<Element> open_;
  ThreeMfObject* object_ = nullptr;
  std::vector<std::optional<Colour>>* materials_ = nullptr;
};

/// Finds the relationship of the package to its model.
class RelationshipReader final : public XmlHandler {
 public:
  void begin(std::string_view, std::string_view name, const XmlAttributes& attributes) override {
    if (name != "Relationship" || !target.empty()) return;
    if (attributes.find("Type") != "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel") return;
    target = attributes.find("Target").value_or("");
  }
  void end() override {}
  std::string target;
};

}  // namespace

ThreeMfModel read_three_mf_model(const ZipReader& zip, const std::string& part, const std::filesystem::path& path,
                                 ThreeMfBudget& budget, Progress& progress) {
  ThreeMfModel model;
  ModelReader reader(model, budget);
  read_xml(zip, part, path, reader, progress);
  return model;
}

std::string first_model_part(const ZipReader& zip, const std::filesystem::path& path, Progress& progress) {
  RelationshipReader reader;
  read_xml(zip, "_rels/.rels", path, reader, progress);
  if (reader.target.empty()) throw Error(ErrorKind::bad_input, path.string(), "names no 3D model in _rels/.rels");
  return reader.target;
}

}  // namespace fieldfab
