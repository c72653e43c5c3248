// Simulation report as one HTML page.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <set>

#include "base/html.h"
#include "fieldfab/cam/simulate/html_report.h"
#include "fieldfab/cam/simulate/picture.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/mapped_file.h"
#include "report_charts.h"

namespace fieldfab::cam {
namespace {

constexpr const char* style = R"(<style>
.verdict { font-size: 1.1em; padding: .6em .9em; border-left: .4em solid }
.good { background: #e7f4e8; border-color: #2e7d32 } .bad { background: #fbe9e7; border-color: #b2182b }
.views { display: grid; grid-template-columns: 1fr 1fr; gap: 1em }
figure { margin: 0; break-inside: avoid } figure img { width: 100%; border: 1px solid #ccc }
figcaption { margin-top: .2em; font-size: .85em; color: #555 }
.close { margin-top: 1em; grid-template-columns: 1fr 1fr 1fr }
code { font: .9em monospace; overflow-wrap: anywhere } .what { font-size: .85em; color: #555 }
tr { break-inside: avoid } h2 { break-after: avoid }
.number { display: inline-block; min-width: 1.6em; text-align: center; border-radius: .8em }
.marked { background: #191c24; color: #fff }
.n, .place { white-space: nowrap } th.n { text-align: right } .place { font-size: .85em }
.chart { width: 100%; break-inside: avoid } .chart text { font: 11px sans-serif; fill: #444 }
.bar { vertical-align: -2px; margin: 0 .3em }
.swatch { display: inline-block; width: .9em; height: .9em; margin-right: .5em; vertical-align: -1px }
@media print { * { print-color-adjust: exact; -webkit-print-color-adjust: exact } }
</style>
)";

// greatest number of rows for events and for notes; the JSON report has all
constexpr std::size_t most_rows = 1000;

/// The program's lines with these numbers, shortened if long.
std::map<int, std::string> quoted(const std::filesystem::path& program, const std::set<int>& wanted) {
  const MappedFile file(program);
  std::string_view text(reinterpret_cast<const char*>(file.bytes().data()), file.bytes().size());
  std::map<int, std::string> lines;
  int number = 1;
  for (auto next = wanted.begin(); next != wanted.end() && !text.empty(); ++number) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    if (number == *next) {
      constexpr std::size_t longest = 160;
      std::string& line = lines[number] = std::string(text.substr(0, std::min(length, longest)));
      if (length > longest) {
        // no partial UTF-8 sequences
        while (!line.empty() && (static_cast<unsigned char>(line.back()) & 0xc0U) == 0x80) line.pop_back();
        if (!line.empty() && static_cast<unsigned char>(line.back()) >= 0xc0) line.pop_back();
        line += " ...";
      }
      if (!line.empty() && line.back() == '\r') line.pop_back();
      ++next;
    }
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return lines;
}

std::string volume_text(double mm3) {
  return mm3 >= 1000 ? fmt::format("{:.0f} mm&sup3;", mm3) : fmt::format("{:.3g} mm&sup3;", mm3);
}

std::string amount_text(const SimulationEvent& event) {
  switch (event.kind) {
    case SimulationEvent::Kind::gouge:
    case SimulationEvent::Kind::excess: return fmt::format("{:.3f} mm", event.amount);
    case SimulationEvent::Kind::over_travel: return fmt::format("{:.4g} beyond", event.amount);
    default: return volume_text(event.amount);
  }
}

std::string tool_text(const Tool& tool) {
  std::string text = html_text(fmt::format("{}{}{}", tool.name, tool.name.empty() ? "" : ", ", name_of(tool.shape)));
  if (tool.diameter > 0) text += fmt::format(" {:.4g} mm", tool.diameter);
  return text;
}

/// An HTML page, built part by part.
class HtmlReport {
 public:
  HtmlReport(const SimulationResult& result, Progress& progress)
      : result_(result), report_(result.report()), setup_(result.setup()), progress_(progress) {
    const std::vector<std::size_t> marked = worst_events(result);
    marked_.insert(marked.begin(), marked.end());
  }

  std::string page() {
    add_heading();
    add_pictures();
    add_events();
    add_figures();
    add_tools();
    add_deviation();
    out_ += "<h2>Along the program</h2>\n" + lines_chart(report_);
    add_notes();
    return out_ + "</html>\n";
  }

 private:
  void add_heading() {
    std::vector<std::string> names;
    for (const std::filesystem::path& program : report_.programs) names.push_back(program.filename().string());
    out_ = html_start(fmt::format("Simulation of {}", fmt::join(names, ", "))) + style;
    out_ += fmt::format(
        "<p>Set-up {}{}{}, samples every {:.4g} mm</p>\n", html_text(setup_.name),
        setup_.file.empty() ? "" : " (" + html_text(std::filesystem::path(setup_.file).filename().string()) + ")",
        setup_.machine.name.empty() ? "" : ", " + html_text(setup_.machine.name), setup_.sampling.cell);
    if (report_.good()) {
      out_ += "<p class=\"verdict good\">Nothing is wrong.";
    } else {
      std::map<SimulationEvent::Kind, int> counts;
      for (const SimulationEvent& e : report_.events) ++counts[e.kind];
      std::vector<std::string> kinds;
      kinds.reserve(counts.size());
      for (const auto& [kind, count] : counts) kinds.push_back(fmt::format("{} &times; {}", count, name_of(kind)));
      out_ += fmt::format("<p class=\"verdict bad\">{} {} wrong: {}.", report_.events.size(),
                          report_.events.size() == 1 ? "thing is" : "things are", fmt::join(kinds, ", "));
    }
    if (report_.deviation)
      out_ += fmt::format(" Against the target at most {:.3f} mm too deep, {:.3f} mm left over.",
                          report_.deviation->deepest, report_.deviation->highest);
    else
      out_ += " There was no target to compare with.";
    out_ += "</p>\n";
  }

  void add_picture(const Image& image, const std::string& caption) {
    out_ +=
        fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", html_image(image, caption), html_text(caption));
  }

  void add_pictures() {
    using std::numbers::pi;
    constexpr std::array<const char*, 4> names{"From the front", "From behind", "From above", "From below"};
    std::array<StockPictureSettings, 4> views;
    for (StockPictureSettings& view : views) view.size = 800, view.aspect = 4.0 / 3;
    views[1].alpha += pi;
    views[2].alpha = views[2].beta = 0;
    views[3].beta = -pi - views[3].beta;
    out_ += "<h2>What is left</h2>\n" + colours_text() + "<div class=\"views\">\n";
    std::vector<TrianglePicture> pictures;
    for (std::size_t i = 0; i < views.size(); ++i) {
      pictures.push_back(stock_picture(result_, views[i], progress_));
      add_picture(pictures.back().image, names[i]);
    }
    out_ += "</div>\n";
    add_close_ups(views, pictures);
  }

  /// Adds magnified pictures of the worst places, each from the first view in which it is visible.
  void add_close_ups(const std::array<StockPictureSettings, 4>& views, const std::vector<TrianglePicture>& pictures) {
    const double reach = std::max(setup_.stock_box.diagonal() / 16, 12 * setup_.sampling.cell);
    std::size_t made = 0;
    for (const std::size_t i : worst_events(result_)) {
      const SimulationEvent& event = report_.events[i];
      for (std::size_t v = 0; v < views.size() && made < 3; ++v) {
        if (!shows_event(result_, pictures[v], event)) continue;
        // The material at a contact may be cut by now, so that nothing is visible there.
        Vec3 before = event.place;
        before -= pictures[v].turn.transpose() * Vec3(0, 0, reach / 2);
        if (shows_event(result_, pictures[v], {event.kind, {}, before, 0, ""})) continue;
        const Vec3 at = pictures[v].turn * event.place;
        StockPictureSettings near = views[v];
        near.size = 440;
        near.window = Box{at, at}.grown(reach);
        if (made++ == 0) out_ += "<div class=\"views close\">\n";
        add_picture(stock_picture(result_, near, progress_).image,
                    fmt::format("{}: {}, {:.3g} mm wide", i + 1, name_of(event.kind), 2 * reach));
        break;
      }
    }
    if (made) out_ += "</div>\n";
  }

  [[nodiscard]] std::string colours_text() const {
    std::string text = "<p>";
    switch (default_colouring(result_)) {
      case StockColouring::deviation: {
        const DeviationScale scale = DeviationScale::of(result_);
        std::vector<Colour> colours(80);
        for (std::size_t i = 0; i < 80; ++i)
          colours[i] = scale.colour(scale.full * (static_cast<double>(i) + 0.5 - 40) / 40);
        text += fmt::format(
            "Colours are deviations from the target: too deep by {0:.3g} mm or more {1} as much left over; grey is "
            "within "
            "&minus;{2:.3g} to +{3:.3g} mm.",
            scale.full, colour_bar(colours, 240), scale.gouge, scale.excess);
        break;
      }
      case StockColouring::tool: text += "Colours are the tools' (below); the stock's first surface is grey."; break;
      case StockColouring::line: {
        std::vector<Colour> colours(60);
        for (std::size_t i = 0; i < 60; ++i) colours[i] = colour_of_line(static_cast<double>(i) / 59);
        text += "Colours are the program's lines: the first ones " + colour_bar(colours, 180) +
                " the last ones; the stock's first surface is grey.";
        break;
      }
    }
    if (!report_.events.empty()) text += " Numbers are those of the events; pale ones lie behind what is seen.";
    return text + "</p>\n";
  }

  void add_events() {
    out_ += "<h2>What is wrong</h2>\n";
    if (report_.events.empty()) {
      out_ += "<p>Nothing.</p>\n";
      return;
    }
    const std::size_t rows = std::min(report_.events.size(), most_rows);
    std::vector<std::set<int>> wanted(report_.programs.size());
    for (std::size_t i = 0; i < rows; ++i)
      if (const CutMove& move = report_.events[i].move; move.line > 0)
        wanted[static_cast<std::size_t>(move.program)].insert(move.line);
    std::vector<std::map<int, std::string>> lines;
    for (std::size_t i = 0; i < wanted.size(); ++i) lines.push_back(quoted(report_.programs[i], wanted[i]));
    out_ +=
        "<table>\n<tr><th>No.</th><th>What</th><th>Line</th><th>Program</th><th>Tool</th><th>Place</th><th "
        "class=\"n\">Amount</th></tr>\n";
    for (std::size_t i = 0; i < rows; ++i) {
      const SimulationEvent& e = report_.events[i];
      out_ += fmt::format(
          "<tr><td><span class=\"number{}\">{}</span></td><td>{}<div class=\"what\">{}</div></td><td "
          "class=\"n\">{}</td>"
          "<td><code>{}</code></td><td class=\"n\">{}</td><td class=\"place\">{:.3f}, {:.3f}, {:.3f}</td><td "
          "class=\"n\">{}</td></tr>\n",
          marked_.contains(i) ? " marked" : "", i + 1, name_of(e.kind), html_text(e.message),
          line_text(e.move.line, e.move.program, "&ndash;"),
          e.move.line > 0 ? html_text(lines[static_cast<std::size_t>(e.move.program)][e.move.line]) : "",
          e.move.tool > 0 ? fmt::format("{}", e.move.tool) : "&ndash;", e.place.x(), e.place.y(), e.place.z(),
          amount_text(e));
    }
    out_ += "</table>\n";
    if (rows < report_.events.size()) out_ += fmt::format("<p>And {} more.</p>\n", report_.events.size() - rows);
  }

  /// A line number, with its program if there are several; `none` for 0.
  [[nodiscard]] std::string line_text(int line, int program, const char* none) const {
    if (line == 0) return none;
    if (report_.programs.size() == 1) return fmt::format("{}", line);
    return fmt::format("{}:{}", html_text(report_.programs[static_cast<std::size_t>(program)].filename().string()),
                       line);
  }

  void add_row(const char* name, const std::string& value) {
    out_ += fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", name, value);
  }

  void add_figures() {
    out_ += "<h2>Figures</h2>\n<table>\n";
    add_row("Machine time",
            fmt::format("{}, of it {} in rapids", html_time(report_.seconds), html_time(report_.rapid_seconds)));
    add_row("Feed", fmt::format("{:.2f} m in material, {:.2f} m in air: {:.0f} % in air", report_.cut / 1000,
                                report_.air / 1000, 100 * report_.air_share()));
    add_row("Rapids", fmt::format("{:.2f} m", report_.rapid / 1000));
    add_row("Moves", fmt::format("{}", report_.moves));
    add_row("Material removed", volume_text(report_.removed));
    add_row("Material left", volume_text(report_.left));
    out_ += "</table>\n";
  }

  void add_tools() {
    struct Sum {
      double seconds = 0, cut = 0, air = 0, removed = 0;
    };
    std::map<int, Sum> sums;
    for (const LineRecord& record : report_.lines) {
      Sum& sum = sums[record.tool];
      sum.seconds += record.seconds, sum.cut += record.cut, sum.air += record.air, sum.removed += record.removed;
    }
    const bool coloured = default_colouring(result_) == StockColouring::tool;
    out_ +=
        "<h2>Tools</h2>\n<table>\n<tr><th>No.</th><th>Tool</th><th class=\"n\">Time</th><th class=\"n\">In "
        "material</th><th "
        "class=\"n\" colspan=\"2\">In air</th><th class=\"n\">Removed</th></tr>\n";
    for (const auto& [number, sum] : sums) {
      const auto found = setup_.tools.find(number);
      const auto place = static_cast<std::size_t>(std::distance(setup_.tools.begin(), found)) + 1;
      std::string name = found != setup_.tools.end() ? tool_text(found->second) : "none";
      if (coloured && found != setup_.tools.end()) {
        const Colour c = colour_of_tool(place);
        name = fmt::format("<span class=\"swatch\" style=\"background: #{:02x}{:02x}{:02x}\"></span>{}", c[0], c[1],
                           c[2], name);
      }
      out_ += fmt::format(
          "<tr><td class=\"n\">{}</td><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{:.2f} m</td><td "
          "class=\"n\">{:.2f} "
          "m</td><td class=\"n\">{:.0f} %</td><td class=\"n\">{}</td></tr>\n",
          number, name, html_time(sum.seconds), sum.cut / 1000, sum.air / 1000,
          sum.cut + sum.air > 0 ? 100 * sum.air / (sum.cut + sum.air) : 0, volume_text(sum.removed));
    }
    out_ += "</table>\n";
  }

  void add_deviation() {
    if (!report_.deviation) return;
    const Deviation& d = *report_.deviation;
    out_ += "<h2>Deviation from the target</h2>\n<table>\n";
    add_row("Deepest gouge", fmt::format("{:.3f} mm (allowed: {:.3g} mm)", d.deepest, setup_.gouge));
    add_row("Highest excess",
            fmt::format("{:.3f} mm{}", d.highest,
                        setup_.excess > 0 ? fmt::format(" (allowed: {:.3g} mm)", setup_.excess) : ""));
    add_row("Mean, and root of mean square", fmt::format("{:.3f} mm, {:.3f} mm", d.mean, d.root_mean_square));
    out_ +=
        "</table>\n<p>Shares of the surface, by how far they are off (the outermost bars: and beyond; dashed: what is "
        "allowed):</p>\n";
    out_ += deviation_chart(result_, DeviationScale::of(result_));
  }

  void add_notes() {
    if (report_.notes.empty()) return;
    out_ += "<h2>Notes</h2>\n";
    const std::size_t rows = std::min(report_.notes.size(), most_rows);
    for (std::size_t i = 0; i < rows; ++i)
      out_ += fmt::format("<p class=\"note\">Line {}: {}</p>\n",
                          line_text(report_.notes[i].line, report_.notes[i].program, "0"),
                          html_text(report_.notes[i].message));
    if (rows < report_.notes.size()) out_ += fmt::format("<p>And {} more.</p>\n", report_.notes.size() - rows);
  }

  const SimulationResult& result_;
  const SimulationReport& report_;
  const SimulationSetup& setup_;
  Progress& progress_;
  std::set<std::size_t> marked_;
  std::string out_;
};

}  // namespace

void write_html_report(const SimulationResult& result, const std::filesystem::path& path, Progress& progress) {
  write_file(path, HtmlReport(result, progress).page());
}

}  // namespace fieldfab::cam
