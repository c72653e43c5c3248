#include "code_memory.h"

#include <sys/mman.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <mutex>

namespace fieldfab::frep {
namespace {

void say_once(const char* refused) {
  static std::once_flag said;
  std::call_once(said, [&] {
    // Not fmt::print(), which throws if stderr is closed or full.
    std::fprintf(stderr, "fieldfab: no executable memory (%s: %s); formulas are interpreted instead\n", refused,
                 std::strerror(errno));
  });
}

}  // namespace

std::unique_ptr<CodeMemory> CodeMemory::reserve(std::size_t size) {
  void* const pages = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (pages == MAP_FAILED) {
    say_once("mmap");
    return nullptr;
  }
  return std::unique_ptr<CodeMemory>(new CodeMemory(static_cast<std::byte*>(pages), size));
}

CodeMemory::~CodeMemory() { munmap(data_, size_); }

bool CodeMemory::seal() {
  if (mprotect(data_, size_, PROT_READ | PROT_EXEC) == 0) return true;
  say_once("mprotect");
  return false;
}

}  // namespace fieldfab::frep
