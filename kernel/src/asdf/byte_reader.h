/// Reader of binary data; private to the asdf folder.
#pragma once

#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>

#include "fieldfab/core/error.h"

namespace fieldfab {

[[noreturn]] inline void damaged(const std::filesystem::path& path, const std::string& how) {
  throw Error(ErrorKind::bad_input, path.string(), "is damaged or no .asdf file: " + how);
}

/// Reads bytes from front to back, never past the end.
class ByteReader {
 public:
  ByteReader(std::string_view bytes, const std::filesystem::path& path) : bytes_(bytes), path_(path) {}
  template <class Value>
  Value take() {
    Value value;
    take(&value, sizeof value);
    return value;
  }
  void take(void* to, std::size_t size) {
    if (size > left()) damaged(path_, "it ends too early");
    std::memcpy(to, bytes_.data() + at_, size);
    at_ += size;
  }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }

 private:
  std::string_view bytes_;
  const std::filesystem::path& path_;
  std::size_t at_ = 0;
};

template <class Value>
void append(std::string& bytes, const Value& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace fieldfab
