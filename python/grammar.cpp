// Python bindings of the .frep language, for editors.
#include <fmt/format.h>

#include "bindings.h"
#include "fieldfab/core/error.h"
#include "fieldfab/openscad/design.h"

namespace fieldfab::python {
namespace {

const char* name_of(frep::TokenKind kind) {
  constexpr const char* names[] = {"comment", "string", "number", "name", "sign", "unknown"};
  return names[static_cast<int>(kind)];
}

const char* name_of(frep::WordKind kind) {
  constexpr const char* names[] = {"function", "constant", "variable", "parameter", "option", "colour"};
  return names[static_cast<int>(kind)];
}

/// The options of open(), as words.
const std::vector<frep::Word>& option_words() {
  static const std::vector<frep::Word> words = [] {
    std::vector<frep::Word> all;
    const auto add = [&](std::string_view name, std::string_view help) {
      all.push_back({std::string(name), frep::WordKind::option, std::string(name), std::string(help), ""});
    };
    for (const OpenOptionInfo& option : open_options()) add(option.name, option.help);
    add("part", "the name of one part of a file with several");
    return all;
  }();
  return words;
}

/// Diagnostics of a text as parse() reads it: a prefix math string has no mistakes.
std::vector<frep::Diagnostic> diagnostics(const std::string& text, const std::optional<std::filesystem::path>& folder) {
  OpenSettings settings;
  settings.opens_others = folder.has_value();
  settings.formats = &openscad::all_formats();
  std::vector<frep::Diagnostic> found =
      long_work(py::none(), [&](Progress& p) { return diagnose_model(text, folder.value_or(""), settings, p); });
  if (found.empty()) return found;
  try {
    frep::parse_math(text);
    return {};
  } catch (const Error&) {
    return found;
  }
}

/// The text with new numbers for the given parameters, otherwise unchanged.
std::string with_values(const std::string& text, const std::map<std::string, double>& values) {
  std::string made;
  std::size_t done = 0;
  for (const frep::TextParameter& parameter : frep::parameters(text))
    if (const auto given = values.find(parameter.name); given != values.end()) {
      made += text.substr(done, parameter.value_offset - done) + fmt::format("{}", given->second);
      done = parameter.value_offset + parameter.value_length;
    }
  return made + text.substr(done);
}

}  // namespace

void bind_grammar(py::module_& parent) {
  py::module_ module = parent.def_submodule(
      "language",
      "The .frep language for editors: its tokens, numbers, mistakes, and the names that fit or mean "
      "something. Texts are str, or "
      "bytes of UTF-8; offsets and lengths count these bytes; lines and columns begin at 1.");

  py::class_<frep::Token>(module, "Token", "A token; `kind` is comment, string, number, name, sign or unknown.")
      .def_property_readonly("kind", [](const frep::Token& token) { return name_of(token.kind); })
      .def_readonly("offset", &frep::Token::offset)
      .def_readonly("length", &frep::Token::length)
      .def_readonly("line", &frep::Token::line)
      .def_readonly("column", &frep::Token::column);

  py::class_<frep::TextParameter>(module, "Parameter",
                                  "A number that a text names. `range` is (low, high) or None, from a comment such as "
                                  "`# 5 to 40, outer width`; `comment` is "
                                  "the rest of it.")
      .def_readonly("name", &frep::TextParameter::name)
      .def_readonly("value", &frep::TextParameter::value)
      .def_readonly("name_offset", &frep::TextParameter::name_offset)
      .def_readonly("value_offset", &frep::TextParameter::value_offset)
      .def_readonly("value_length", &frep::TextParameter::value_length)
      .def_readonly("comment", &frep::TextParameter::comment)
      .def_property_readonly("range", [](const frep::TextParameter& parameter) -> py::object {
        if (!parameter.range) return py::none();
        return py::make_tuple(parameter.range->low, parameter.range->high);
      });

  py::class_<frep::Diagnostic>(module, "Diagnostic", "A mistake; its length is 0 where a token is missing.")
      .def_readonly("offset", &frep::Diagnostic::offset)
      .def_readonly("length", &frep::Diagnostic::length)
      .def_readonly("line", &frep::Diagnostic::line)
      .def_readonly("column", &frep::Diagnostic::column)
      .def_readonly("message", &frep::Diagnostic::message);

  py::class_<frep::Word>(
      module, "Word",
      "A name that means something; `kind` is function, constant, variable, parameter, option or colour.")
      .def_property_readonly("kind", [](const frep::Word& word) { return name_of(word.kind); })
      .def_readonly("name", &frep::Word::name)
      .def_readonly("signature", &frep::Word::signature)
      .def_readonly("meaning", &frep::Word::meaning)
      .def_readonly("example", &frep::Word::example);
  py::class_<frep::WordAt, frep::Word>(module, "WordAt", "A word of a text, with its place.")
      .def_readonly("offset", &frep::WordAt::offset)
      .def_readonly("length", &frep::WordAt::length);
  py::class_<frep::Completions::Entry, frep::Word>(module, "Completion",
                                                   "A word that fits, and the text to insert for it.")
      .def_readonly("insert", &frep::Completions::Entry::insert);
  py::class_<frep::Completions>(module, "Completions", "The words that fit, and the text that they replace.")
      .def_readonly("offset", &frep::Completions::offset)
      .def_readonly("length", &frep::Completions::length)
      .def_readonly("entries", &frep::Completions::entries);

  module.def(
      "tokens", [](const std::string& text) { return frep::tokens(text); }, py::arg("text"),
      "The tokens of a text. Between them are blanks, tabs and line ends only; none goes over a line end.");
  module.def(
      "parameters", [](const std::string& text) { return frep::parameters(text); }, py::arg("text"),
      "The numbers that a text names once, `width = 20`.");
  module.def("with_values", with_values, py::arg("text"), py::arg("values"),
             "The text with other numbers for its parameters: with_values(text, {\"width\": 25}).");
  module.def("diagnostics", diagnostics, py::arg("text"), py::arg("folder") = py::none(),
             "The mistakes of a text; there is none exactly where parse() takes it. The first is the one that parse() "
             "raises.");
  module.def(
      "words", [](const std::string& text) { return frep::words(text); }, py::arg("text") = "",
      "All names that a text can use: the library's, constants, and those that it defines.");
  module.def(
      "completions",
      [](const std::string& text, std::size_t offset) { return frep::completions(text, offset, option_words()); },
      py::arg("text"), py::arg("offset"), "The names that fit at an offset and begin as the text before it does.");
  module.def(
      "word_at",
      [](const std::string& text, std::size_t offset) { return frep::word_at(text, offset, option_words()); },
      py::arg("text"), py::arg("offset"), "The word at an offset, or None.");
}

}  // namespace fieldfab::python
