#include "fieldfab/core/copy_of_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <ctime>

#include "fieldfab/core/error.h"

namespace fieldfab {
namespace {

constexpr int completed = 87;  ///< exit code of a copy that has done its work

/// Runs the copy: silent, without signal handlers or core file, and ended together with the
/// original process.
[[noreturn]] void run_as_copy(const std::function<void()>& work, pid_t original) noexcept {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != original) _exit(1);
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTERM}) std::signal(signal, SIG_DFL);
  std::signal(SIGINT, SIG_IGN);  // a terminal sends it to both; the original handles it
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  if (const int nothing = open("/dev/null", O_RDWR); nothing >= 0)
    dup2(nothing, STDOUT_FILENO), dup2(nothing, STDERR_FILENO);
  try {
    work();
  } catch (...) {  // counts as completion
  }
  _exit(completed);
}

/// A copy that uses no processor for so long waits for a lock that another thread of the original held at the fork.
constexpr std::chrono::seconds longest_rest{5};

/// Kills the copy if it is still running, and waits for its end.
struct Copy {
  ~Copy() {
    if (!waited) {
      kill(process, SIGKILL);
      while (waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
      }
    }
    close(open);
  }
  /// Waits for its end.
  CopyEnd wait() {
    int status = 0;
    waited = true;
    while (waitpid(process, &status, 0) < 0)
      if (errno != EINTR) return CopyEnd::completed;  // the system does not tell: SIGCHLD is ignored
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL)
      throw Error(ErrorKind::too_large, "", "the system ended this work; it has too little memory");
    return WIFEXITED(status) && WEXITSTATUS(status) == completed ? CopyEnd::completed : CopyEnd::crashed;
  }
  /// Processor time that it has used, ns.
  [[nodiscard]] std::int64_t used() const {
    clockid_t clock{};
    timespec time{};
    if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
  }
  pid_t process;
  int open;  ///< read end of a pipe that it holds open until its end
  bool waited = false;
};

}  // namespace

CopyEnd run_in_copy(const std::function<void()>& work, Progress& progress) {
  progress.check();
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return CopyEnd::unknown;
  const pid_t original = getpid(), process = fork();
  if (process == 0) run_as_copy(work, original);
  close(ends[1]);
  if (process < 0) {
    close(ends[0]);
    return CopyEnd::unknown;
  }
  Copy copy{process, ends[0]};
  std::int64_t used = -1;
  auto since = std::chrono::steady_clock::now();
  for (;;) {
    progress.check();
    pollfd waiting{copy.open, POLLIN, 0};
    if (poll(&waiting, 1, 50) > 0) return copy.wait();
    const auto now = std::chrono::steady_clock::now();
    if (const std::int64_t more = copy.used(); more != used) used = more, since = now;
    if (now - since > longest_rest) return CopyEnd::unknown;
  }
}

}  // namespace fieldfab
