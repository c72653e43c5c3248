#include "fieldfab/solid/script.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>

#include "fieldfab/core/child.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

namespace fieldfab {
namespace {

constexpr auto longest_run = std::chrono::seconds(60);
constexpr std::size_t most_answer = 256'000'000;  // bytes of the answer

}  // namespace

std::string python_program() { return FIELDFAB_PYTHON; }

std::vector<std::string> python_environment() {
  std::vector<std::string> all;
  std::string path;
  for (char** entry = environ; *entry != nullptr; ++entry)
    if (std::strncmp(*entry, "PYTHONPATH=", 11) == 0)
      path = *entry + 11;
    else
      all.emplace_back(*entry);
  // The module of this build, or of the folder of the installation; Debian's Python finds its own modules itself. pip
  // puts the command into the module's folder.
  std::error_code ignored;
  const std::filesystem::path prefix =
      std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path().parent_path();
  for (const char* folder : {"python", "lib/python3/dist-packages", ".."}) {
    const std::filesystem::path modules = (prefix / folder).lexically_normal();
    if (prefix == "/usr" || !std::filesystem::exists(modules / "fieldfab", ignored)) continue;
    if (!path.empty()) path.insert(0, ":");
    path.insert(0, modules.string());
  }
  if (!path.empty()) all.push_back("PYTHONPATH=" + path);
  return all;
}

std::string run_script(const std::filesystem::path& path, Progress& progress) {
  require_regular_file(path);
  Child child({.words = {python_program(), "-P", "-m", "fieldfab.script", path.string()},
               .environment = python_environment(),
               .memory = available_memory() / 2});
  const auto started = std::chrono::steady_clock::now();
  std::string text;
  while (child.read(text)) {
    progress.check();
    progress.report(0, "running " + path.filename().string());
    if (std::chrono::steady_clock::now() - started > longest_run)
      throw Error(ErrorKind::bad_input, path.string(),
                  fmt::format("the script still runs after {} s; an endless loop?", longest_run.count()));
    if (text.size() > most_answer) throw Error(ErrorKind::too_large, path.string(), "the script's shape is too large");
  }
  const int status = child.wait();
  if (text.starts_with("ok\n")) return text.substr(3);
  if (text.starts_with("error ")) {
    const std::size_t space = text.find(' ', 6);
    const std::string line = text.substr(6, space - 6), message = text.substr(space + 1);
    throw Error(ErrorKind::bad_input, path.string() + (line == "0" ? "" : ":" + line), message);
  }
  if (WIFSIGNALED(status))
    throw Error(ErrorKind::bad_input, path.string(),
                fmt::format("the script was ended by signal {}", WTERMSIG(status)));
  throw Error(ErrorKind::bad_input, path.string(),
              "the script could not be run: Python's module fieldfab is not there, or out of memory");
}

}  // namespace fieldfab
