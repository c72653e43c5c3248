/// Streaming reader of XML in archives.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "fieldfab/core/progress.h"
#include "zip_archive.h"

namespace fieldfab {

/// Attributes of an element. A name with a namespace is "URI NAME".
class XmlAttributes {
 public:
  explicit XmlAttributes(const char** pairs) : pairs_(pairs) {}
  [[nodiscard]] std::optional<std::string_view> find(std::string_view name) const {
    for (const char** at = pairs_; *at != nullptr; at += 2)
      if (name == at[0]) return at[1];
    return std::nullopt;
  }

 private:
  const char** pairs_;
};

/// Handler of elements. An Error that it throws without a place gets the place of the element.
class XmlHandler {
 public:
  XmlHandler() = default;
  virtual ~XmlHandler() = default;
  XmlHandler(const XmlHandler&) = delete;
  XmlHandler& operator=(const XmlHandler&) = delete;
  /// Called before the element with the declaration; prefix and URI may be empty.
  virtual void declare(std::string_view /*prefix*/, std::string_view /*uri*/) {}
  /// Called at the start of an element; the URI is empty if it has no namespace.
  virtual void begin(std::string_view uri, std::string_view name, const XmlAttributes& attributes) = 0;
  virtual void end() = 0;
};

/// Parses a part as XML. Throws the exceptions of ZipReader::read() and of the handler. Throws
/// bad_input with the line if the part is not well-formed, has a document type declaration (so that
/// no entity is ever expanded), a tag or comment longer than 1 MiB, or more than 100 nested
/// elements.
void read_xml(const ZipReader& zip, const std::string& part, const std::filesystem::path& path, XmlHandler& handler,
              Progress& progress);

}  // namespace fieldfab
