#include <variant>

#include "bindings.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/core/text.h"

namespace fieldfab::python {
namespace {

const char* name_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::bad_input: return "bad_input";
    case ErrorKind::io: return "io";
    case ErrorKind::too_large: return "too_large";
    case ErrorKind::cancelled: return "cancelled";
    case ErrorKind::internal: return "internal";
  }
  return "internal";
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  module.doc() = "Fieldfab's kernel; use it through the package fieldfab.";
  module.attr("__version__") = FIELDFAB_VERSION;
  static py::exception<Error> error_type(module, "Error");
  error_type.doc() =
      "What went wrong, in one line. `kind` is bad_input, io, too_large, cancelled or internal; `place` says where.";
  error_type.attr("kind") = "bad_input";  // of an error that is constructed in Python
  error_type.attr("place") = "";
  py::register_exception_translator([](std::exception_ptr raised) {
    try {
      if (raised) std::rethrow_exception(raised);
    } catch (const Error& error) {
      py::object instance = py::handle(error_type)(printable(error.what()));
      instance.attr("kind") = name_of(error.kind());
      instance.attr("place") = printable(error.place());
      PyErr_SetObject(error_type.ptr(), instance.ptr());
    }
  });
  // Not destroyed when Python ends: the end of a limit may wait forever (cli/main.cpp tells why).
  static auto& limit = *new std::unique_ptr<ThreadLimit>;
  module.def(
      "set_threads",
      [](int threads) {
        if (threads < 0) throw py::value_error("threads must be 0 or more");
        limit.reset();
        limit = std::make_unique<ThreadLimit>(threads);
      },
      py::arg("threads"), "Use at most this many threads from now on; 0 means all cores.");
  module.def(
      "write_file",
      [](const std::filesystem::path& path, const std::variant<py::bytes, std::string>& data) {
        std::visit([&](const auto& bytes) { write_file(path, std::string_view(bytes)); }, data);
      },
      py::arg("filename"), py::arg("data"),
      "Writes bytes, or text as UTF-8, whole or not at all: beside the file, synced, then put in its place.");
  bind_solids(module);
  bind_language(module);
  bind_grammar(module);
  bind_distances(module);
  bind_results(module);
  bind_volumes(module);
  bind_openscad(module);
  bind_cam(module);
  bind_stock(module);
}

}  // namespace fieldfab::python
