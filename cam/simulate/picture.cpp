#include "fieldfab/cam/simulate/picture.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "drawing.h"
#include "fieldfab/core/error.h"
#include "fieldfab/frep/shapes.h"

namespace fieldfab::cam {
namespace {

namespace s = frep::shapes;

using Stops = std::vector<Colour>;

/// ColorBrewer's RdBu, from pale to saturated (the blues slightly lighter, for shadows), and
/// viridis without its darkest part: perceptually uniform.
const Stops reds{{244, 165, 130}, {214, 96, 77}, {178, 24, 43}}, blues{{146, 197, 222}, {67, 147, 195}, {44, 113, 184}},
    violet_to_yellow{{72, 40, 120},  {62, 74, 137},  {49, 104, 142}, {38, 130, 142}, {31, 158, 137},
                     {53, 183, 121}, {109, 205, 89}, {180, 222, 44}, {253, 231, 37}};
constexpr Colour within_tolerance{222, 222, 220}, first_surface{214, 209, 198};

/// Interpolated colour; `share` from 0 to 1.
Colour along(const Stops& stops, double share) {
  const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  Colour out{};
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = static_cast<std::uint8_t>(
        std::lround(stops[i][c] + (at - static_cast<double>(i)) * (stops[i + 1][c] - stops[i][c])));
  return out;
}

/// Smallest of the numbers 1, 2, 5, 10, ... that is not less than the value.
double round_number_from(double value) {
  double step = std::pow(10, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0, 10.0})
    if (factor * step >= value * (1 - 1e-9)) return factor * step;
  return 10 * step;
}

/// Numbered rings about places.
class Marks {
 public:
  Marks(const SimulationResult& result, TrianglePicture& picture)
      : result_(result),
        picture_(picture),
        image_(picture.image),
        radius_(std::max(12.0, std::max(image_.width, image_.height) / 64.0)) {}

  void draw() {
    for (const std::size_t i : worst_events(result_)) {
      const SimulationEvent& event = result_.report().events[i];
      const Vec3 at = picture_.on_picture(event.place);
      if (!(at.x() >= 0 && at.y() >= 0 && at.x() < image_.width && at.y() < image_.height)) continue;
      draw(fmt::format("{}", i + 1), at.x(), image_.height - at.y(), shows_event(result_, picture_, event));
    }
  }

 private:
  void draw(const std::string& number, double x, double y, bool seen) {
    constexpr Colour dark{25, 28, 36}, white{255, 255, 255};
    const double opacity = seen ? 1 : 0.45, r = radius_, ring = 0.42 * r;
    const auto about = [&](double px, double py, double reach) {
      return Box{{px - reach, py - reach, 0}, {px + reach, py + reach, 0}};
    };
    const auto [nx, ny] = free_spot(x, y);
    const double way = std::hypot(nx - x, ny - y), ux = (nx - x) / way, uy = (ny - y) / way;
    const Box both = about((x + nx) / 2, (y + ny) / 2, way + r);
    // White below dark, for contrast with any background.
    for (const auto& [width, colour] : {std::pair{0.42 * r, white}, std::pair{0.2 * r, dark}}) {
      paint(image_, s::stroke(x + ring * ux, y + ring * uy, nx, ny, width), both, colour, opacity);
      const frep::Expression circle = frep::max(s::circle(ring + width / 2), -s::circle(ring - width / 2));
      paint(image_, s::move(circle, x, y, 0.0), about(x, y, r), colour, opacity);
    }
    paint(image_, s::move(s::circle(1.12 * r), nx, ny, 0.0), about(nx, ny, 1.2 * r), white, opacity);
    paint(image_, s::move(s::circle(r), nx, ny, 0.0), about(nx, ny, r), dark, opacity);
    paint_words(image_, number, nx, ny,
                (number.size() == 1   ? 1.05
                 : number.size() == 2 ? 0.78
                                      : 0.55) *
                    r,
                white, seen ? 1 : 0.8);
  }

  /// Position of a number: beside its place, within the picture, clear of other numbers.
  std::pair<double, double> free_spot(double x, double y) {
    std::pair<double, double> best{x + 2.2 * radius_, y + 2.2 * radius_};
    double most = -1e300;
    for (int direction = 0; direction < 16; ++direction)
      for (const double distance : {3.0, 4.5}) {
        const double angle = (0.25 + direction / 8.0) * std::numbers::pi;
        const std::pair<double, double> spot{x + distance * radius_ * std::cos(angle),
                                             y + distance * radius_ * std::sin(angle)};
        const auto [px, py] = spot;
        double room = std::min({px, py, image_.width - px, image_.height - py, 3 * radius_});
        for (const auto& [ox, oy] : spots_) room = std::min(room, std::hypot(px - ox, py - oy));
        room -= 0.01 * direction + 0.1 * distance;  // prefer the upper right among similar positions
        if (room > most) most = room, best = spot;
      }
    spots_.push_back(best);
    spots_.emplace_back(x, y);
    return best;
  }

