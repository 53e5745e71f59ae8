#include "core/base/text/utf16.h"
#include "core/base/text/utf8.h"
#include "replay/recording/byte_stream.h"
#include "replay/recording/formats.h"

namespace penpose::replay {
namespace {

bool is_utf16(base::Bytes front) {
  return front.size() >= 2 && ((front[0] == 0xff && front[1] == 0xfe) || (front[0] == 0xfe && front[1] == 0xff));
}

/// UTF-16 as UTF-8. Halves of pairs that stand alone become U+FFFD.
class Recoder {
 public:
  explicit Recoder(ReadBytes read) : bytes_(std::move(read)) {}

  base::Result<bool> next(std::string& out) {
    const auto got = bytes_.peek(k_chunk);
    if (!got) return got.error();
    const base::Bytes chunk = *got;
    if (chunk.size() < 2) return false;
    std::size_t at = 0;
    if (!begun_) {
      little_ = chunk[0] == 0xff;
      begun_ = true;
      at = 2;
    }
    const bool last = chunk.size() < k_chunk;
    while (at + 1 < chunk.size()) {
      const bool has_second = at + 3 < chunk.size();
      const char32_t unit = unit_at(chunk, at);
      if (base::is_high_half(unit) && !has_second && !last) break;
      const auto [code, units] = base::utf16_point(unit, has_second ? unit_at(chunk, at + 2) : 0);
      out += base::utf8_of(code);
      at += 2 * units;
    }
    bytes_.skip(at);
    return true;
  }

 private:
  [[nodiscard]] char32_t unit_at(base::Bytes bytes, std::size_t at) const {
    const unsigned first = bytes[at];
    const unsigned second = bytes[at + 1];
    return little_ ? first | second << 8 : first << 8 | second;
  }

  ByteStream bytes_;
  bool begun_ = false;
  bool little_ = true;
};

}  // namespace

RecordingFormat utf16_recording() { return {"UTF-16", is_utf16, nullptr, read_through<Recoder>, nullptr}; }

}  // namespace penpose::replay
