/// Memory that holds machine code.
#pragma once

#include <cstddef>
#include <memory>

namespace fieldfab::frep {

/// Pages of machine code: written first, then made executable and never writable again.
class CodeMemory {
 public:
  /// Null where the system gives no executable memory; that is said once, on stderr.
  static std::unique_ptr<CodeMemory> reserve(std::size_t size);
  ~CodeMemory();
  CodeMemory(const CodeMemory&) = delete;
  CodeMemory& operator=(const CodeMemory&) = delete;

  [[nodiscard]] std::byte* data() const { return data_; }
  /// Ends writing. False where the system refuses, which is said once as well.
  bool seal();

 private:
  CodeMemory(std::byte* data, std::size_t size) : data_(data), size_(size) {}
  std::byte* data_;
  std::size_t size_;
};

}  // namespace fieldfab::frep