  const SimulationResult& result_;
  const TrianglePicture& picture_;
  Image& image_;
  double radius_;  ///< of the discs with numbers, pixels
  std::vector<std::pair<double, double>> spots_;
};

/// Adds a legend below a picture: a bar with the scale's colours and its labels.
void add_legend(Image& image, const DeviationScale& scale) {
  constexpr Colour ink{40, 44, 52};
  const double side = std::max(image.width, image.height), text = std::max(8.0, side / 95), height = 1.3 * text,
               width = 0.36 * side, left = 0.05 * side, bottom = 2.4 * text;
  // The background's last colour.
  const Colour paper{image.pixels8[image.pixels8.size() - 3], image.pixels8[image.pixels8.size() - 2],
                     image.pixels8.back()};
  const auto rows = static_cast<int>(std::lround(bottom + height + 2.4 * text));
  for (int i = 0; i < rows * image.width; ++i)
    for (std::size_t channel = 0; channel < 3; ++channel) image.pixels8.push_back(paper[channel]);
  image.height += rows;
  const int steps = static_cast<int>(width);
  for (int i = 0; i < steps; ++i) {
    const double deviation = scale.full * (2.0 * (i + 0.5) / steps - 1), x = left + (i + 0.5) * width / steps;
    const Box where{{x - 1, bottom, 0}, {x, bottom + height, 0}};
    paint(image, s::move(s::exact_rectangle(width / steps + 0.5, height), x, bottom + height / 2, 0.0), where,
          scale.colour(deviation));
  }
  const auto tick = [&](double deviation, const std::string& words, double y) {
    paint_words(image, words, left + (deviation / scale.full + 1) / 2 * width, y, text, ink);
  };
  tick(-scale.full, fmt::format("-{:.3g}", scale.full), bottom - 1.1 * text);
  tick(0, "0 mm", bottom - 1.1 * text);
  tick(scale.full, fmt::format("+{:.3g}", scale.full), bottom - 1.1 * text);
  tick(-0.5 * scale.full, "gouge", bottom + height + 1.1 * text);
  tick(0.5 * scale.full, "left over", bottom + height + 1.1 * text);
}

/// The visible window: bounds of the remaining material with a margin, with the requested aspect
/// ratio. If no material remains, the bounds of the initial stock.
Box frame_of(const SimulationResult& result, const StockPictureSettings& settings) {
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(settings.beta, Vec3::UnitX()) * Eigen::AngleAxisd(settings.alpha, Vec3::UnitZ())).matrix();
  Box frame = image_of(result.setup().stock_box, turn, Vec3::Zero());
  const auto& vertices = result.surface().mesh.vertices;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec3 p = turn * Vec3(vertices[i][0], vertices[i][1], vertices[i][2]);
    frame = i == 0 ? Box{p, p} : hull(frame, {p, p});
  }
  frame = frame.grown(0.03 * frame.size().head<2>().maxCoeff());
  if (!(settings.aspect > 0)) return frame;
  const Vec3 size = frame.size();
  const double wider = std::max(size.x(), settings.aspect * size.y()) - size.x(),
               higher = std::max(size.y(), size.x() / settings.aspect) - size.y();
  const Vec3 more(wider / 2, higher / 2, 0);
  return {frame.lower - more, frame.upper + more};
}

}  // namespace

StockColouring default_colouring(const SimulationResult& result) {
  if (result.report().deviation) return StockColouring::deviation;
  std::set<int> cutting;
  for (const std::uint32_t cut : result.surface().cuts) cutting.insert(result.cuts()[cut].move.tool);
  cutting.erase(0);
  return cutting.size() > 1 ? StockColouring::tool : StockColouring::line;
}

DeviationScale DeviationScale::of(const SimulationResult& result) {
  const SimulationSetup& setup = result.setup();
  DeviationScale scale{setup.gouge, setup.excess > 0 ? setup.excess : setup.gouge, 1};
  const double tolerance = std::max({scale.gouge, scale.excess, 1e-3});
  double worst = 0;
  if (const auto& deviation = result.report().deviation)
    worst = deviation->deepest > scale.gouge ? deviation->deepest : deviation->highest;
  scale.full = round_number_from(std::clamp(worst, 4 * tolerance, 20 * tolerance));
  return scale;
}

Colour DeviationScale::colour(double deviation) const {
  if (deviation < -gouge) return along(reds, (-deviation - gouge) / (full - gouge));
  if (deviation > excess) return along(blues, (deviation - excess) / (full - excess));
  return within_tolerance;
}

