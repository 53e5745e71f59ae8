#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/interface.h"
#include "replay/recording/recording_format.h"

namespace penpose::replay {

/// A good number of bytes to read at once.
inline constexpr std::size_t k_chunk = std::size_t{1} << 14;

/// The bytes of a file one after another, with a look ahead. Memory is bounded by what is looked at in one piece.
class ByteStream {
 public:
  explicit ByteStream(ReadBytes read) : read_(std::move(read)) {}

  /// The next `count` bytes without taking them, fewer only at the end of the file; valid until the next call of
  /// anything here. Errors: those of reading.
  base::Result<base::Bytes> peek(std::size_t count);
  /// Takes bytes that peek has shown.
  void skip(std::size_t count);
  /// What ReadBytes does: gives bytes that were looked at first, then the file's.
  base::Result<std::size_t> read(std::span<std::uint8_t> into);
  /// Bytes taken so far: the place of what comes next.
  [[nodiscard]] std::uint64_t offset() const { return offset_; }

 private:
  ReadBytes read_;
  std::vector<std::uint8_t> buffer_;
  std::size_t begin_ = 0;  ///< of the bytes not yet taken
  bool at_end_ = false;
  std::uint64_t offset_ = 0;
};

/// Appends the next piece of text to `out`, which may also stay empty; false at the end, with what is left in `out`.
using NextPiece = std::function<base::Result<bool>(std::string& out)>;

/// The text of all pieces as a file. Pieces should be bounded: one is held at a time.
[[nodiscard]] ReadBytes read_pieces(NextPiece next);

/// The same of a converter that is made of the file, piece by piece by its `next`.
template <typename Converter>
[[nodiscard]] ReadBytes read_through(ReadBytes read) {
  auto converter = std::make_shared<Converter>(std::move(read));
  return read_pieces([converter](std::string& out) { return converter->next(out); });
}

/// Makes text of a file's text line by line: `line` is without its end ("\n" or "\r\n") and cut to
/// TraceReader::k_longest_line bytes. What a line comes to is appended to `out` as whole lines. Where that is nothing,
/// an empty line is written, so that numbers of lines stay near those of the file.
class LineConverter : public base::Interface {
 public:
  virtual base::Status line(std::string_view text, std::string& out) = 0;
  /// After the last line.
  virtual void finish(std::string& out) = 0;
};
[[nodiscard]] ReadBytes convert_lines(ReadBytes read, std::shared_ptr<LineConverter> converter);

/// Calls `found` for each line of a file's front until it gives true; a last line that may be cut off is left out.
void find_line(base::Bytes front, const std::function<bool(std::string_view line)>& found);

}  // namespace penpose::replay
