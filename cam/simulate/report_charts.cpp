#include "report_charts.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

namespace fieldfab::cam {
namespace {

// pixels: width of a chart, and its margins beside the bars
constexpr double width = 900, left = 64, right = 12;

std::string start(double height, const char* description) {
  return fmt::format("<svg class=\"chart\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}\">\n", width,
                     height, description);
}

std::string text(double x, double y, const char* anchor, const std::string& words) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, words);
}

std::string bar(double x, double top, double wide, double bottom, const std::string& fill) {
  if (!(bottom - top > 0)) return "";
  return fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>\n", x, top, wide,
                     bottom - top, fill);
}

std::string rule(double y, const char* colour) {
  return fmt::format("<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"{}\"/>\n", left, y, width - right, colour);
}

/// Step of 1, 2 or 5 times a power of ten, such that about `count` steps reach `most`.
double step_for(double most, int count) {
  const double rough = most / count, power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough) return factor * power;
  return 10 * power;
}

/// Fractions of the surface area: below -full, in `bins` equal steps up to full, and above.
std::vector<double> shares_of_area(const SimulationResult& result, double full, std::size_t bins) {
  const double beyond = full * (1 + 2 / static_cast<double>(bins));
  std::vector<double> areas = result.report().deviation->areas.steps(-beyond, beyond, bins + 2);
  double all = 0;
  for (const double a : areas) all += a;
  for (double& a : areas) a /= std::max(all, 1e-300);
  return areas;
}

}  // namespace

std::string deviation_chart(const SimulationResult& result, const DeviationScale& scale) {
  constexpr std::size_t bins = 60;
  constexpr double top = 10, bottom = 200, height = 240, decades = 5;  // from 0.001 % to 100 %
  const std::vector<double> shares = shares_of_area(result, scale.full, bins);
  const double wide = (width - left - right) / static_cast<double>(shares.size());
  const auto x_of = [&](double deviation) {
    return left + wide * (1 + (deviation + scale.full) / (2 * scale.full) * static_cast<double>(bins));
  };
  std::string out = start(height, "histogram of deviations");
  for (int decade = 0; decade <= decades; ++decade) {
    const double y = top + (bottom - top) * decade / decades;
    out += rule(y, "#e4e4e4") + text(left - 6, y + 4, "end", fmt::format("{:.4g} %", 100 / std::pow(10, decade)));
  }
  for (const double edge : {-scale.gouge, scale.excess})
    out += fmt::format("<path d=\"M{0:.2f} {1}V{2}\" stroke=\"#888\" stroke-dasharray=\"3 3\"/>\n", x_of(edge), top,
                       bottom);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double middle = scale.full * (2 * (static_cast<double>(i) - 0.5) / static_cast<double>(bins) - 1);
    const double tall = shares[i] > 0 ? std::max(0.0, 1 + std::log10(shares[i]) / decades) : 0;
    out += bar(left + wide * static_cast<double>(i) + 0.5, bottom - (bottom - top) * tall, wide - 1, bottom,
               text_of(scale.colour(middle)));
  }
  out += rule(bottom, "#444");
  const double step = step_for(2 * scale.full, 8);
  for (double at = 0; at <= scale.full * (1 + 1e-9); at += step)
    for (const double sign : {-1.0, 1.0})
      if (at > 0 || sign > 0)
        out += text(x_of(sign * at), bottom + 16, "middle", at > 0 ? fmt::format("{:+.3g}", sign * at) : "0");
  out += text(left, bottom + 34, "start", "too deep") +
         text((left + width - right) / 2, bottom + 34, "middle", "deviation, mm") +
         text(width - right, bottom + 34, "end", "left over");
  return out + "</svg>\n";
}

