#include "fieldfab/core/file_buffer.h"

#include <algorithm>

namespace fieldfab {

FileBuffer::int_type FileBuffer::overflow(int_type character) {
  if (traits_type::eq_int_type(character, traits_type::eof())) return traits_type::not_eof(character);
  const char byte = traits_type::to_char_type(character);
  xsputn(&byte, 1);
  return character;
}

std::streamsize FileBuffer::xsputn(const char* data, std::streamsize size) {
  const auto wanted = static_cast<std::uint64_t>(size), over = std::min(wanted, size_ - at_);
  if (over > 0) file_.rewrite(at_, data, over);
  if (wanted > over) file_.write(data + over, wanted - over);
  at_ += wanted;
  size_ = std::max(size_, at_);
  return size;
}

FileBuffer::pos_type FileBuffer::seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode mode) {
  const std::uint64_t base = from == std::ios_base::beg ? 0 : from == std::ios_base::cur ? at_ : size_;
  return seekpos(static_cast<off_type>(base) + offset, mode);
}

FileBuffer::pos_type FileBuffer::seekpos(pos_type position, std::ios_base::openmode /*mode*/) {
  const auto wanted = static_cast<off_type>(position);
  if (wanted < 0 || static_cast<std::uint64_t>(wanted) > size_) return static_cast<off_type>(-1);
  at_ = static_cast<std::uint64_t>(wanted);
  return position;
}

}  // namespace fieldfab
