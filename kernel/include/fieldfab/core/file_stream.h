/// A PendingFile as a standard stream, for libraries that write to one.
#pragma once

#include <ostream>
#include <streambuf>

#include "fieldfab/core/file.h"

namespace fieldfab {

/// Writes to a PendingFile from its beginning, seeks, and throws Error(io) from the call that fails.
class FileStream : private std::streambuf, public std::ostream {
 public:
  explicit FileStream(PendingFile& file);

 private:
  int_type overflow(int_type character) override;
  std::streamsize xsputn(const char* data, std::streamsize size) override;
  pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode mode) override;
  pos_type seekpos(pos_type position, std::ios_base::openmode mode) override;

  PendingFile& file_;
  std::uint64_t at_ = 0, size_ = 0;  ///< bytes
};

}  // namespace fieldfab
