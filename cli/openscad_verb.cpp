// openscad: makes the meshes that a design requests through fieldfab.scad, then runs OpenSCAD.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "fieldfab/core/error.h"
#include "fieldfab/core/text.h"
#include "fieldfab/openscad/bridge.h"
#include "streams.h"
#include "verbs.h"

namespace fieldfab::cli {
namespace {

class OpenscadVerb final : public Verb {
 public:
  void declare(CLI::App& app) override {
    verb_ = app.add_subcommand("openscad",
                               "make the meshes that an OpenSCAD design takes from fieldfab.scad (scans, formulas, "
                               "fillets), then run OpenSCAD");
    verb_->add_option("FILE", file_, "the design: a .scad file that says use <fieldfab.scad> (docs/openscad.md)")
        ->required();
    verb_->add_option("-o,--output", outputs_,
                      "output of OpenSCAD: .stl .off .amf .3mf .csg .png ...; may be given several times");
    verb_->add_flag("--watch", watch_,
                    "keep running, and make the meshes again when a file changes, until interrupted");
  }

  Outcome run(Progress& progress) override {
    openscad::CacheReport report = round(progress);
    Outcome outcome;
    outcome.line =
        fmt::format("{}: {} mesh{} made, {} kept{}", file_, report.made, report.made == 1 ? "" : "es", report.kept,
                    outputs_.empty() ? "" : fmt::format("; OpenSCAD wrote {}", fmt::join(outputs_, ", ")));
    outcome.json = {
        {"file", file_}, {"made", report.made}, {"kept", report.kept}, {"outputs", outputs_}, {"notes", report.notes}};
    if (watch_) watch(report, progress);
    return outcome;
  }

 private:
  openscad::CacheReport round(Progress& progress) const {
    openscad::CacheReport report = openscad::refresh_cache(file_, progress);
    print_notes(report.notes);
    for (const std::string& output : outputs_) openscad::export_design(file_, output, progress);
    return report;
  }

  using Times = std::vector<std::filesystem::file_time_type>;
  static Times times_of(const std::vector<std::filesystem::path>& files) {
    Times times;
    std::error_code ignored;  // an editor may be replacing the file
    for (const auto& file : files) times.push_back(std::filesystem::last_write_time(file, ignored));
    return times;
  }

  [[noreturn]] void watch(openscad::CacheReport report, Progress& progress) const {
    tell({"fieldfab: watching ", printable(file_), "; Ctrl-C ends\n"});
    for (Times before = times_of(report.sources);;) {
      progress.check();
      std::this_thread::sleep_for(std::chrono::milliseconds(90));
      const Times now = times_of(report.sources);
      if (now == before) continue;
      before = now;
      try {
        report = round(progress);
        before = times_of(report.sources);
        tell({fmt::format("fieldfab: {} made, {} kept\n", report.made, report.kept)});
      } catch (const Error& error) {
        if (error.kind() == ErrorKind::cancelled || error.kind() == ErrorKind::internal) throw;
        tell({"fieldfab: ", printable(error.what()), "\n"});  // the next save may correct it
      }
    }
  }

  std::string file_;
  std::vector<std::string> outputs_;
  bool watch_ = false;
};

}  // namespace

std::unique_ptr<Verb> openscad_verb() { return std::make_unique<OpenscadVerb>(); }

}  // namespace fieldfab::cli
