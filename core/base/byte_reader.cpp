#include "core/base/byte_reader.h"

namespace penpose::base {

std::optional<Bytes> ByteReader::take(std::size_t count) {
  if (count > remaining()) return std::nullopt;
  const Bytes piece = bytes_.subspan(offset_, count);
  offset_ += count;
  return piece;
}

bool ByteReader::seek(std::size_t offset) {
  if (offset > bytes_.size()) return false;
  offset_ = offset;
  return true;
}

}  // namespace penpose::base
