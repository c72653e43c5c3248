#include "imports.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/lower_case.h"
#include "fieldfab/mesh/load_mesh.h"
#include "fieldfab/render/image.h"
#include "programs.h"

namespace fieldfab::openscad {
namespace {

/// Returns the outlines of the path in an .svg file written by OpenSCAD: "M x,y L x,y ... z", with
/// y downwards.
std::vector<Outline> outlines_of_svg(const std::string& text, const std::string& name) {
  std::vector<Outline> outlines;
  for (std::size_t path = text.find("<path d=\""); path != std::string::npos; path = text.find("<path d=\"", path)) {
    path += 9;
    const std::size_t end = std::min(text.find('"', path), text.size());
    for (const char* at = text.data() + path; at < text.data() + end;) {
      if (*at == 'M') outlines.emplace_back();
      if (*at != '-' && (*at < '0' || *at > '9')) {
        ++at;
        continue;
      }
      Vec2 p;
      for (int i = 0; i < 2; ++i) {
        while (at < text.data() + end && (*at == ',' || *at == ' ' || *at == '\n')) ++at;
        const auto [next, failure] = std::from_chars(at, text.data() + end, p[i]);
        if (failure != std::errc{} || outlines.empty())
          throw Error(ErrorKind::internal, name, "OpenSCAD's drawing is not understood");
        at = next;
      }
      outlines.back().emplace_back(p.x(), -p.y());
    }
  }
  return outlines;
}

/// Returns rows of heights, the first at y = 0.
std::vector<std::vector<double>> heights_of_text(const std::filesystem::path& file) {
  std::istringstream text(read_file(file));
  std::vector<std::vector<double>> rows;
  std::string line;
  for (int number = 1; std::getline(text, line); ++number) {
    std::vector<double> row;
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      if (word[0] == '#') break;
      double value = 0;
      const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
      if (failure != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
        throw Error(ErrorKind::bad_input, fmt::format("{}:{}", file.string(), number),
                    fmt::format("expected a number, found '{:.40}'", word));
      row.push_back(value);
    }
    if (!row.empty()) rows.push_back(std::move(row));
  }
  std::size_t columns = 0;
  for (const auto& row : rows) columns = std::max(columns, row.size());
  for (auto& row : rows) row.resize(columns, 0);
  return rows;
}

/// Returns the brightness of pixels in percent, the bottom row first.
std::vector<std::vector<double>> heights_of_picture(const std::filesystem::path& file, bool invert) {
  const Image image = read_png(file);
  const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
  const auto channels = static_cast<std::size_t>(image.channels);
  const auto sample = [&](std::size_t i) { return image.depth == 16 ? image.pixels16[i] / 257.0 : image.pixels8[i]; };
  std::vector<std::vector<double>> rows(height, std::vector<double>(width));
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t first = ((height - 1 - y) * width + x) * channels;
      const double light = channels == 1
                               ? sample(first)
                               : 0.2126 * sample(first) + 0.7152 * sample(first + 1) + 0.0722 * sample(first + 2);
      rows[y][x] = 100.0 / 255 * (invert ? 1 - light : light);
    }
  return rows;
}

}  // namespace

bool is_flat_file(const std::string& file) {
  const std::string extension = lower_extension(file);
  return extension == ".dxf" || extension == ".svg";
}

Region drawn_by_openscad(const Tree& tree, NodeIndex node, const std::filesystem::path& folder, Progress& progress) {
  Tree alone;
  alone.file = tree.file;
  alone.nodes.push_back(tree.nodes[node]);
  alone.nodes[0].children.clear();
  for (Argument& argument : alone.nodes[0].arguments) {
    if (argument.name != "file") continue;
    const auto* name = argument.value.text();
    if (name == nullptr)
      throw Error(ErrorKind::bad_input, tree.place(tree.nodes[node]), "import: file must be words in quotes");
    const std::filesystem::path file = std::filesystem::absolute(folder / *name);
    if (!std::filesystem::is_regular_file(file))
      throw Error(ErrorKind::io, tree.place(tree.nodes[node]), file.string() + ": there is no such file");
    argument.value.held = file.string();
  }
  std::erase_if(alone.nodes[0].arguments, [](const Argument& argument) { return argument.name == "timestamp"; });
  const TemporaryFolder temporary;
  write_file(temporary.path() / "drawing.scad", print_csg(alone, 0));
  const std::filesystem::path drawing = temporary.path() / "drawing.svg";
  try {
    run_openscad(temporary.path() / "drawing.scad", drawing, progress);
  } catch (const Error& error) {
    const std::string message = error.what();
    // Texts without a stroke, layers without a line, empty texts.
    if (message.find("object is empty") != std::string::npos || message.find("not a 2D object") != std::string::npos)
      return {};
    if (error.kind() == ErrorKind::bad_input) throw Error(error.kind(), tree.place(tree.nodes[node]), message);
    throw;
  }
  return even_odd(outlines_of_svg(read_file(drawing), tree.file));
}

