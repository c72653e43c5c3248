#include "fieldfab/model/script.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/frep/text.h"

namespace fieldfab {
namespace {

constexpr auto longest_run = std::chrono::seconds(60);
constexpr std::size_t most_text = 256'000'000;  // bytes of the answer

/// A child process in a group of its own, whose standard output is read here. It does not outlive this object.
class Child {
 public:
  Child(const std::vector<std::string>& arguments, const std::vector<std::string>& environment, std::uintmax_t memory) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw Error(ErrorKind::io, arguments[0], std::strerror(errno));
    std::vector<char*> argv, env;
    for (const std::string& word : arguments) argv.push_back(const_cast<char*>(word.c_str()));
    for (const std::string& word : environment) env.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr), env.push_back(nullptr);
    const rlimit limit{memory, memory};
    process_ = fork();
    if (process_ == 0) {  // only what is safe after a fork, from here on
      setpgid(0, 0);
      setrlimit(RLIMIT_AS, &limit);
      dup2(ends[1], STDOUT_FILENO);
      execve(argv[0], argv.data(), env.data());
      _exit(127);
    }
    close(ends[1]);
    output_ = ends[0];
    if (process_ < 0) {
      close(output_);
      throw Error(ErrorKind::io, arguments[0], std::strerror(errno));
    }
    setpgid(process_, process_);
  }
  ~Child() {
    stop();
    close(output_);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Adds what the process wrote to `text`, waiting a little for more; false at its end.
  bool read(std::string& text) const {
    pollfd waiting{output_, POLLIN, 0};
    if (poll(&waiting, 1, 50) <= 0) return true;
    std::array<char, 65536> bytes;
    const ssize_t count = ::read(output_, bytes.data(), bytes.size());
    if (count > 0) text.append(bytes.data(), static_cast<std::size_t>(count));
    return count > 0 || (count < 0 && errno == EINTR);
  }

  /// Kills it, and all it has started, where it still runs. Returns how it ended, as waitpid() tells.
  int stop() {
    if (process_ <= 0) return status_;
    kill(-process_, SIGKILL);
    waitpid(process_, &status_, 0);
    process_ = 0;
    return status_;
  }
  /// Waits for its end.
  int wait() {
    waitpid(process_, &status_, 0);
    kill(-process_, SIGKILL);  // what it left behind
    process_ = 0;
    return status_;
  }

 private:
  pid_t process_ = 0;
  int output_ = -1, status_ = 0;
};

}  // namespace

std::vector<std::string> python_environment() {
  std::vector<std::string> all;
  std::string path;
  for (char** entry = environ; *entry != nullptr; ++entry)
    if (std::strncmp(*entry, "PYTHONPATH=", 11) == 0)
      path = *entry + 11;
    else
      all.emplace_back(*entry);
  std::error_code ignored;
  const std::filesystem::path beside = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path() / "../python";
  if (std::filesystem::exists(beside / "fieldfab", ignored)) path = beside.string() + (path.empty() ? "" : ":" + path);
  if (!path.empty()) all.push_back("PYTHONPATH=" + path);
  return all;
}

frep::Expression run_script(const std::filesystem::path& path, Progress& progress) {
  if (!std::filesystem::is_regular_file(path)) throw Error(ErrorKind::io, path.string(), "there is no such file");
  Child child({"/usr/bin/python3", "-m", "fieldfab.script", path.string()}, python_environment(), available_memory() / 2);
  const auto started = std::chrono::steady_clock::now();
  std::string text;
  while (child.read(text)) {
    progress.check();
    progress.report(0, "running " + path.filename().string());
    if (std::chrono::steady_clock::now() - started > longest_run)
      throw Error(ErrorKind::bad_input, path.string(),
                  fmt::format("the script still runs after {} s; an endless loop?", longest_run.count()));
    if (text.size() > most_text) throw Error(ErrorKind::too_large, path.string(), "the script's shape is too large");
  }
  const int status = child.wait();
  if (text.starts_with("ok\n")) return frep::parse_vm(std::string_view(text).substr(3), path.string());
  if (text.starts_with("error ")) {
    const std::size_t space = text.find(' ', 6);
    const std::string line = text.substr(6, space - 6), message = text.substr(space + 1);
    throw Error(ErrorKind::bad_input, path.string() + (line == "0" ? "" : ":" + line), message);
  }
  if (WIFSIGNALED(status))
    throw Error(ErrorKind::bad_input, path.string(), fmt::format("the script was ended by signal {}", WTERMSIG(status)));
  throw Error(ErrorKind::bad_input, path.string(),
              "the script could not be run: Python's module fieldfab is not there, or out of memory");
}

}  // namespace fieldfab
