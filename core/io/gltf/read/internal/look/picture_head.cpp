#include "core/io/gltf/read/internal/look/picture_head.h"

#include <algorithm>
#include <string_view>

#include "core/base/text/letters.h"

namespace penpose::io {
namespace {

std::uint32_t big(base::Bytes bytes, std::size_t at, std::size_t size) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value = (value << 8) | bytes[at + i];
  return value;
}

std::uint32_t little(base::Bytes bytes, std::size_t at, std::size_t size) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value |= static_cast<std::uint32_t>(bytes[at + i]) << (8 * i);
  return value;
}

/// PNG (W3C, third edition), section 5: a signature, then chunks of length, name, data, check sum; IHDR first.
std::optional<PictureHead> png_head(base::Bytes bytes) {
  if (bytes.size() < 33 || base::as_text(bytes.subspan(12, 4)) != "IHDR") return std::nullopt;
  PictureHead head{"image/png", big(bytes, 16, 4), big(bytes, 20, 4), false};
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    const std::size_t length = big(bytes, at, 4);
    if (length > bytes.size() - at - 12) break;
    if (base::as_text(bytes.subspan(at + 4, 4)) == "IEND") {
      head.whole = true;
      break;
    }
    at += 12 + length;
  }
  return head;
}

/// JPEG (ITU T.81), annex B: markers with lengths up to the frame header, which has the size.
std::optional<PictureHead> jpeg_head(base::Bytes bytes) {
  for (std::size_t at = 2; at + 4 <= bytes.size();) {
    if (bytes[at] != 0xff) return std::nullopt;
    const std::uint8_t marker = bytes[at + 1];
    if (marker == 0xff) {
      ++at;
      continue;
    }
    const bool alone = marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
    if (alone) {
      at += 2;
      continue;
    }
    const bool frame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (frame) {
      if (at + 9 > bytes.size()) return std::nullopt;
      return PictureHead{"image/jpeg", big(bytes, at + 7, 2), big(bytes, at + 5, 2), true};
    }
    at += 2 + std::max<std::size_t>(2, big(bytes, at + 2, 2));
  }
  return std::nullopt;
}

/// WebP (RFC 9649), sections 2.5 to 2.7: the size stands in the first chunk.
std::optional<PictureHead> webp_head(base::Bytes bytes) {
  if (bytes.size() < 30) return std::nullopt;
  PictureHead head{"image/webp", 0, 0, little(bytes, 4, 4) <= bytes.size() - 8};
  const std::string_view chunk = base::as_text(bytes.subspan(12, 4));
  if (chunk == "VP8X") {
    head.width = little(bytes, 24, 3) + 1;
    head.height = little(bytes, 27, 3) + 1;
  } else if (chunk == "VP8L") {
    const std::uint32_t bits = little(bytes, 21, 4);
    head.width = (bits & 0x3fff) + 1;
    head.height = ((bits >> 14) & 0x3fff) + 1;
  } else if (chunk == "VP8 ") {
    head.width = little(bytes, 26, 2) & 0x3fff;
    head.height = little(bytes, 28, 2) & 0x3fff;
  } else {
    return std::nullopt;
  }
  return head;
}

}  // namespace

std::optional<PictureHead> read_picture_head(base::Bytes bytes) {
  const std::string_view text = base::as_text(bytes);
  if (text.starts_with("\x89PNG\r\n\x1a\n")) return png_head(bytes);
  if (text.starts_with("\xff\xd8\xff")) return jpeg_head(bytes);
  if (text.starts_with("RIFF") && bytes.size() >= 12 && text.substr(8, 4) == "WEBP") return webp_head(bytes);
  if (text.starts_with("\xabKTX 20\xbb") && bytes.size() >= 28)
    return PictureHead{"image/ktx2", little(bytes, 20, 4), little(bytes, 24, 4), true};
  return std::nullopt;
}

}  // namespace penpose::io
