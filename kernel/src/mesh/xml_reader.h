/// XML in archives, read as a stream.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "fieldfab/core/progress.h"
#include "zip_archive.h"

namespace fieldfab {

/// The attributes of an element. A name with a namespace is "URI NAME".
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

/// Is called for each element. An Error that it throws without a place gets that of the element.
class XmlHandler {
 public:
  XmlHandler() = default;
  virtual ~XmlHandler() = default;
  XmlHandler(const XmlHandler&) = delete;
  XmlHandler& operator=(const XmlHandler&) = delete;
  /// Called before the element that declares it; prefixes and URIs may be empty.
  virtual void declare(std::string_view /*prefix*/, std::string_view /*uri*/) {}
  /// An element of a namespace begins; the URI is empty where it has none.
  virtual void begin(std::string_view uri, std::string_view name, const XmlAttributes& attributes) = 0;
  virtual void end() = 0;
};

/// Reads a part as XML. Throws what ZipReader::read() and the handler throw, and bad_input with the line for what is not
/// well-formed, has a document type declaration (so that no entity is ever expanded), a tag or comment longer than 1 MiB, or more
/// than 100 elements within each other.
void read_xml(const ZipReader& zip, const std::string& part, const std::filesystem::path& path, XmlHandler& handler,
              Progress& progress);

}  // namespace fieldfab
