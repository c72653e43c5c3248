#include "core/module.h"

#include <dlfcn.h>

#include <filesystem>

#include "fieldfab/core/error.h"

namespace fieldfab {
namespace {

std::filesystem::path folder_of_parts() {
  Dl_info library{};
  dladdr(reinterpret_cast<const void*>(&address_in_part), &library);
  return std::filesystem::canonical(library.dli_fname).parent_path() / ("fieldfab-" FIELDFAB_VERSION);
}

}  // namespace

const void* address_in_part(const char* name, const char* symbol) {
  const std::filesystem::path file = folder_of_parts() / (std::string(name) + ".so");
  void* const part = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  const void* const address = part == nullptr ? nullptr : dlsym(part, symbol);
  if (address == nullptr) throw Error(ErrorKind::io, file.string(), dlerror());
  return address;
}

}  // namespace fieldfab
