#include "core/io/tracks/read_pgm.h"

#include <algorithm>

#include "core/base/numbers.h"

namespace penpose::io {
namespace {

bool is_blank_in_pgm(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  [[nodiscard]] std::size_t offset() const { return at_; }
  /// The next number after blanks and comments.
  std::optional<std::int64_t> number() {
    while (at_ < text_.size() && (is_blank_in_pgm(text_[at_]) || text_[at_] == '#')) {
      if (text_[at_] == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else {
        ++at_;
      }
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9' && at_ - begin < 10) ++at_;
    return base::parse_int(text_.substr(begin, at_ - begin));
  }
  void skip(std::size_t count) { at_ = std::min(at_ + count, text_.size()); }
  [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

base::Result<animation::GreyImage> read_pgm(base::Bytes bytes) {
  const std::string_view text = base::as_text(bytes);
  const bool binary = text.starts_with("P5");
  const auto fail = [](std::string what, std::size_t offset) {
    return base::Error{std::move(what), "byte offset " + std::to_string(offset),
                       "export the picture as 8-bit PGM or PNG"};
  };
  if (!binary && !text.starts_with("P2")) return fail("no portable grey map", 0);
  Reader reader(text);
  reader.skip(2);
  constexpr std::int64_t k_largest = 16384;
  const auto width = reader.number();
  const auto height = reader.number();
  const auto maximum = reader.number();
  if (!width || !height || *width < 1 || *height < 1 || *width > k_largest || *height > k_largest) {
    return fail("a size of 1 to 16384 was expected", reader.offset());
  }
  if (!maximum || *maximum < 1 || *maximum > 255)
    return fail("a greatest value of 1 to 255 was expected", reader.offset());
  animation::GreyImage image;
  image.width = static_cast<int>(*width);
  image.height = static_cast<int>(*height);
  const auto count = static_cast<std::size_t>(*width * *height);
  const auto scaled = [&](std::int64_t value) {
    return static_cast<std::uint8_t>(std::min(value, *maximum) * 255 / *maximum);
  };
  reader.skip(binary ? 1 : 0);
  // Even as text each pixel takes at least one byte.
  if (reader.rest().size() < count) return fail("the file has fewer pixels than its header says", bytes.size());
  image.pixels.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (binary) {
      image.pixels.push_back(scaled(static_cast<std::uint8_t>(reader.rest()[i])));
      continue;
    }
    const auto value = reader.number();
    if (!value || *value < 0) return fail("a grey value was expected", reader.offset());
    image.pixels.push_back(scaled(*value));
  }
  return image;
}

}  // namespace penpose::io
