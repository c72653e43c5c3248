#include "fieldfab/core/child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "fieldfab/core/error.h"

namespace fieldfab {
namespace {

std::vector<char*> pointers_to(const std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

}  // namespace

Child::Child(const ChildSettings& settings, const std::string& advice) {
  const std::string& name = settings.words.at(0);
  const std::vector<char*> argv = pointers_to(settings.words);
  std::vector<char*> given;
  if (settings.environment) given = pointers_to(*settings.environment);
  char** const env = settings.environment ? given.data() : environ;
  std::array<int, 2> ends{}, failure{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw Error(ErrorKind::io, name, std::strerror(errno));
  if (pipe2(failure.data(), O_CLOEXEC) != 0) {
    const int why = errno;
    close(ends[0]), close(ends[1]);
    throw Error(ErrorKind::io, name, std::strerror(why));
  }
  const rlimit limit{settings.memory, settings.memory};
  const pid_t parent = getpid();
  process_ = fork();
  int why = errno;
  if (process_ == 0) {  // only functions that are safe after a fork, from here on
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(127);  // the parent ended before prctl()
    if (settings.memory > 0) setrlimit(RLIMIT_AS, &limit);
    dup2(ends[1], STDOUT_FILENO);
    if (settings.errors_too) {
      dup2(ends[1], STDERR_FILENO);
      if (const int nothing = open("/dev/null", O_RDONLY); nothing >= 0) dup2(nothing, STDIN_FILENO);
    }
    execvpe(argv[0], argv.data(), env);
    why = errno;
    [[maybe_unused]] const ssize_t told = write(failure[1], &why, sizeof why);
    _exit(127);
  }
  close(ends[1]), close(failure[1]);
  output_ = ends[0];
  const bool started = process_ > 0 && ::read(failure[0], &why, sizeof why) <= 0;
  close(failure[0]);
  if (started) {
    setpgid(process_, process_);
    return;
  }
  if (process_ > 0) waitpid(process_, nullptr, 0);
  close(output_);
  throw Error(ErrorKind::io, name, why == ENOENT && !advice.empty() ? advice : std::strerror(why));
}

Child::~Child() {
  if (process_ > 0) {
    kill(-process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  close(output_);
}

bool Child::read(std::string& text) const {
  pollfd waiting{output_, POLLIN, 0};
  if (poll(&waiting, 1, 50) <= 0) return true;
  std::array<char, 65536> bytes;
  const ssize_t count = ::read(output_, bytes.data(), bytes.size());
  if (count > 0) text.append(bytes.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && errno == EINTR);
}

int Child::wait() {
  int status = 0;
  waitpid(process_, &status, 0);
  kill(-process_, SIGKILL);
  process_ = 0;
  return status;
}

}  // namespace fieldfab
