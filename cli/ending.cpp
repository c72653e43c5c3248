#include "ending.h"

#include <semaphore.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <exception>
#include <initializer_list>
#include <new>
#include <system_error>
#include <thread>
#include <utility>

#include "fieldfab/core/error.h"
#include "fieldfab/core/temporary.h"
#include "streams.h"

namespace fieldfab::cli {
namespace {

constexpr auto patience = std::chrono::milliseconds(300);

std::atomic<Progress*> running{nullptr};
enum class State { working, settled, ended };  // ended: from outside
std::atomic<State> state{State::working};
sem_t asked;  // posted to request a stop

void on_interrupt(int /*signal*/) {
  const int kept = errno;
  if (Progress* const progress = running) progress->cancel();
  sem_post(&asked);
  errno = kept;
}

// Unlike SIG_IGN, a handler is not inherited by started programs.
void on_write_error(int /*signal*/) {}

void handle(int signal, void (*handler)(int)) {
  struct sigaction before {
  }, action{};
  // A command started with nohup keeps ignoring SIGHUP.
  if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN && signal == SIGHUP) return;
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  ::sigaction(signal, &action, nullptr);
}

[[noreturn]] void end_now(int code, std::initializer_list<std::string_view> message) noexcept {
  remove_temporaries();
  tell(message);
  ::_exit(code);
}

/// Libraries call abort() if they cannot report a lack of memory otherwise: glibc for thread_local
/// objects, GMP.
void on_abort(int /*signal*/) {
  ::alarm(1);  // ends the process if nobody reads its standard error
  end_now(internal_error, {"fieldfab: internal error: a library gave up\n"});
}

/// Ends the process if the work does not stop.
void watch() {
  while (sem_wait(&asked) != 0) {
  }
  std::this_thread::sleep_for(patience);
  State working = State::working;
  if (state.compare_exchange_strong(working, State::ended)) end_now(cancelled, {"\nfieldfab: cancelled\n"});
}

[[noreturn]] void on_terminate() noexcept {
  const char* const what = [] {
    try {
      if (std::current_exception()) throw;
    } catch (const std::bad_alloc&) {
      return "there is not enough memory for this";
    } catch (const std::system_error&) {
      return "the system refuses what a thread needs";
    } catch (const std::exception& error) {  // TBB's, if it cannot start a thread
      return error.what();
    } catch (...) {
    }
    return "internal error: an exception was not caught";
  }();
  static thread_local bool again = false;
  if (std::exchange(again, true)) ::_exit(internal_error);  // thrown during the end itself
  if (state.exchange(State::ended) == State::ended)
    for (;;) ::pause();  // another thread is ending the process
  end_now(internal_error, {"fieldfab: ", what, "\n"});
}

}  // namespace

Ending::Ending(Progress& progress) {
  std::set_terminate(on_terminate);
  sem_init(&asked, 0, 0);
  std::thread(watch).detach();
  running = &progress;
  handle(SIGABRT, on_abort);
  for (const int signal : {SIGPIPE, SIGXFSZ}) handle(signal, on_write_error);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) handle(signal, on_interrupt);
}

Ending::~Ending() { running = nullptr; }

void Ending::settle() noexcept {
  State working = State::working;
  if (!state.compare_exchange_strong(working, State::settled) && working == State::ended)
    for (;;) ::pause();  // another thread is ending the process
}

}  // namespace fieldfab::cli
