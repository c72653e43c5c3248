/// Parts of the library that are loaded on first use, since loading ITK or OpenVDB takes longer
/// than most commands.
#pragma once

namespace fieldfab {

/// Returns the address of `symbol` in the part `name` ("itk"). Parts are in a folder of the
/// library's version beside the library, and stay loaded. Throws io if there is none.
const void* address_in_part(const char* name, const char* symbol);

/// Returns the object `symbol` of the part `name`. Both sides include the definition of its type.
template <class Table>
const Table& in_part(const char* name, const char* symbol) {
  return *static_cast<const Table*>(address_in_part(name, symbol));
}

}  // namespace fieldfab