std::string lines_chart(const SimulationReport& report) {
  // Consecutive programs are drawn side by side.
  std::vector<int> before(report.programs.size() + 1, 0);
  for (const LineRecord& record : report.lines) {
    int& lines = before[static_cast<std::size_t>(record.program) + 1];
    lines = std::max(lines, record.line);
  }
  std::partial_sum(before.begin(), before.end(), before.begin());
  const int last = std::max(1, before.back());
  const auto bins = static_cast<std::size_t>(std::min(last, 140));
  std::vector<double> removed(bins, 0), cut(bins, 0), air(bins, 0);
  const auto bin_of = [&](int program, int line) {
    line += before[static_cast<std::size_t>(program)];
    return std::min(bins - 1, static_cast<std::size_t>(std::max(line - 1, 0)) * bins / static_cast<std::size_t>(last));
  };
  for (const LineRecord& record : report.lines) {
    const std::size_t i = bin_of(record.program, record.line);
    removed[i] += record.removed, cut[i] += record.cut, air[i] += record.air;
  }
  const double wide = (width - left - right) / static_cast<double>(bins);
  constexpr double panel = 110, first_top = 22, second_top = 180, height = 345;
  std::string out = start(height, "material removed and feed in air along the program");
  const auto axis = [&](double top, double most, const std::string& title) {
    const double bottom = top + panel, step = step_for(most, 4);
    out += text(left, top - 8, "start", title);
    for (double at = 0; at <= most * (1 + 1e-9); at += step)
      out += rule(bottom - panel * at / most, "#e4e4e4") +
             text(left - 6, bottom - panel * at / most + 4, "end", fmt::format("{:.4g}", at));
  };
  const auto x_of = [&](std::size_t i) { return left + wide * static_cast<double>(i); };
  const double most_removed = std::max(1e-9, *std::max_element(removed.begin(), removed.end()));
  double most_feed = 1e-9;
  for (std::size_t i = 0; i < bins; ++i) most_feed = std::max(most_feed, cut[i] + air[i]);
  const double gap = wide > 3 ? 0.5 : 0;
  axis(first_top, most_removed, "material removed, mm&sup3;");
  for (std::size_t i = 0; i < bins; ++i)
    out += bar(x_of(i) + gap, first_top + panel * (1 - removed[i] / most_removed), wide - 2 * gap, first_top + panel,
               "#4e79a7");
  out += rule(first_top + panel, "#444");
  axis(second_top, most_feed,
       "feed, mm: <tspan fill=\"#4e79a7\">in material</tspan>, <tspan fill=\"#c96a0a\">in air</tspan>");
  for (std::size_t i = 0; i < bins; ++i) {
    const double bottom = second_top + panel, middle = bottom - panel * cut[i] / most_feed;
    out += bar(x_of(i) + gap, middle, wide - 2 * gap, bottom, "#4e79a7");
    out += bar(x_of(i) + gap, middle - panel * air[i] / most_feed, wide - 2 * gap, middle, "#f28e2b");
  }
  out += rule(second_top + panel, "#444");
  const double step = std::max(1.0, step_for(last, 10));
  for (double line = step; line <= last; line += step)
    out += text(left + (width - left - right) * (line - 0.5) / last, second_top + panel + 26, "middle",
                fmt::format("{:.0f}", line));
  out += text((left + width - right) / 2, height - 8, "middle", "line of the program");
  std::set<std::size_t> wrong;
  for (const SimulationEvent& e : report.events)
    if (e.move.line > 0) wrong.insert(bin_of(e.move.program, e.move.line));
  for (const std::size_t i : wrong) {
    const double x = x_of(i) + wide / 2, y = second_top + panel + 3;
    out += fmt::format("<path d=\"M{:.2f} {:.1f}l4 8h-8z\" fill=\"#b2182b\"/>\n", x, y);
  }
  return out + "</svg>\n";
}

std::string colour_bar(const std::vector<Colour>& colours, int bar_width) {
  std::string out = fmt::format(
      "<svg class=\"bar\" width=\"{0}\" height=\"14\" viewBox=\"0 0 {0} 14\" shape-rendering=\"crispEdges\">",
      bar_width);
  const double wide = static_cast<double>(bar_width) / static_cast<double>(colours.size());
  for (std::size_t i = 0; i < colours.size(); ++i)
    out += bar(wide * static_cast<double>(i), 0, wide, 14, text_of(colours[i]));
  return out + "</svg>";
}

}  // namespace fieldfab::cam
