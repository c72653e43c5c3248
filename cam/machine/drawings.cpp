// Programs as drawings: DXF and SVG.
#include <fmt/format.h>

#include <cmath>

#include "writers.h"

namespace fieldfab::cam {
namespace {

/// A run of cutting moves seen from above; closed if it ends at its start.
struct Run {
  std::vector<PathPoint> points;
  bool closed = false;
};

std::vector<Run> runs_of(const Program& program) {
  std::vector<Run> runs;
  for (const Section& section : program.sections) {
    Run run;
    const auto finish = [&] {
      if (run.points.size() > 1) {
        run.closed = (run.points.front().at - run.points.back().at).head<2>().norm() < 1e-6 && run.points.size() > 2;
        if (run.closed) run.points.pop_back();
        runs.push_back(run);
      }
      run.points.clear();
    };
    for (const Move& move : section.moves) {
      if (move.rapid()) {
        finish();
        run.points = {{move.to}};
        continue;
      }
      if (run.points.empty()) run.points.push_back({move.to});
      if ((move.to - run.points.back().at).head<2>().norm() < 1e-9) {  // vertical move
        run.points.back().at = move.to;
        continue;
      }
      run.points.back().bulge = move.bulge;
      run.points.push_back({move.to});
    }
    finish();
  }
  return runs;
}

}  // namespace

std::string write_dxf(const Program& program) {
  // Polylines of AutoCAD R12, which every reader supports; lengths in mm.
  std::string out =
      "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
  for (const Run& run : runs_of(program)) {
    out += fmt::format("0\nPOLYLINE\n8\n0\n66\n1\n10\n0.0\n20\n0.0\n30\n0.0\n70\n{}\n", run.closed ? 1 : 0);
    for (const PathPoint& p : run.points)
      out += fmt::format("0\nVERTEX\n8\n0\n10\n{}\n20\n{}\n30\n0.0\n42\n{}\n", number_text(p.at.x(), 6),
                         number_text(p.at.y(), 6), number_text(p.bulge, 9));
    out += "0\nSEQEND\n8\n0\n";
  }
  return out + "0\nENDSEC\n0\nEOF\n";
}

std::string write_svg(const Program& program) {
  const std::vector<Run> runs = runs_of(program);
  Rectangle box = Rectangle::nothing();
  for (const Run& run : runs) {
    Path path;
    path.points = run.points, path.closed = run.closed;
    const Rectangle r = path.bounds();
    box.add(r.lower), box.add(r.upper);
  }
  if (runs.empty()) box = {Vec2::Zero(), Vec2::Ones()};
  const Vec2 size = box.size();
  // In SVG y points down.
  const auto x = [&](double at) { return number_text(at - box.lower.x(), 5); };
  const auto y = [&](double at) { return number_text(box.upper.y() - at, 5); };
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\">\n",
      number_text(size.x(), 5), number_text(size.y(), 5));
  for (const Run& run : runs) {
    out += fmt::format("<path fill=\"none\" stroke=\"#ff0000\" stroke-width=\"0.01\" d=\"M{} {}",
                       x(run.points[0].at.x()), y(run.points[0].at.y()));
    const std::size_t n = run.points.size();
    for (std::size_t i = 0; i + (run.closed ? 0 : 1) < n; ++i) {
      const PathPoint &a = run.points[i], &b = run.points[(i + 1) % n];
      if (a.bulge == 0) {
        out += fmt::format("L{} {}", x(b.at.x()), y(b.at.y()));
      } else {
        const Arc arc = arc_between(a.at.head<2>(), b.at.head<2>(), a.bulge);
        out += fmt::format("A{0} {0} 0 {1} {2} {3} {4}", number_text(arc.radius, 5), std::abs(a.bulge) > 1 ? 1 : 0,
                           a.bulge > 0 ? 0 : 1, x(b.at.x()), y(b.at.y()));
      }
    }
    out += run.closed ? "Z\"/>\n" : "\"/>\n";
  }
  return out + "</svg>\n";
}

}  // namespace fieldfab::cam
