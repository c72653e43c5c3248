// simulate: carries out a program on a stock.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fieldfab/asdf/asdf.h"
#include "fieldfab/cam/simulate/frames.h"
#include "fieldfab/cam/simulate/html_report.h"
#include "fieldfab/cam/simulate/picture.h"
#include "fieldfab/cam/simulate/report_json.h"
#include "fieldfab/cam/simulate/simulate.h"
#include "fieldfab/core/angle.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/text.h"
#include "fieldfab/field/bounds.h"
#include "fieldfab/mesh/mesh_field.h"
#include "streams.h"
#include "verbs.h"

namespace fieldfab::cli {
namespace {

class SimulateVerb final : public Verb {
 public:
  void declare(CLI::App& app) override {
    verb_ =
        app.add_subcommand("simulate", "simulate a machine's program on a stock: the material left, and the faults");
    verb_->add_option(
        "PROGRAM", programs_,
        "G-code (.nc, .ngc, .tap, ...), ShopBot .sbp, Roland .rml or HPGL .plt; several are carried out one after the "
        "other, none: those that the set-up names");
    verb_
        ->add_option("--setup", setup_,
                     "the set-up, or the job that the program was planned by: a .toml file (docs/simulation.md); or a "
                     "project of CAMotics "
                     "(.camotics)")
        ->required();
    verb_->add_option(
        "--dialect", dialect_,
        "the control that G-code was written for, instead of the set-up's: linuxcnc, fanuc, grbl or mach3");
    verb_->add_option("-o,--output", output_,
                      "the remaining stock: " + stock_formats() + "; the last one loses nothing, for the next set-up");
    verb_->add_option("--target", target_, "the model to compare with, instead of the set-up's");
    verb_->add_option("--cell", cell_, "sample spacing, mm, instead of the set-up's")->check(CLI::PositiveNumber);
    verb_->add_option("--gouge", gouge_, "depth from which a cut into the target is a gouge, mm")
        ->check(CLI::NonNegativeNumber);
    verb_->add_option(
        "--report", reports_,
        "also write the report: an .html page with pictures, or a .json file with what each line did; may be given "
        "several times");
    verb_->add_option("--picture", picture_, "also a picture of the remaining stock: a .png");
    verb_->add_option("--frames", frames_,
                      "also pictures of the stock while it is machined, for a video: a folder for frame_0001.png, ...");
    verb_
        ->add_option("--frame-count", frame_settings_.count,
                     "number of these pictures, equally spaced in time; the default is 100")
        ->check(CLI::Range(1, 100'000));
    verb_->add_option("--size", size_, "pixels along the pictures' longer side")->check(CLI::Range(16, 8192));
    verb_->add_option("--alpha", alpha_, "turn about z, degrees; for the pictures");
    verb_->add_option("--beta", beta_, "then tilt about x, degrees; 0 looks from above, -90 from the front");
    verb_
        ->add_option("--colours", colours_,
                     "meaning of the colours of pictures; the default is the deviation if there is a target")
        ->check(CLI::IsMember({"deviation", "tool", "line"}));
  }

  Outcome run(Progress& progress) override {
    check_outputs();
    cam::SimulationSetup setup = cam::read_simulation_setup(setup_, progress, openscad::all_formats());
    if (!target_.empty()) {
      OpenSettings settings;
      settings.scripts = Scripts::run;
      settings.formats = &openscad::all_formats();
      setup.target = united(open_model(target_, settings, progress)).field;
    }
    if (!dialect_.empty()) setup.machine.dialect = cam::dialect_named(dialect_, "--dialect");
    if (cell_) setup.sampling.cell = *cell_;
    if (gouge_) setup.gouge = *gouge_;
    if (colours_ == "deviation" && !setup.target)
      throw Error(ErrorKind::bad_input, "--colours", "there is no target to tell deviations from");
    const cam::SimulationOptions options{.remember = !frames_.empty()};
    const cam::SimulationResult result = cam::simulate(
        std::move(setup), std::vector<std::filesystem::path>(programs_.begin(), programs_.end()), options, progress);
    if (!output_.empty()) write_stock(result, progress);
    if (!frames_.empty()) {
      look_from(frame_settings_);
      cam::write_frames(result, frames_, frame_settings_, progress);
    }
    return report(result, progress);
  }

 private:
  static std::string stock_formats() {
    return openscad::all_formats().writable({FormatKind::mesh}) + " .asdf .fieldstock";
  }

  /// Checks output names before the work, so that an invalid name is reported at once.
  void check_outputs() const {
    const std::optional<FormatKind> written = openscad::all_formats().written(output_);
    if (!output_.empty() && written != FormatKind::mesh && extension_of(output_) != ".asdf" &&
        extension_of(output_) != ".fieldstock")
      throw Error(ErrorKind::bad_input, output_,
                  fmt::format("cannot write a stock as '{}'; known are {}", extension_of(output_), stock_formats()));
    for (const std::string& path : reports_)
      if (extension_of(path) != ".json" && extension_of(path) != ".html")
        throw Error(ErrorKind::bad_input, path, "a report is a .html or a .json file");
    if (!picture_.empty() && extension_of(picture_) != ".png")
      throw Error(ErrorKind::bad_input, picture_, "a picture of a stock is a .png");
  }

  void write_stock(const cam::SimulationResult& result, Progress& progress) const {
    if (extension_of(output_) != ".asdf") return cam::write_stock_mesh(result, output_, progress);
    const FieldPtr solid = mesh_field(result.surface().mesh, progress);
    const double cell = result.stock().lattice().spacing().minCoeff();
    const auto asdf = Asdf::build(*solid, result.surface().mesh.bounds().grown(2 * cell), {cell, -1, true}, progress);
    asdf->save(output_, {}, progress);
  }

  [[nodiscard]] Outcome report(const cam::SimulationResult& result, Progress& progress) const {
    const cam::SimulationReport& r = result.report();
    const auto name = [&](int program) { return r.programs[static_cast<std::size_t>(program)].string(); };
    std::vector<std::string> names;
    for (const std::filesystem::path& program : r.programs) names.push_back(program.string());
    for (const cam::SimulationNote& note : r.notes)
      tell(
          {"fieldfab: note: ", printable(fmt::format("{}:{}: {}", name(note.program), note.line, note.message)), "\n"});
    for (const cam::SimulationEvent& e : r.events)
      tell({"fieldfab: ",
            printable(fmt::format("{}:{}: {}: {}", name(e.move.program), e.move.line, cam::name_of(e.kind), e.message)),
            "\n"});
    Outcome outcome;
    outcome.json = cam::json_of(r, false);
    for (const std::string& path : reports_)
      if (extension_of(path) == ".html")
        cam::write_html_report(result, path, progress);
      else
        write_file(path, cam::to_json(r, true));
    if (!picture_.empty()) write_picture(result, progress);
    if (!output_.empty()) outcome.json["output"] = output_;
    const int seconds = static_cast<int>(r.seconds);
    outcome.line =
        fmt::format("{}: {} moves, {}:{:02d} min, {:.0f} mm3 removed, {:.0f} % of the feed in air; {}",
                    fmt::join(names, ", "), r.moves, seconds / 60, seconds % 60, r.removed, 100 * r.air_share(),
                    r.good() ? "nothing is wrong"
                             : fmt::format("{} thing{} wrong", r.events.size(), r.events.size() == 1 ? "" : "s"));
    if (r.deviation)
      outcome.line += fmt::format("; against the target {:.3f} mm too deep, {:.3f} mm left", r.deviation->deepest,
                                  r.deviation->highest);
    outcome.code = r.good() ? 0 : 1;
    return outcome;
  }

  /// Applies the options of the view.
  template <class View>
  void look_from(View& view) const {
    if (size_) view.size = *size_;
    if (alpha_) view.alpha = *alpha_ * radians_per_degree;
    if (beta_) view.beta = *beta_ * radians_per_degree;
  }

  void write_picture(const cam::SimulationResult& result, Progress& progress) const {
    cam::StockPictureSettings view;
    look_from(view);
    if (!colours_.empty())
      view.colouring = colours_ == "deviation" ? cam::StockColouring::deviation
                       : colours_ == "tool"    ? cam::StockColouring::tool
                                               : cam::StockColouring::line;
    cam::write_stock_picture(result, picture_, view, progress);
  }

  std::string setup_, dialect_, output_, target_, picture_, colours_, frames_;
  std::vector<std::string> programs_, reports_;
  cam::FrameSettings frame_settings_;
  std::optional<int> size_;
  std::optional<double> cell_, gouge_, alpha_, beta_;
};

}  // namespace

std::unique_ptr<Verb> simulate_verb() { return std::make_unique<SimulateVerb>(); }

}  // namespace fieldfab::cli
