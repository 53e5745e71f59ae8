#include "core/base/text/utf8.h"
#include "replay/recording/byte_stream.h"
#include "replay/recording/formats.h"

namespace penpose::replay {
namespace {

constexpr char32_t k_replacement = 0xfffd;

bool is_utf16(base::Bytes front) {
  return front.size() >= 2 && ((front[0] == 0xff && front[1] == 0xfe) || (front[0] == 0xfe && front[1] == 0xff));
}

bool is_high(char32_t unit) { return unit >= 0xd800 && unit < 0xdc00; }
bool is_low(char32_t unit) { return unit >= 0xdc00 && unit < 0xe000; }

/// UTF-16 as UTF-8 (RFC 2781). Halves of pairs that stand alone become U+FFFD.
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
    for (; at + 1 < chunk.size(); at += 2) {
      const char32_t unit = unit_at(chunk, at);
      if (is_high(unit)) {
        if (at + 3 >= chunk.size() && !last) break;
        const char32_t second = at + 3 < chunk.size() ? unit_at(chunk, at + 2) : 0;
        if (is_low(second)) {
          out += base::utf8_of(0x10000 + ((unit - 0xd800) << 10) + (second - 0xdc00));
          at += 2;
          continue;
        }
      }
      out += base::utf8_of(is_high(unit) || is_low(unit) ? k_replacement : unit);
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

ReadBytes recode(ReadBytes read) {
  auto recoder = std::make_shared<Recoder>(std::move(read));
  return read_pieces([recoder](std::string& out) { return recoder->next(out); });
}

}  // namespace

RecordingFormat utf16_recording() { return {"UTF-16", is_utf16, nullptr, recode, nullptr}; }

}  // namespace penpose::replay
