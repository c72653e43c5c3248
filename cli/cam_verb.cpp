// cam: from a job file to a machine's program.
#include <fmt/format.h>

#include "fieldfab/cam/job/job.h"
#include "fieldfab/cam/job/picture.h"
#include "fieldfab/core/error.h"
#include "verbs.h"

namespace fieldfab::cli {
namespace {

class CamVerb final : public Verb {
 public:
  void declare(CLI::App& app) override {
    verb_ = app.add_subcommand("cam", "plan toolpaths and write a machine's program");
    verb_->add_option("JOB", job_, "the job: a .toml file with a part, a machine, tools and operations (docs/cam.md)")
        ->required();
    verb_->add_option("-o,--output", output_, "the program to write");
    verb_->add_option("--picture", pictures_, "also draw the toolpaths: a .png or an .svg; may be given several times");
    verb_->add_option("--colour", colour_, "of the picture: by order or by depth")
        ->check(CLI::IsMember({"order", "depth"}));
    verb_->add_flag("--oblique", oblique_, "draw the picture from the front and above, not from straight above");
    verb_->add_option("--sheet", sheet_, "also write a set-up sheet, an .html file");
    verb_->add_flag("--optimise", optimise_,
                    "adjust feeds to the material that each move removes: slower in corners, faster in air");
    verb_->add_flag("--plan", plan_, "show the chain of stages and all settings, and stop");
  }

  Outcome run(Progress& progress) override {
    cam::Job job = cam::Job::read(job_, progress, openscad::all_formats());
    if (plan_) return {job.plan(), {{"plan", job.plan()}}, 0};
    if (output_.empty()) throw Error(ErrorKind::bad_input, "-o", "name the program to write, or ask for --plan");
    if (optimise_ && !job.adjusts_feeds()) job.adjust_feeds({});
    job.run(progress);
    job.write(output_, progress);
    for (const std::string& picture : pictures_)
      cam::write_picture(job.program(), picture,
                         {colour_ == "depth" ? cam::Colouring::depth : cam::Colouring::order, 1024, oblique_, true});
    if (!sheet_.empty()) cam::write_setup_sheet(job, sheet_);
    return report(job);
  }

 private:
  [[nodiscard]] Outcome report(const cam::Job& job) const {
    Outcome outcome;
    auto operations = nlohmann::ordered_json::array();
    double seconds = 0, planned = 0, cut = 0, rapid = 0;
    for (const cam::OperationReport& r : job.reports()) {
      planned += r.planned_seconds.value_or(r.seconds);
      seconds += r.seconds, cut += r.length.cut, rapid += r.length.rapid;
      operations.push_back({{"name", r.name},
                            {"paths", r.paths},
                            {"cut", r.length.cut},
                            {"rapid", r.length.rapid},
                            {"air_before", r.air.before},
                            {"air_after", r.air.after},
                            {"seconds", r.seconds}});
    }
    print_notes(job.notes());
    outcome.line =
        fmt::format("{}: {}, {} operation{}, {:.1f} m cut, {:.1f} m of rapids, about {}:{:02d} min", output_,
                    job.machine().name, job.reports().size(), job.reports().size() == 1 ? "" : "s", cut / 1000,
                    rapid / 1000, static_cast<int>(seconds) / 60, static_cast<int>(seconds) % 60);
    if (job.adjusts_feeds())
      outcome.line += fmt::format("; {}:{:02d} with the planned feeds", static_cast<int>(planned) / 60,
                                  static_cast<int>(planned) % 60);
    outcome.json = {{"output", output_},  {"machine", job.machine().name}, {"operations", operations},
                    {"seconds", seconds}, {"planned_seconds", planned},    {"cut", cut},
                    {"rapid", rapid},     {"notes", job.notes()}};
    return outcome;
  }

  std::string job_, output_, sheet_, colour_ = "order";
  std::vector<std::string> pictures_;
  bool plan_ = false, oblique_ = false, optimise_ = false;
};

}  // namespace

std::unique_ptr<Verb> cam_verb() { return std::make_unique<CamVerb>(); }

}  // namespace fieldfab::cli