Polyhedron import_mesh(const std::filesystem::path& file, Progress& progress) {
  require_regular_file(file);
  const std::string extension = lower_extension(file);
  if (is_mesh_extension(extension)) return to_polyhedron(load_mesh(file, progress).mesh);
  if (extension != ".amf" && extension != ".nef3")
    throw Error(ErrorKind::bad_input, file.string(),
                fmt::format("cannot be imported: '{}' is none of .stl .off .amf .3mf .obj .nef3 .dxf .svg", extension));
  Tree tree;
  tree.file = file.string();
  tree.nodes.push_back({});
  tree.nodes[0].name = "import";
  tree.nodes[0].arguments.push_back({"file", {std::filesystem::absolute(file).string()}});
  const TemporaryFolder temporary;
  write_file(temporary.path() / "import.scad", print_csg(tree, 0));
  run_openscad(temporary.path() / "import.scad", temporary.path() / "import.off", progress);
  return to_polyhedron(read_mesh(temporary.path() / "import.off"));
}

Polyhedron surface(const std::filesystem::path& file, bool centre, bool invert) {
  require_regular_file(file);
  const auto rows = lower_extension(file) == ".png" ? heights_of_picture(file, invert) : heights_of_text(file);
  if (rows.size() < 2 || rows.front().size() < 2) return {};
  const std::size_t lines = rows.size(), columns = rows.front().size();
  double floor = 0;
  for (const auto& row : rows)
    for (const double z : row) floor = std::min(floor, z - 1);
  const double left = centre ? -0.5 * static_cast<double>(columns - 1) : 0,
               front = centre ? -0.5 * static_cast<double>(lines - 1) : 0;
  Polyhedron solid;
  const auto add = [&](double x, double y, double z) {
    solid.vertices.emplace_back(left + x, front + y, z);
    return static_cast<std::uint32_t>(solid.vertices.size() - 1);
  };
  for (std::size_t y = 0; y < lines; ++y)
    for (std::size_t x = 0; x < columns; ++x) add(static_cast<double>(x), static_cast<double>(y), rows[y][x]);
  const auto at = [&](std::size_t x, std::size_t y) { return static_cast<std::uint32_t>(y * columns + x); };
  for (std::size_t y = 0; y + 1 < lines; ++y)
    for (std::size_t x = 0; x + 1 < columns; ++x) {
      const double mean = (rows[y][x] + rows[y][x + 1] + rows[y + 1][x] + rows[y + 1][x + 1]) / 4;
      const std::uint32_t middle = add(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5, mean);
      const std::array<std::uint32_t, 4> ring{at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)};
      for (std::size_t i = 0; i < 4; ++i) solid.triangles.push_back({ring[i], ring[(i + 1) % 4], middle});
    }
  // Walls around, anticlockwise from above, and the floor as a fan.
  std::vector<std::uint32_t> rim, below;
  for (std::size_t x = 0; x + 1 < columns; ++x) rim.push_back(at(x, 0));
  for (std::size_t y = 0; y + 1 < lines; ++y) rim.push_back(at(columns - 1, y));
  for (std::size_t x = columns - 1; x > 0; --x) rim.push_back(at(x, lines - 1));
  for (std::size_t y = lines - 1; y > 0; --y) rim.push_back(at(0, y));
  for (const std::uint32_t i : rim) {
    const Vec3 p = solid.vertices[i];
    solid.vertices.emplace_back(p.x(), p.y(), floor);
    below.push_back(static_cast<std::uint32_t>(solid.vertices.size() - 1));
  }
  const std::uint32_t middle = add(0.5 * static_cast<double>(columns - 1), 0.5 * static_cast<double>(lines - 1), floor);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const std::size_t next = (i + 1) % rim.size();
    solid.triangles.push_back({rim[i], below[i], below[next]});
    solid.triangles.push_back({rim[i], below[next], rim[next]});
    solid.triangles.push_back({below[next], below[i], middle});
  }
  return solid;
}

}  // namespace fieldfab::openscad
