#include "core/module.h"

#include <dlfcn.h>

#include <algorithm>
#include <filesystem>
#include <future>
#include <thread>
#include <vector>

#include "fieldfab/core/error.h"

namespace fieldfab {
namespace {

std::filesystem::path folder_of_parts() {
  Dl_info library{};
  dladdr(reinterpret_cast<const void*>(&address_in_part), &library);
  return std::filesystem::canonical(library.dli_fname).parent_path() / ("fieldfab-" FIELDFAB_VERSION);
}

/// Starts and ends as many threads as a library may start during loading. log4cplus, to which
/// OpenVDB links, waits forever if one of its threads cannot start; after this test all probably
/// can.
/// @throws std::system_error  if the system refuses a thread
void try_threads() {
  std::vector<std::jthread> threads;
  std::promise<void> over;  // destroyed before the threads, which ends them
  const std::shared_future<void> end = over.get_future();
  for (unsigned i = 0; i < std::max(2U, std::thread::hardware_concurrency()); ++i)
    threads.emplace_back([end] { end.wait(); });
}

}  // namespace

const void* address_in_part(const char* name, const char* symbol) {
  const std::filesystem::path file = folder_of_parts() / (std::string(name) + ".so");
  void* part = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NOLOAD);
  if (part == nullptr) {
    try_threads();
    part = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  }
  const void* const address = part == nullptr ? nullptr : dlsym(part, symbol);
  if (address == nullptr) throw Error(ErrorKind::io, file.string(), dlerror());
  return address;
}

}  // namespace fieldfab
