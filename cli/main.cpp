// The `fieldfab` command: options in, one verb, one line out. docs: `fieldfab --help`, README.md.
#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <new>

#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/core/text.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/openscad/design.h"
#include "verbs.h"

namespace fieldfab::cli {
namespace {

enum ExitCode { done = 0, check_failed = 1, bad_input = 2, internal_error = 3, cancelled = 130 };

Progress* running = nullptr;
void on_interrupt(int) {
  if (running != nullptr) running->cancel();
}

int exit_code(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::cancelled: return cancelled;
    case ErrorKind::internal: return internal_error;
    default: return bad_input;
  }
}

int complain(int code, const std::string& message) {
  fmt::print(stderr, "fieldfab: {}\n", printable(message));
  return code;
}

/// Reports progress on one line that is written over and over, to terminals only unless forced.
class ProgressLine {
 public:
  explicit ProgressLine(bool wanted) : wanted_(wanted) {}
  void operator()(double fraction, const std::string& message) {
    const int percent = static_cast<int>(100 * fraction);
    if (!wanted_ || (percent == percent_ && message == message_)) return;
    percent_ = percent;
    message_ = message;
    fmt::print(stderr, "\r\033[K{:3d}% {}", percent, message);
    std::fflush(stderr);
    shown_ = true;
  }
  void clear() {
    if (shown_) fmt::print(stderr, "\r\033[K");
  }

 private:
  bool wanted_, shown_ = false;
  int percent_ = -1;
  std::string message_;
};

int run(int argc, char** argv) {
  CLI::App app{
      "Fieldfab: solids from formulas, scans and meshes; pictures, watertight meshes and checks of them.\n"
      "MODEL is a .math prefix string, a .vm program, .frep text, a .py script (which is run), an OpenSCAD design (.scad .csg) "
      "or "
      "an .asdf file. Lengths are in mm."};
  app.name("fieldfab");
  app.require_subcommand(1);
  app.set_version_flag("--version", std::string(FIELDFAB_VERSION));
  bool json = false, show_progress = false;
  int threads = 0;
  app.add_flag("--json", json, "print the summary as one JSON object");
  app.add_flag("--progress", show_progress, "show progress even where stderr is not a terminal");
  app.add_option("--threads", threads, "threads to use; 0, the default, means all cores")->check(CLI::Range(0, 4096));
  std::string evaluator = "automatic";
  app.add_option("--evaluator", evaluator,
                 "how formulas are evaluated: automatic, reference, portable, avx2, avx512, jit, jit-avx2, jit-avx512");
  app.fallthrough();

  std::vector<std::unique_ptr<Verb>> verbs;
  for (auto make : {build_verb, mesh_verb, render_verb, check_verb, info_verb, convert_verb, edit_verb, cam_verb, simulate_verb,
                    openscad_verb}) {
    verbs.push_back(make());
    verbs.back()->declare(app);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help and --version
    return complain(bad_input, std::string(error.what()) + " (see fieldfab --help)");
  }

  try {
    frep::set_default_evaluator(frep::evaluator_named(evaluator));
  } catch (const Error& error) {
    return complain(bad_input, error.what());
  }
  openscad::add_model_readers();
  const ThreadLimit limit(threads);
  ProgressLine line(show_progress || ::isatty(STDERR_FILENO) != 0);
  Progress progress(std::ref(line));
  running = &progress;
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  int code = internal_error;
  std::string complaint;
  try {
    for (const auto& verb : verbs)
      if (verb->chosen()) {
        const Outcome outcome = verb->run(progress);
        line.clear();
        fmt::print("{}\n", json ? outcome.json.dump() : outcome.line);
        if (std::fflush(stdout) != 0) return complain(bad_input, "cannot write to the standard output");
        return outcome.code;
      }
  } catch (const Error& error) {
    code = exit_code(error.kind());
    complaint = error.what();
  } catch (const std::filesystem::filesystem_error& error) {  // a folder that cannot be read, for instance
    code = bad_input;
    complaint = fmt::format("{}: {}", error.path1().string(), error.code().message());
  } catch (const std::bad_alloc&) {
    code = bad_input;
    complaint = "there is not enough memory for this";
  } catch (const std::exception& error) {
    complaint = fmt::format("internal error: {}", error.what());
  }
  line.clear();
  return complain(code, complaint);
}

}  // namespace
}  // namespace fieldfab::cli

int main(int argc, char** argv) { return fieldfab::cli::run(argc, argv); }
