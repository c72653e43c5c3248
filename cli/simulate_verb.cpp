// simulate: a program carried out on a stock.
#include <fmt/format.h>

#include "fieldfab/asdf/asdf.h"
#include "fieldfab/cam/simulation.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/field/bounds.h"
#include "fieldfab/mesh/mesh_field.h"
#include "verbs.h"

namespace fieldfab::cli {
namespace {

class SimulateVerb final : public Verb {
 public:
  void declare(CLI::App& app) override {
    verb_ = app.add_subcommand("simulate", "carry out a machine's program on a stock: what is left, and what goes wrong");
    verb_->add_option("PROGRAM", program_, "G-code (.nc, .ngc, .tap, ...), ShopBot .sbp, Roland .rml or HPGL .plt")->required();
    verb_
        ->add_option("--setup", setup_,
                     "the set-up, or the job that the program was planned by: a .toml file (docs/simulation.md)")
        ->required();
    verb_->add_option("-o,--output", output_, "the stock that is left: .stl, .ply, .off, .obj, .3mf or .asdf");
    verb_->add_option("--target", target_, "the model to compare with, instead of the set-up's");
    verb_->add_option("--cell", cell_, "distance of samples, mm, instead of the set-up's")->check(CLI::PositiveNumber);
    verb_->add_option("--gouge", gouge_, "how deep a cut into the target is one, mm")->check(CLI::NonNegativeNumber);
    verb_->add_option("--report", report_, "also write the report, with what each line did: a .json file");
  }

  Outcome run(Progress& progress) override {
    cam::SimulationSetup setup = cam::read_simulation_setup(setup_, progress);
    if (!target_.empty()) setup.target = load_model(target_, Scripts::run, progress).field;
    if (cell_) setup.sampling.cell = *cell_;
    if (gouge_) setup.gouge = *gouge_;
    cam::Simulation simulation(std::move(setup), progress);
    simulation.run(program_, progress);
    simulation.finish(progress);
    if (!output_.empty()) write_stock(simulation, progress);
    return report(simulation);
  }

 private:
  void write_stock(const cam::Simulation& simulation, Progress& progress) const {
    if (!output_.ends_with(".asdf")) return write_mesh(simulation.mesh(), output_, progress);
    const FieldPtr solid = mesh_field(simulation.mesh(), progress);
    const double cell = simulation.stock().lattice().spacing().minCoeff();
    const auto asdf = Asdf::build(*solid, simulation.mesh().bounds().grown(2 * cell), {cell, -1, true}, progress);
    asdf->save(output_, {}, progress);
  }

  [[nodiscard]] Outcome report(const cam::Simulation& simulation) const {
    const cam::SimulationReport& r = simulation.report();
    for (const cam::ReadingNote& note : r.notes)
      fmt::print(stderr, "fieldfab: note: {}:{}: {}\n", program_, note.line, note.message);
    for (const cam::SimulationEvent& e : r.events)
      fmt::print(stderr, "fieldfab: {}:{}: {}: {}\n", program_, e.line, cam::to_string(e.kind), e.message);
    Outcome outcome;
    outcome.json = nlohmann::ordered_json::parse(cam::to_json(r, false));
    if (!report_.empty()) write_file(report_, cam::to_json(r, true));
    if (!output_.empty()) outcome.json["output"] = output_;
    const int seconds = static_cast<int>(r.seconds);
    outcome.line = fmt::format(
        "{}: {} moves, {}:{:02d} min, {:.0f} mm3 removed, {:.0f} % of the feed in air; {}", program_, r.moves, seconds / 60,
        seconds % 60, r.removed, 100 * r.air_share(),
        r.good() ? "nothing is wrong" : fmt::format("{} thing{} wrong", r.events.size(), r.events.size() == 1 ? "" : "s"));
    if (r.deviation)
      outcome.line +=
          fmt::format("; against the target {:.3f} mm too deep, {:.3f} mm left", r.deviation->deepest, r.deviation->highest);
    outcome.code = r.good() ? 0 : 1;
    return outcome;
  }

  std::string program_, setup_, output_, target_, report_;
  std::optional<double> cell_, gouge_;
};

}  // namespace

std::unique_ptr<Verb> simulate_verb() { return std::make_unique<SimulateVerb>(); }

}  // namespace fieldfab::cli
