/// A PendingFile as the buffer of a standard stream, for libraries that write to one.
#pragma once

#include <streambuf>

#include "fieldfab/core/file.h"

namespace fieldfab {

/// Writes to a PendingFile from its beginning, and seeks in what was written. Throws Error(io), which a stream lets
/// pass where its exceptions() have badbit.
class FileBuffer final : public std::streambuf {
 public:
  explicit FileBuffer(PendingFile& file) : file_(file) {}

 private:
  int_type overflow(int_type character) override;
  std::streamsize xsputn(const char* data, std::streamsize size) override;
  pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode mode) override;
  pos_type seekpos(pos_type position, std::ios_base::openmode mode) override;

  PendingFile& file_;
  std::uint64_t at_ = 0, size_ = 0;  ///< bytes
};

}  // namespace fieldfab
