// Preloaded by LD_PRELOAD (tests/hosts/faults.py): makes a call of a program fail, kills the
// program at a call, or keeps a journal of the state of its files after a loss of power. Calls are
// counted while main() runs.
//
// FAULT_CALL: write, pwrite, fsync, rename, malloc, pthread_create, or any (one of the first four)
// FAULT_AT: number of the failing call, from 1; with FAULT_LASTING also all later ones
// FAULT_NO_LINK: there are no hard links, as on some file systems
// FAULT_KILL: the process is killed instead of that call
// FAULT_COUNT: a file that receives the number of calls at the end of main()
// FAULT_JOURNAL: a folder for the file `journal`, and for copies of files that a rename replaces
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace {

std::atomic<bool> counting{false};
std::atomic<long> calls{0};
char wanted[32];
long fails_at = 0;
bool lasting = false, kills = false, no_links = false;
const char *journal_folder = nullptr, *count_file = nullptr;
int journal = -1;
std::atomic<int> saved{0};

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

/// Counts the call and returns whether it fails.
bool fails(const char* name) {
  if (!counting) return false;
  const bool file_call = name[0] == 'w' || name[0] == 'f' || name[0] == 'r' || (name[0] == 'p' && name[1] == 'w');
  if (std::strcmp(wanted, name) != 0 && !(file_call && std::strcmp(wanted, "any") == 0)) return false;
  const long number = ++calls;
  if (number != fails_at && !(lasting && fails_at > 0 && number > fails_at)) return false;
  if (kills) ::kill(::getpid(), SIGKILL);
  return true;
}

/// Standard streams are not watched.
bool is_file(int descriptor) { return descriptor > STDERR_FILENO && descriptor != journal; }

void note(const char* format, auto... values) {
  char line[3 * PATH_MAX];
  const int length = std::snprintf(line, sizeof line, format, values...);
  if (journal >= 0) syscall(SYS_write, journal, line, static_cast<std::size_t>(length));
}

void note_sync(int descriptor) {
  struct stat status {};
  if (journal < 0 || ::fstat(descriptor, &status) != 0) return;
  const auto inode = static_cast<unsigned long>(status.st_ino);
  if (S_ISDIR(status.st_mode))
    note("folder\t%lu\n", inode);
  else
    note("file\t%lu\t%ld\t%ld.%09ld\n", inode, static_cast<long>(status.st_size),
         static_cast<long>(status.st_mtim.tv_sec), static_cast<long>(status.st_mtim.tv_nsec));
}

int (*real_main)(int, char**, char**);

int watched_main(int argc, char** argv, char** environment) {
  const auto text = [](const char* name) { return std::getenv(name) != nullptr ? std::getenv(name) : ""; };
  std::snprintf(wanted, sizeof wanted, "%s", text("FAULT_CALL"));
  fails_at = std::atol(text("FAULT_AT"));
  lasting = *text("FAULT_LASTING") != '\0';
  kills = *text("FAULT_KILL") != '\0';
  no_links = *text("FAULT_NO_LINK") != '\0';
  count_file = std::getenv("FAULT_COUNT");
  if ((journal_folder = std::getenv("FAULT_JOURNAL")) != nullptr) {
    char path[PATH_MAX];
    std::snprintf(path, sizeof path, "%s/journal", journal_folder);
    journal = ::open(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  }
  ::unsetenv("LD_PRELOAD");  // not inherited by programs that it starts
  counting = true;
  const int code = real_main(argc, argv, environment);
  counting = false;
  if (count_file != nullptr) {
    char line[32];
    const int length = std::snprintf(line, sizeof line, "%ld", calls.load());
    const int file = ::open(count_file, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    syscall(SYS_write, file, line, static_cast<std::size_t>(length));
    ::close(file);
  }
  return code;
}

bool no_memory() {
  if (!fails("malloc")) return false;
  errno = ENOMEM;
  return true;
}

}  // namespace

extern "C" {

int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(), void (*fini)(),
                      void (*loader)(), void* stack) {
  real_main = main;
  return next<decltype(&__libc_start_main)>("__libc_start_main")(watched_main, argc, argv, init, fini, loader, stack);
}

ssize_t write(int descriptor, const void* data, std::size_t size) {
  if (is_file(descriptor) && fails("write")) {
    errno = ENOSPC;
    return -1;
  }
  return syscall(SYS_write, descriptor, data, size);
}

ssize_t writev(int descriptor, const iovec* parts, int count) {
  if (is_file(descriptor) && fails("write")) {
    errno = ENOSPC;
    return -1;
  }
  return syscall(SYS_writev, descriptor, parts, count);
}

std::size_t fwrite(const void* data, std::size_t size, std::size_t count, FILE* file) {
  static const auto real = next<decltype(&fwrite)>("fwrite");
  if (is_file(fileno(file)) && fails("write")) {
    errno = ENOSPC;
    return 0;
  }
  return real(data, size, count, file);
}

ssize_t pwrite(int descriptor, const void* data, std::size_t size, off_t offset) {
  if (is_file(descriptor) && fails("pwrite")) {
    errno = ENOSPC;
    return -1;
  }
  return syscall(SYS_pwrite64, descriptor, data, size, offset);
}

ssize_t pwrite64(int descriptor, const void* data, std::size_t size, off_t offset) {
  return pwrite(descriptor, data, size, offset);
}

int fsync(int descriptor) {
  if (fails("fsync")) {
    errno = EIO;
    return -1;
  }
  const long result = syscall(SYS_fsync, descriptor);
  if (result == 0) note_sync(descriptor);
  return static_cast<int>(result);
}

int rename(const char* from, const char* to) {
  if (fails("rename")) {
    errno = EIO;
    return -1;
  }
  struct stat old {};
  char kept[PATH_MAX] = "-", folder[PATH_MAX];
  if (journal >= 0) {
    if (::stat(to, &old) == 0) {
      std::snprintf(kept, sizeof kept, "%s/%d", journal_folder, ++saved);
      if (syscall(SYS_link, to, kept) != 0) std::snprintf(kept, sizeof kept, "-");
    }
    std::snprintf(folder, sizeof folder, "%s", to);
    if (char* const slash = std::strrchr(folder, '/'))
      *slash = '\0';
    else
      std::snprintf(folder, sizeof folder, ".");
    ::stat(folder, &old);
  }
  const long result = syscall(SYS_rename, from, to);
  if (result == 0) note("rename\t%s\t%s\t%s\t%lu\n", from, to, kept, static_cast<unsigned long>(old.st_ino));
  return static_cast<int>(result);
}

int link(const char* from, const char* to) {
  if (no_links) {
    errno = EPERM;
    return -1;
  }
  return static_cast<int>(syscall(SYS_link, from, to));
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*routine)(void*), void* argument) {
  static const auto real = next<decltype(&pthread_create)>("pthread_create");
  return fails("pthread_create") ? EAGAIN : real(thread, attributes, routine, argument);
}

void* malloc(std::size_t size) { return no_memory() ? nullptr : __libc_malloc(size); }
void* calloc(std::size_t count, std::size_t size) { return no_memory() ? nullptr : __libc_calloc(count, size); }
void* realloc(void* old, std::size_t size) { return no_memory() ? nullptr : __libc_realloc(old, size); }
void* memalign(std::size_t alignment, std::size_t size) {
  return no_memory() ? nullptr : __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) { return memalign(alignment, size); }
int posix_memalign(void** result, std::size_t alignment, std::size_t size) {
  if (no_memory()) return ENOMEM;
  void* const made = __libc_memalign(alignment, size);
  if (made == nullptr) return ENOMEM;
  *result = made;
  return 0;
}
}
