// Debian's libasmjit.a is built for executables: its messages refer to stderr in a way that a
// shared library cannot link. These definitions replace them, so that the linker leaves that object
// out.
#include <asmjit/core.h>

#include <cstdio>
#include <cstdlib>

ASMJIT_BEGIN_SUB_NAMESPACE(DebugUtils)

const char* errorAsString(Error /*err*/) noexcept { return "asmjit could not make the code"; }

void debugOutput(const char* str) noexcept { std::fputs(str, stderr); }

void assertionFailed(const char* file, int line, const char* msg) noexcept {
  std::fprintf(stderr, "%s:%d: %s\n", file, line, msg);
  std::abort();
}

ASMJIT_END_SUB_NAMESPACE
