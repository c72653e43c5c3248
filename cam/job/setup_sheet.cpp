// The set-up sheet: one HTML file for the machine's operator.
#include <fmt/format.h>

#include <set>

#include "base/html.h"
#include "fieldfab/cam/job/picture.h"
#include "fieldfab/core/file.h"
#include "html_picture.h"

namespace fieldfab::cam {
namespace {

std::string length_or_dash(double mm) { return mm > 0 ? fmt::format("{:.4g} mm", mm) : "&ndash;"; }

}  // namespace

void write_setup_sheet(const Job& job, const std::filesystem::path& path) {
  const Program& program = job.program();
  const Box& stock = program.stock;
  const Vec3 size = stock.size();
  double seconds = 0;
  for (const OperationReport& r : job.reports()) seconds += r.seconds;
  std::string out = html_start(program.name);
  out += fmt::format("<p>{}{}, about {}</p>\n", html_text(job.machine().name),
                     job.material().empty() ? "" : ", " + html_text(job.material()), html_time(seconds));
  for (const std::string& note : job.notes()) out += fmt::format("<p class=\"note\">{}</p>\n", html_text(note));

  out += "<h2>Stock and zero</h2>\n<table>\n";
  out += fmt::format("<tr><th>Size</th><td>{:.2f} &times; {:.2f} &times; {:.2f} mm</td></tr>\n", size.x(), size.y(),
                     size.z());
  out += fmt::format(
      "<tr><th>Program zero</th><td>{:.2f} mm from the stock's left side, {:.2f} mm from its front, {:.2f} mm {} its "
      "top</td></tr>\n",
      -stock.lower.x(), -stock.lower.y(), std::abs(stock.upper.z()), stock.upper.z() >= 0 ? "below" : "above");
  out +=
      fmt::format("<tr><th>Corners</th><td>({:.3f}, {:.3f}, {:.3f}) to ({:.3f}, {:.3f}, {:.3f})</td></tr>\n</table>\n",
                  stock.lower.x(), stock.lower.y(), stock.lower.z(), stock.upper.x(), stock.upper.y(), stock.upper.z());

  out +=
      "<h2>Tools</h2>\n<table>\n<tr><th>No.</th><th>Name</th><th>Shape</th><th>Diameter</th><th>Flutes</th><th>Sticks "
      "out</th></tr>\n";
  std::set<int> shown;
  for (const Section& section : program.sections) {
    const Tool& t = section.tool;
    if (!shown.insert(t.number).second) continue;
    out += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", t.number,
                       html_text(t.name), name_of(t.shape), length_or_dash(t.diameter), length_or_dash(t.flute),
                       length_or_dash(t.length));
  }
  out +=
      "</table>\n<h2>Operations</h2>\n<table>\n<tr><th>Operation</th><th>Tool</th><th>Spindle</th><th>Feed</"
      "th><th>Depth</"
      "th><th>Cut</th><th>Rapids</th><th>Time</th></tr>\n";
  for (std::size_t i = 0; i < program.sections.size(); ++i) {
    const Section& s = program.sections[i];
    const OperationReport& r = job.reports()[i];
    double lowest = stock.upper.z();
    for (const Move& move : s.moves) lowest = std::min(lowest, move.to.z());
    out += fmt::format(
        "<tr><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{:.0f}</td><td class=\"n\">{:.0f} mm/min</td><td "
        "class=\"n\">{:.3f} mm</td><td class=\"n\">{:.2f} m</td><td class=\"n\">{:.2f} m</td><td "
        "class=\"n\">{}</td></tr>\n",
        html_text(s.name), s.tool.number, s.spindle, job.operations()[i].values.number("feed"),
        stock.upper.z() - lowest, r.length.cut / 1000, r.length.rapid / 1000, html_time(r.seconds));
  }
  out += "</table>\n<h2>Ways of the tool</h2>\n<p>From blue (first) to green (last), rapids red.</p>\n";
  for (std::size_t i = 0; i < program.sections.size(); ++i) {
    Program one;
    one.sections = {program.sections[i]};
    PictureSettings above, oblique;
    above.size = oblique.size = 480;
    oblique.oblique = true;
    if (!program.sections[i].setup.empty())
      out += fmt::format("<p class=\"note\">By hand: {}</p>\n", html_text(program.sections[i].setup));
    out += fmt::format("<h3>{}</h3>\n<div class=\"pictures\">\n{}{}</div>\n", html_text(program.sections[i].name),
                       html_picture(one, above), html_picture(one, oblique));
  }
  write_file(path, out + "</html>\n");
}

}  // namespace fieldfab::cam
