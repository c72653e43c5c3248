#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "fieldfab/core/parallel.h"
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

/// A .3mf file in the making: objects one after the other, then the build, which places each of them once.
class ThreeMfWriter {
 public:
  /// `most` is the sum of most_text_of() all its objects.
  ThreeMfWriter(PendingFile& file, std::uint64_t most, Progress& progress) : zip_(file), progress_(progress) {
    zip_.add_part("[Content_Types].xml", content_types);
    zip_.add_part("_rels/.rels", relationships);
    zip_.begin("3D/3dmodel.model", most + 4096);
    add(model_begins);
  }

  static std::uint64_t most_text_of(const TriangleMesh& mesh) {
    // A number has at most 24 digits and signs, an index 10.
    constexpr std::uint64_t vertex = 24 + 3 * 24, triangle = 30 + 3 * 10, object = 1024;
    return vertex * mesh.vertices.size() + triangle * mesh.triangles.size() + object;
  }

  void add_object(const TriangleMesh& mesh) {
    ++objects_;
    add(fmt::format("<object id=\"{}\" type=\"model\">\n<mesh>\n<vertices>\n", objects_));
    // The digits are those of the float as a double: see mesh_write.cpp.
    add_lines(mesh.vertices, 0, [](const std::array<float, 3>& p, fmt::memory_buffer& text) {
      fmt::format_to(std::back_inserter(text), FMT_COMPILE("<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n"), double{p[0]}, double{p[1]},
                     double{p[2]});
    });
    add("</vertices>\n<triangles>\n");
    add_lines(mesh.triangles, 0.5, [](const std::array<std::uint32_t, 3>& t, fmt::memory_buffer& text) {
      fmt::format_to(std::back_inserter(text), FMT_COMPILE("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n"), t[0], t[1], t[2]);
    });
    add("</triangles>\n</mesh>\n</object>\n");
  }

  void finish() {
    std::string build = "</resources>\n<build>\n";
    for (int id = 1; id <= objects_; ++id) build += fmt::format("<item objectid=\"{}\"/>\n", id);
    add(build + "</build>\n</model>\n");
    zip_.end();
    zip_.finish();
  }

 private:
  void add(std::string_view text) { zip_.add(deflated(text)); }

  /// A line for each item. Stretches of lines are made and deflated in parallel, and always at the same places.
  template <class Items, class Format>
  void add_lines(const Items& items, double from, const Format& format) {
    constexpr std::size_t lines_a_stretch = 8192, stretches_at_once = 128;
    const std::size_t count = (items.size() + lines_a_stretch - 1) / lines_a_stretch;
    std::vector<Deflated> made;
    for (std::size_t first = 0; first < count; first += stretches_at_once) {
      progress_.report(from + 0.5 * static_cast<double>(first) / static_cast<double>(count), "writing the mesh");
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

  ZipWriter zip_;
  Progress& progress_;
  int objects_ = 0;
};

}  // namespace

void write_3mf(const TriangleMesh& mesh, PendingFile& file, Progress& progress) {
  ThreeMfWriter writer(file, ThreeMfWriter::most_text_of(mesh), progress);
  writer.add_object(mesh);
  writer.finish();
}

}  // namespace fieldfab
