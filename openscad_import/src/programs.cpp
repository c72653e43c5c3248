#include "programs.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "fieldfab/core/error.h"

namespace fieldfab::openscad {
namespace {

/// A program that runs in a group of its own, whose output is read here. It does not outlive this object.
class Child {
 public:
  explicit Child(const std::vector<std::string>& words) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw Error(ErrorKind::io, words[0], std::strerror(errno));
    output_ = ends[0];
    std::vector<char*> argv;
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);
    const int failure = posix_spawnp(&process_, argv[0], &actions, &attributes, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    close(ends[1]);
    if (failure == 0) return;
    process_ = 0;
    close(output_);
    throw Error(ErrorKind::io, words[0],
                failure == ENOENT ? "is not installed (Debian's package openscad): .scad files, text() and some imports need it"
                                  : std::strerror(failure));
  }
  ~Child() {
    if (process_ > 0) {
      kill(-process_, SIGKILL);
      waitpid(process_, nullptr, 0);
    }
    close(output_);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Adds what it wrote to `text`, waiting a little for more; false at its end.
  bool read(std::string& text) const {
    pollfd waiting{output_, POLLIN, 0};
    if (poll(&waiting, 1, 50) <= 0) return true;
    std::array<char, 65536> bytes;
    const ssize_t count = ::read(output_, bytes.data(), bytes.size());
    if (count > 0) text.append(bytes.data(), static_cast<std::size_t>(count));
    return count > 0 || (count < 0 && errno == EINTR);
  }
  /// Waits for its end; the status, as waitpid() tells it.
  int wait() {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = 0;
    return status;
  }

 private:
  pid_t process_ = 0;
  int output_ = -1;
};

/// The lines of a message that tell what is wrong; all of it where none does.
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
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string run_openscad(const std::filesystem::path& input, const std::filesystem::path& output, Progress& progress,
                         const std::vector<std::string>& options) {
  if (!std::filesystem::is_regular_file(input)) throw Error(ErrorKind::io, input.string(), "there is no such file");
  std::vector<std::string> words{"openscad"};
  words.insert(words.end(), options.begin(), options.end());
  // Absolute names cannot be taken for options, and OpenSCAD works in the folder of its input.
  for (const std::string& word :
       {std::string("-o"), std::filesystem::absolute(output).string(), std::filesystem::absolute(input).string()})
    words.push_back(word);
  Child child(words);
  std::string said;
  constexpr std::size_t most = 16'000'000;  // bytes; an echo in a loop says a lot
  while (child.read(said)) {
    progress.check();
    progress.report(0, "OpenSCAD reads " + input.filename().string());
    if (said.size() > most) said.resize(most);
  }
  const int status = child.wait();
  if (WIFSIGNALED(status))
    throw Error(ErrorKind::bad_input, input.string(), fmt::format("OpenSCAD was ended by signal {}", WTERMSIG(status)));
  // After a failed assertion OpenSCAD writes a file and calls it a success.
  const bool complained = said.starts_with("ERROR:") || said.find("\nERROR:") != std::string::npos;
  if (WEXITSTATUS(status) != 0 || complained || !std::filesystem::exists(output)) {
    const std::string complaint = complaint_of(said);
    throw Error(
        ErrorKind::bad_input, input.string(),
        complaint.empty() ? fmt::format("OpenSCAD failed with status {}", WEXITSTATUS(status)) : "OpenSCAD says: " + complaint);
  }
  return said;
}

}  // namespace fieldfab::openscad