Colour colour_of_tool(std::size_t place_in_set_up) {
  if (place_in_set_up == 0) return first_surface;
  const Stops colours{{78, 121, 167}, {242, 142, 43},  {89, 161, 79}, {176, 122, 161},
                      {237, 201, 72}, {118, 183, 178}, {156, 117, 95}};
  return colours[(place_in_set_up - 1) % colours.size()];
}

Colour colour_of_line(double share) { return along(violet_to_yellow, share); }

std::vector<Colour> vertex_colours(const SimulationResult& result, StockColouring colouring) {
  const auto cut_of = [&](std::size_t vertex) { return result.cuts()[result.surface().cuts[vertex]].move; };
  std::vector<Colour> colours(result.surface().mesh.vertices.size(), first_surface);
  switch (colouring) {
    case StockColouring::deviation: {
      const auto& deviation = result.report().deviation;
      if (!deviation) throw Error(ErrorKind::bad_input, "colours", "there is no target to tell deviations from");
      const DeviationScale scale = DeviationScale::of(result);
      for (std::size_t i = 0; i < colours.size(); ++i)
        colours[i] = scale.colour(static_cast<double>(deviation->at_vertex[i]));
      break;
    }
    case StockColouring::tool: {
      std::map<int, Colour> of_tool{{0, colour_of_tool(0)}};
      for (const auto& [number, tool] : result.setup().tools)
        of_tool.try_emplace(number, colour_of_tool(of_tool.size()));
      for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = of_tool[cut_of(i).tool];
      break;
    }
    case StockColouring::line: {
      // By order in time, evenly, independently of jumps in a program.
      std::map<std::pair<int, int>, double> order;  // by program and line
      for (const LineRecord& record : result.report().lines)
        if (record.removed > 0) order.try_emplace({record.program, record.line}, static_cast<double>(order.size()));
      const double last = std::max(1.0, static_cast<double>(order.size()) - 1);
      for (std::size_t i = 0; i < colours.size(); ++i)
        if (const auto found = order.find({cut_of(i).program, cut_of(i).line}); found != order.end())
          colours[i] = colour_of_line(found->second / last);
      break;
    }
  }
  return colours;
}

std::vector<std::size_t> worst_events(const SimulationResult& result, std::size_t most) {
  const auto& events = result.report().events;
  std::map<SimulationEvent::Kind, std::vector<std::size_t>> of_kind;
  for (std::size_t i = 0; i < events.size(); ++i) of_kind[events[i].kind].push_back(i);
  std::size_t longest = 0;
  for (auto& [kind, list] : of_kind) {
    std::stable_sort(list.begin(), list.end(),
                     [&](std::size_t a, std::size_t b) { return events[a].amount > events[b].amount; });
    longest = std::max(longest, list.size());
  }
  const double neighbourhood = result.setup().stock_box.diagonal() / 25;
  std::vector<std::size_t> chosen;
  const auto near = [&](std::size_t i) {
    return std::any_of(chosen.begin(), chosen.end(), [&](std::size_t other) {
      return (events[i].place - events[other].place).norm() < neighbourhood;
    });
  };
  for (std::size_t rank = 0; rank < longest; ++rank)
    for (const auto& [kind, list] : of_kind)
      if (rank < list.size() && chosen.size() < most && (rank == 0 || !near(list[rank]))) chosen.push_back(list[rank]);
  return chosen;
}

TrianglePicture stock_picture(const SimulationResult& result, const StockPictureSettings& settings,
                              Progress& progress) {
  const StockColouring colouring = settings.colouring.value_or(default_colouring(result));
  const std::vector<Colour> colours = vertex_colours(result, colouring);
  RenderSettings view;
  view.size = settings.size, view.alpha = settings.alpha, view.beta = settings.beta, view.window = settings.window;
  view.samples = 2;
  const TriangleMesh& mesh = result.surface().mesh;
  if (!view.window) view.window = frame_of(result, settings);
  TrianglePicture picture = render({mesh.vertices, mesh.triangles, colours}, view, progress);
  if (settings.marks) Marks(result, picture).draw();
  return picture;
}

bool shows_event(const SimulationResult& result, const TrianglePicture& picture, const SimulationEvent& event) {
  // Places of contacts are lattice points beside the surface, and a pixel may be as large as a
  // cell: a depth within that tolerance counts as visible.
  const double pixel = picture.image.bounds.size().x() / picture.image.width;
  return picture.shows(event.place, 3 * std::max(result.stock().lattice().spacing().maxCoeff(), pixel));
}

void write_stock_picture(const SimulationResult& result, const std::filesystem::path& path,
                         const StockPictureSettings& settings, Progress& progress) {
  if (path.extension() != ".png") throw Error(ErrorKind::bad_input, path.string(), "a picture of a stock is a .png");
  Image image = stock_picture(result, settings, progress).image;
  if (settings.colouring.value_or(default_colouring(result)) == StockColouring::deviation)
    add_legend(image, DeviationScale::of(result));
  write_png(image, path);
}

}  // namespace fieldfab::cam
