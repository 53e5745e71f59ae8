#include "core/base/byte_writer.h"

namespace penpose::base {

void ByteWriter::append(Bytes bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }

void ByteWriter::align(std::size_t alignment, std::uint8_t filler) {
  while (bytes_.size() % alignment != 0) bytes_.push_back(filler);
}

}  // namespace penpose::base
