#include "ui/capi/call.h"

#include <algorithm>
#include <cstring>

namespace penpose::capi {

void copy_text(std::string_view text, std::span<char> out) noexcept {
  std::size_t length = std::min(text.size(), out.size() - 1);
  // Bytes of a character that goes on.
  const auto goes_on = [&](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U; };
  if (length < text.size()) {
    while (length > 0 && goes_on(length)) --length;
  }
  if (length > 0) std::memcpy(out.data(), text.data(), length);
  out[length] = '\0';
}

std::int32_t tell(penpose_error* error, penpose_status status, std::string_view line) noexcept {
  if (error == nullptr) return status;
  error->status = status;
  copy_text(line, error->message);
  return status;
}

}  // namespace penpose::capi
