/// Parts of the library that are loaded when they are first used: to load ITK or OpenVDB takes longer than most commands do.
#pragma once

namespace fieldfab {

/// The address of what the part `name` ("itk") defines under `symbol`. Parts lie in a folder of the library's version beside the
/// library, and stay loaded. Throws io where there is none.
const void* address_in_part(const char* name, const char* symbol);

/// What the part `name` defines under `symbol`, of a type that both sides of it include.
template <class Table>
const Table& in_part(const char* name, const char* symbol) {
  return *static_cast<const Table*>(address_in_part(name, symbol));
}

}  // namespace fieldfab
