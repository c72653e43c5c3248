#include "xml_reader.h"

#include <expat.h>
#include <fmt/format.h>

#include <cstdint>
#include <exception>
#include <functional>

#include "fieldfab/core/error.h"
#include "fieldfab/core/text.h"

namespace fieldfab {
namespace {

constexpr XML_Char separator = ' ';  // never part of a URI
constexpr std::int64_t longest_tag = 1 << 20;
constexpr int most_within = 100;

// expat 2.9, an update of Debian 13, deprecates the functions without "64"; earlier versions have no others.
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9
std::int64_t byte_of(XML_Parser parser) { return XML_GetCurrentByteIndex64(parser); }
std::uint64_t line_of(XML_Parser parser) { return XML_GetCurrentLineNumber64(parser); }
#else
std::int64_t byte_of(XML_Parser parser) { return XML_GetCurrentByteIndex(parser); }
std::uint64_t line_of(XML_Parser parser) { return XML_GetCurrentLineNumber(parser); }
#endif

/// A parser that stores exceptions of its handler, since nothing may be thrown through expat.
class Parser {
 public:
  Parser(std::string place, XmlHandler& handler)
      : place_(std::move(place)), handler_(handler), parser_(XML_ParserCreateNS(nullptr, separator), XML_ParserFree) {
    if (parser_ == nullptr) throw Error(ErrorKind::internal, "expat", "cannot make a parser");
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(
        parser_.get(),
        [](void* self, const XML_Char* name, const XML_Char** attributes) {
          of(self).begin(name, XmlAttributes(attributes));
        },
        [](void* self, const XML_Char*) { of(self).end(); });
    XML_SetStartNamespaceDeclHandler(parser_.get(), [](void* self, const XML_Char* prefix, const XML_Char* uri) {
      of(self).guarded([&](XmlHandler& h) { h.declare(prefix == nullptr ? "" : prefix, uri == nullptr ? "" : uri); });
    });
    XML_SetStartDoctypeDeclHandler(parser_.get(), [](void* self, const XML_Char*, const XML_Char*, const XML_Char*,
                                                     int) {
      of(self).guarded([](XmlHandler&) {
        throw Error(ErrorKind::bad_input, "", "has a document type declaration, which is not allowed in .3mf files");
      });
    });
  }

  void parse(std::string_view bytes, bool last) {
    const bool fine =
        XML_Parse(parser_.get(), bytes.data(), static_cast<int>(bytes.size()), last ? 1 : 0) == XML_STATUS_OK;
    if (thrown_) std::rethrow_exception(thrown_);
    if (!fine) fail(XML_ErrorString(XML_GetErrorCode(parser_.get())));
    given_ += static_cast<std::int64_t>(bytes.size());
    if (given_ - byte_of(parser_.get()) > longest_tag + static_cast<std::int64_t>(bytes.size()))
      fail("has a tag or a comment longer than 1 MiB");
  }

 private:
  static Parser& of(void* self) { return *static_cast<Parser*>(self); }

  [[nodiscard]] std::string here() const { return fmt::format("{}:{}", place_, line_of(parser_.get())); }
  [[noreturn]] void fail(const std::string& how) const { throw Error(ErrorKind::bad_input, here(), how); }

  template <class Act>
  void guarded(const Act& act) {
    if (thrown_) return;  // expat may call a handler once more
    try {
      try {
        act(handler_);
      } catch (const Error& error) {
        if (!error.place().empty()) throw;
        throw Error(error.kind(), here(), error.what());
      }
    } catch (...) {
      thrown_ = std::current_exception();
      XML_StopParser(parser_.get(), XML_FALSE);
    }
  }
  void begin(std::string_view name, const XmlAttributes& attributes) {
    guarded([&](XmlHandler& handler) {
      if (++within_ > most_within)
        throw Error(ErrorKind::bad_input, "", fmt::format("has more than {} elements within each other", most_within));
      const std::size_t at = name.rfind(separator);
      if (at == std::string_view::npos)
        handler.begin({}, name, attributes);
      else
        handler.begin(name.substr(0, at), name.substr(at + 1), attributes);
    });
  }
  void end() {
    --within_;
    guarded([](XmlHandler& handler) { handler.end(); });
  }

  std::string place_;
  XmlHandler& handler_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  std::exception_ptr thrown_;
  std::int64_t given_ = 0;
  int within_ = 0;
};

}  // namespace

void read_xml(const ZipReader& zip, const std::string& part, const std::filesystem::path& path, XmlHandler& handler,
              Progress& progress) {
  Parser parser(fmt::format("{}/{:.200}", path.string(), printable(part)), handler);
  zip.read(part, [&](std::string_view bytes) {
    progress.check();
    parser.parse(bytes, false);
  });
  parser.parse({}, true);
}

}  // namespace fieldfab
