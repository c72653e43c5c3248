#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "fieldfab/core/parallel.h"
#include "fieldfab/core/text.h"
#include "mesh_file.h"
#include "zip_archive.h"

namespace fieldfab {
namespace {

constexpr std::string_view content_types =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";
constexpr std::string_view relationships =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";
constexpr std::string_view model_begins =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<metadata name="Application">Fieldfab</metadata>
<resources>
)";

/// Returns text as the value of an attribute, valid in XML 1.0.
std::string attribute(std::string_view text) {
  std::string value;
  for (const char c : printable(text)) {
    if (c == '&')
      value += "&amp;";
    else if (c == '<')
      value += "&lt;";
    else if (c == '>')
      value += "&gt;";
    else if (c == '"')
      value += "&quot;";
    else
      value += c;
  }
  // U+FFFE and U+FFFF are not characters in XML.
  for (std::size_t at = 0; (at = value.find("\xEF\xBF", at)) != std::string::npos; at += 3)
    if (const auto last = static_cast<unsigned char>(value[at + 2]); last >= 0xBE)
      value[at + 2] = static_cast<char>(0xBD);
  return value;
}

/// Writes a .3mf file: the colours, then the objects one after the other, then the build, which
/// places each of them once.
class ThreeMfWriter {
 public:
  ThreeMfWriter(std::span<const PartView> parts, PendingFile& file, Progress& progress)
      : parts_(parts), zip_(file), progress_(progress) {}

  void write() {
    std::uint64_t most = 4096;
    for (const PartView& part : parts_) most += most_text_of(part);
    zip_.add_part("[Content_Types].xml", content_types);
    zip_.add_part("_rels/.rels", relationships);
    zip_.begin("3D/3dmodel.model", most);
    add(model_begins);
    add_colours();
    for (std::size_t i = 0; i < parts_.size(); ++i) add_object(i);
    finish();
  }

 private:
  static std::uint64_t most_text_of(const PartView& part) {
    // A number has at most 24 characters, an index 10; a character of a name becomes at most six.
    constexpr std::uint64_t vertex = 24 + 3 * 24, triangle = 30 + 3 * 10, object = 1024, letter = 6;
    return vertex * part.mesh.vertices.size() + triangle * part.mesh.triangles.size() + object +
           letter * part.name.size();
  }

  [[nodiscard]] std::size_t colours_id() const { return parts_.size() + 1; }

  /// Writes each colour once, before the objects that refer to it.
  void add_colours() {
    std::string text;
    for (const PartView& part : parts_)
      if (part.colour && places_.try_emplace(text_of(*part.colour), places_.size()).second)
        text += fmt::format("<base name=\"{0}\" displaycolor=\"{0}\"/>\n", text_of(*part.colour));
    if (!text.empty()) add(fmt::format("<basematerials id=\"{}\">\n{}</basematerials>\n", colours_id(), text));
  }

  void add_object(std::size_t number) {
    const auto& [mesh, name, colour] = parts_[number];
    std::string described = "type=\"model\"";
    if (!name.empty()) described += fmt::format(" name=\"{}\"", attribute(name));
    if (colour) described += fmt::format(" pid=\"{}\" pindex=\"{}\"", colours_id(), places_.at(text_of(*colour)));
    add(fmt::format("<object id=\"{}\" {}>\n<mesh>\n<vertices>\n", number + 1, described));
    const auto from = static_cast<double>(number);
    // The digits are those of the float as a double: see mesh_write.cpp.
    add_lines(mesh.vertices, from, [](const std::array<float, 3>& p, fmt::memory_buffer& text) {
      fmt::format_to(std::back_inserter(text), FMT_COMPILE("<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n"), double{p[0]},
                     double{p[1]}, double{p[2]});
    });
    add("</vertices>\n<triangles>\n");
    add_lines(mesh.triangles, from + 0.5, [](const std::array<std::uint32_t, 3>& t, fmt::memory_buffer& text) {
      fmt::format_to(std::back_inserter(text), FMT_COMPILE("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n"), t[0], t[1],
                     t[2]);
    });
    add("</triangles>\n</mesh>\n</object>\n");
  }

  void finish() {
    std::string build = "</resources>\n<build>\n";
    for (std::size_t id = 1; id <= parts_.size(); ++id) build += fmt::format("<item objectid=\"{}\"/>\n", id);
    add(build + "</build>\n</model>\n");
    zip_.end();
    zip_.finish();
  }

  void add(std::string_view text) { zip_.add(deflated(text)); }

  /// Writes one line per item. Blocks of lines are formatted and deflated in parallel, always with
  /// the same boundaries. Progress is counted in objects, starting at `from`; the items count as
  /// half an object.
  template <class Items, class Format>
  void add_lines(const Items& items, double from, const Format& format) {
    constexpr std::size_t lines_a_stretch = 8192, stretches_at_once = 128;
    const std::size_t count = (items.size() + lines_a_stretch - 1) / lines_a_stretch;
    std::vector<Deflated> made;
    for (std::size_t first = 0; first < count; first += stretches_at_once) {
      const double here = from + 0.5 * static_cast<double>(first) / static_cast<double>(count);
      progress_.report(here / static_cast<double>(parts_.size()), "writing the mesh");
      made.resize(std::min(stretches_at_once, count - first));
      parallel_for(made.size(), [&](std::size_t i) {
        progress_.check();
        fmt::memory_buffer text;
        const std::size_t begin = (first + i) * lines_a_stretch, end = std::min(begin + lines_a_stretch, items.size());
        for (std::size_t item = begin; item < end; ++item) format(items[item], text);
        made[i] = deflated({text.data(), text.size()});
      });
      for (const Deflated& stretch : made) zip_.add(stretch);
    }
  }

  std::span<const PartView> parts_;
  ZipWriter zip_;
  Progress& progress_;
  std::map<std::string, std::size_t> places_;  ///< of colours
};

}  // namespace

void write_3mf(std::span<const PartView> parts, PendingFile& file, Progress& progress) {
  ThreeMfWriter(parts, file, progress).write();
}

}  // namespace fieldfab
