#include "ui/capi/call.h"

#include <algorithm>
#include <cstring>

namespace penpose::capi {

std::int32_t tell(penpose_error* error, penpose_status status, std::string_view line) noexcept {
  if (error == nullptr) return status;
  error->status = status;
  std::size_t length = std::min(line.size(), sizeof error->message - 1);
  // Bytes of a character that goes on.
  const auto goes_on = [&](std::size_t at) { return (static_cast<unsigned char>(line[at]) & 0xC0U) == 0x80U; };
  if (length < line.size()) {
    while (length > 0 && goes_on(length)) --length;
  }
  if (length > 0) std::memcpy(error->message, line.data(), length);
  error->message[length] = '\0';
  return status;
}

}  // namespace penpose::capi
