/// Memory for machine code.
#pragma once

#include <cstddef>
#include <memory>

namespace fieldfab::frep {

/// Pages of machine code: writable first, then executable and never writable again.
class CodeMemory {
 public:
  /// Returns null if the system refuses executable memory; reports that once, on stderr.
  static std::unique_ptr<CodeMemory> reserve(std::size_t size);
  ~CodeMemory();
  CodeMemory(const CodeMemory&) = delete;
  CodeMemory& operator=(const CodeMemory&) = delete;

  [[nodiscard]] std::byte* data() const { return data_; }
  /// Ends writing. Returns false if the system refuses; reports that once, too.
  bool seal();

 private:
  CodeMemory(std::byte* data, std::size_t size) : data_(data), size_(size) {}
  std::byte* data_;
  std::size_t size_;
};

}  // namespace fieldfab::frep
