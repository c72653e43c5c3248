// The `fieldfab` command: reads options, runs one verb, prints one line. docs: `fieldfab --help`,
// README.md.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <new>
#include <sstream>
#include <system_error>

#include "ending.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/core/text.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/openscad/design.h"
#include "streams.h"
#include "verbs.h"

namespace fieldfab::cli {
namespace {

int exit_code(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::cancelled: return cancelled;
    case ErrorKind::internal: return internal_error;
    default: return bad_input;
  }
}

int complain(int code, const std::string& message) {
  tell({"fieldfab: ", printable(message), "\n"});
  return code;
}

/// Shows progress on one line that is overwritten; on terminals only, unless forced.
class ProgressLine {
 public:
  void show(bool wanted) { wanted_ = wanted; }
  void operator()(double fraction, const std::string& message) {
    const int percent = static_cast<int>(100 * fraction);
    if (!wanted_ || (percent == percent_ && message == message_)) return;
    percent_ = percent;
    message_ = message;
    tell({fmt::format("\r\033[K{:3d}% ", percent), message});
    shown_ = true;
  }
  void clear() const {
    if (shown_) tell({"\r\033[K"});
  }

 private:
  bool wanted_ = false, shown_ = false;
  int percent_ = -1;
  std::string message_;
};

/// Returns the line, or the JSON object, for a verb's outcome.
std::string text_of(const Outcome& outcome, bool json) {
  if (!json) return outcome.line + "\n";
  // File names may contain any bytes, JSON only UTF-8.
  return outcome.json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

int run(int argc, char** argv, ProgressLine& line, Progress& progress) {
  CLI::App app{
      "Fieldfab: solids from formulas, scans, meshes and OpenSCAD designs; watertight meshes, pictures and checks of "
      "them; toolpaths and their simulation.\n"
      "MODEL is a file of any of these kinds, such as .frep text, an .stl mesh or a .py script (which is run). Lengths "
      "are in mm."};
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
  for (auto make : {build_verb, mesh_verb, render_verb, check_verb, info_verb, convert_verb, edit_verb, cam_verb,
                    simulate_verb, openscad_verb, serve_verb}) {
    verbs.push_back(make());
    verbs.back()->declare(app);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0)
      throw Error(ErrorKind::bad_input, "", std::string(error.what()) + " (see fieldfab --help)");
    std::ostringstream text;  // of --help and --version
    app.exit(error, text, text);
    answer(text.str());
    return done;
  }
  frep::set_default_evaluator(frep::evaluator_named(evaluator));
  // Never ended: after an allocation failed within oneTBB 2022, the end of a limit may wait forever.
  static const ThreadLimit* const limit = std::make_unique<ThreadLimit>(threads).release();
  static_cast<void>(limit);
  line.show(show_progress || ::isatty(STDERR_FILENO) != 0);
  const auto chosen = std::find_if(verbs.begin(), verbs.end(), [](const auto& verb) { return verb->chosen(); });
  const Outcome outcome = (*chosen)->run(progress);
  line.clear();
  answer(text_of(outcome, json));
  return outcome.code;
}

/// Runs the command; reports errors.
int guarded(int argc, char** argv) {
  ProgressLine line;
  int code = internal_error;
  std::string complaint;
  try {
    Progress progress(std::ref(line));
    Ending ending(progress);
    try {
      code = run(argc, argv, line, progress);
      ending.settle();
      return code;
    } catch (...) {
      ending.settle();
      throw;
    }
  } catch (const Error& error) {
    code = exit_code(error.kind());
    complaint = error.what();
  } catch (const std::filesystem::filesystem_error& error) {  // for instance a folder that cannot be read
    code = bad_input;
    complaint = fmt::format("{}: {}", error.path1().string(), error.code().message());
  } catch (const std::bad_alloc&) {
    line.clear();
    tell({"fieldfab: there is not enough memory for this\n"});  // does not allocate memory
    return internal_error;
  } catch (const std::system_error& error) {  // for instance if a thread cannot be started
    complaint = fmt::format("the system refuses: {}", error.code().message());
  } catch (const std::exception& error) {
    complaint = fmt::format("internal error: {}", error.what());
  }
  line.clear();
  return complain(code, complaint);
}

}  // namespace
}  // namespace fieldfab::cli

int main(int argc, char** argv) {
  fieldfab::cli::open_closed_streams();
  try {
    return fieldfab::cli::guarded(argc, argv);
  } catch (const std::bad_alloc&) {  // thrown while an error message is built
    fieldfab::cli::tell({"fieldfab: there is not enough memory for this\n"});
    return fieldfab::cli::internal_error;
  }
}
