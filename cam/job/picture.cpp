#include "fieldfab/cam/job/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/html.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/render/image.h"
#include "html_picture.h"

namespace fieldfab::cam {
namespace {

using Colour = std::array<double, 3>;

/// A straight segment of the tool's path, projected to the picture's plane.
struct Line {
  Vec2 from, to;
  Colour colour;
  bool rapid;
};

struct Drawing {
  std::vector<Line> lines;
  Rectangle bounds = Rectangle::nothing();
};

Vec2 seen(const Vec3& p, bool oblique) {
  if (!oblique) return p.head<2>();
  // Rotated by 30 degrees about z, then seen from 30 degrees above the ground.
  const double turn = 0.5236, tilt = 0.5236, c = std::cos(turn), s = std::sin(turn);
  const double x = c * p.x() - s * p.y(), y = s * p.x() + c * p.y();
  return {x, y * std::sin(tilt) + p.z() * std::cos(tilt)};
}

Colour blend(const Colour& a, const Colour& b, double share) {
  Colour out{};
  for (std::size_t k = 0; k < 3; ++k) out[k] = a[k] + share * (b[k] - a[k]);
  return out;
}

Drawing draw(const Program& program, const PictureSettings& settings) {
  std::size_t count = 0;
  double low = 1e300, high = -1e300;
  for (const Section& section : program.sections) {
    count += section.moves.size();
    for (const Move& move : section.moves)
      if (!move.rapid()) low = std::min(low, move.to.z()), high = std::max(high, move.to.z());
  }
  constexpr Colour first{40, 80, 220}, last{20, 180, 60}, top{150, 200, 250}, deep{20, 30, 110}, red{225, 40, 40};
  Drawing drawing;
  std::size_t done = 0;
  for (const Section& section : program.sections) {
    Vec3 at = Vec3::Zero();
    bool known = false;
    for (const Move& move : section.moves) {
      const double share = static_cast<double>(done++) / static_cast<double>(std::max<std::size_t>(1, count - 1));
      if (known) {
        Path piece;
        piece.points = {{at, move.bulge}, {move.to}};
        const auto points = points_along(piece, std::max(0.05, (move.to - at).norm() / 16));
        for (std::size_t i = 1; i < points.size(); ++i) {
          const double height = high > low ? (points[i].at.z() - low) / (high - low) : 1;
          const Colour colour = move.rapid()                             ? red
                                : settings.colouring == Colouring::order ? blend(first, last, share)
                                                                         : blend(deep, top, height);
          drawing.lines.push_back(
              {seen(points[i - 1].at, settings.oblique), seen(points[i].at, settings.oblique), colour, move.rapid()});
        }
      }
      at = move.to, known = true;
    }
  }
  if (!settings.rapids) std::erase_if(drawing.lines, [](const Line& line) { return line.rapid; });
  // Rapids first, so that cuts are drawn over them.
  std::stable_partition(drawing.lines.begin(), drawing.lines.end(), [](const Line& line) { return line.rapid; });
  // Bounds of the cuts, and of rapids near them.
  for (const Line& line : drawing.lines)
    if (!line.rapid) drawing.bounds.add(line.from), drawing.bounds.add(line.to);
  if (!(drawing.bounds.size().minCoeff() > 0)) drawing.bounds = {Vec2::Zero(), Vec2::Ones()};
  drawing.bounds = drawing.bounds.grown(0.06 * drawing.bounds.size().maxCoeff() + 1e-3);
  return drawing;
}

/// Antialiased lines about one pixel wide, on white.
Image rasterised(const Drawing& drawing, int size) {
  const Vec2 extent = drawing.bounds.size();
  const double scale = size / extent.maxCoeff();
  Image image;
  image.width = std::max(1, static_cast<int>(std::lround(extent.x() * scale))),
  image.height = std::max(1, static_cast<int>(std::lround(extent.y() * scale)));
  image.channels = 3;
  image.pixels_per_mm = scale;
  image.pixels8.assign(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 3, 255);
  const auto blot = [&](int x, int y, double cover, const Colour& colour) {
    if (x < 0 || y < 0 || x >= image.width || y >= image.height || cover <= 0) return;
    const std::size_t i =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) * 3;
    for (std::size_t k = 0; k < 3; ++k)
      image.pixels8[i + k] =
          static_cast<std::uint8_t>(std::lround(image.pixels8[i + k] + cover * (colour[k] - image.pixels8[i + k])));
  };
  for (const Line& line : drawing.lines) {
    const Vec2 a = (line.from - drawing.bounds.lower) * scale, b = (line.to - drawing.bounds.lower) * scale;
    const Vec2 way = b - a;
    const double length = way.norm();
    const int axis = std::abs(way.x()) >= std::abs(way.y()) ? 0 : 1;
    const double low = std::min(a[axis], b[axis]), high = std::max(a[axis], b[axis]);
    for (int u = static_cast<int>(std::floor(low)); u <= static_cast<int>(std::floor(high)); ++u) {
      const double along = std::clamp(u + 0.5, low, high);
      const double t = std::abs(way[axis]) > 1e-12 ? (along - a[axis]) / way[axis] : 0,
                   across = a[1 - axis] + t * way[1 - axis];
      for (int v = static_cast<int>(std::floor(across)) - 1; v <= static_cast<int>(std::floor(across)) + 1; ++v) {
        const double off = std::abs(v + 0.5 - across) * (length > 0 ? std::abs(way[axis]) / length : 1),
                     cover = std::clamp((line.rapid ? 0.85 : 1.15) - off, 0.0, 1.0) * (line.rapid ? 0.6 : 0.9);
        axis == 0 ? blot(u, image.height - 1 - v, cover, line.colour)
                  : blot(v, image.height - 1 - u, cover, line.colour);
      }
    }
  }
  return image;
}

std::string as_svg(const Drawing& drawing) {
  const Vec2 size = drawing.bounds.size();
  const double width = size.maxCoeff() / 1200;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.4f} {:.4f}\" stroke-linecap=\"round\" "
      "fill=\"none\">\n<rect "
      "width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      size.x(), size.y());
  const auto x = [&](const Vec2& p) { return p.x() - drawing.bounds.lower.x(); };
  const auto y = [&](const Vec2& p) { return drawing.bounds.upper.y() - p.y(); };
  // Consecutive lines of similar colour form one path.
  Vec2 end = Vec2::Constant(1e300);
  Colour colour{-1000, 0, 0};
  bool open = false;
  for (const Line& line : drawing.lines) {
    double change = 0;
    for (std::size_t k = 0; k < 3; ++k) change += std::abs(colour[k] - line.colour[k]);
    if (line.from != end || change > 4) {
      if (open) out += "\"/>\n";
      colour = line.colour;
      out += fmt::format("<path stroke=\"#{:02x}{:02x}{:02x}\" stroke-width=\"{:.4f}\" d=\"M{:.3f} {:.3f}",
                         std::lround(colour[0]), std::lround(colour[1]), std::lround(colour[2]),
                         line.rapid ? 0.6 * width : width, x(line.from), y(line.from));
      open = true;
    }
    out += fmt::format("L{:.3f} {:.3f}", x(line.to), y(line.to));
    end = line.to;
  }
  return out + (open ? "\"/>\n</svg>\n" : "</svg>\n");
}

}  // namespace

std::string html_picture(const Program& program, const PictureSettings& settings) {
  const Drawing drawing = draw(program, settings);
  constexpr std::size_t most_lines = 3000;
  if (drawing.lines.size() <= most_lines) return as_svg(drawing);
  return html_image(rasterised(drawing, settings.size), "");
}

void write_picture(const Program& program, const std::filesystem::path& path, const PictureSettings& settings) {
  if (settings.size < 16 || settings.size > 16384)
    throw Error(ErrorKind::bad_input, "size", fmt::format("{} pixels; from 16 to 16384 are possible", settings.size));
  if (path.extension() == ".svg") return write_file(path, as_svg(draw(program, settings)));
  if (path.extension() == ".png") return write_png(rasterised(draw(program, settings), settings.size), path);
  throw Error(ErrorKind::bad_input, path.string(), "a picture of a program is a .png or an .svg");
}

}  // namespace fieldfab::cam
