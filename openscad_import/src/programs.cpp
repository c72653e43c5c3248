#include "programs.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "fieldfab/core/child.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

namespace fieldfab::openscad {
namespace {

/// Returns the lines of a message that describe an error, or the whole message if there are none.
std::string complaint_of(const std::string& said) {
  std::string told, all;
  for (std::size_t at = 0; at < said.size();) {
    const std::size_t end = std::min(said.find('\n', at), said.size());
    const std::string line = said.substr(at, end - at);
    at = end + 1;
    if (line.empty()) continue;
    all += (all.empty() ? "" : "; ") + line;
    if (line.find("ERROR") != std::string::npos || line.find("rror:") != std::string::npos ||
        line.find("Can't") != std::string::npos)
      told += (told.empty() ? "" : "; ") + line;
  }
  return (told.empty() ? all : told).substr(0, 1000);
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "fieldfab-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw Error(ErrorKind::io, name, std::strerror(errno));
  folder_.emplace(std::move(name));
}

std::string run_openscad(const std::filesystem::path& input, const std::filesystem::path& output, Progress& progress,
                         const std::vector<std::string>& options) {
  require_regular_file(input);
  std::vector<std::string> words{"openscad"};
  words.insert(words.end(), options.begin(), options.end());
  // Absolute names cannot be mistaken for options, and OpenSCAD works in the folder of its input.
  for (const std::string& word :
       {std::string("-o"), std::filesystem::absolute(output).string(), std::filesystem::absolute(input).string()})
    words.push_back(word);
  Child child({.words = words, .errors_too = true},
              "is not installed (Debian's package openscad): .scad files, text() and some imports need it");
  std::string said;
  constexpr std::size_t most = 16'000'000;  // bytes; an echo in a loop prints a lot
  while (child.read(said)) {
    progress.check();
    progress.report(0, "OpenSCAD reads " + input.filename().string());
    if (said.size() > most) said.resize(most);
  }
  const int status = child.wait();
  if (WIFSIGNALED(status))
    throw Error(ErrorKind::bad_input, input.string(), fmt::format("OpenSCAD was ended by signal {}", WTERMSIG(status)));
  // After a failed assertion OpenSCAD writes a file and exits with 0.
  const bool complained = said.starts_with("ERROR:") || said.find("\nERROR:") != std::string::npos;
  if (WEXITSTATUS(status) != 0 || complained || !std::filesystem::exists(output)) {
    const std::string complaint = complaint_of(said);
    throw Error(ErrorKind::bad_input, input.string(),
                complaint.empty() ? fmt::format("OpenSCAD failed with status {}", WEXITSTATUS(status))
                                  : "OpenSCAD says: " + complaint);
  }
  return said;
}

}  // namespace fieldfab::openscad
