/// Stream buffer over a PendingFile, for libraries that write to a standard stream.
#pragma once

#include <streambuf>

#include "fieldfab/core/file.h"

namespace fieldfab {

/// Writes to a PendingFile and seeks within the bytes written; seeking elsewhere returns -1 and moves nothing. Does not
/// commit the file. Holds a reference: the file must outlive this object.
/// Throws Error(io); a stream passes the exception on only if its exceptions() include badbit.
class FileBuffer final : public std::streambuf {
 public:
  explicit FileBuffer(PendingFile& file) : file_(file) {}

 private:
  int_type overflow(int_type character) override;
  std::streamsize xsputn(const char* data, std::streamsize size) override;
  pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode mode) override;
  pos_type seekpos(pos_type position, std::ios_base::openmode mode) override;

  PendingFile& file_;
  std::uint64_t at_ = 0, size_ = 0;  ///< position and number of bytes written
};

}  // namespace fieldfab
