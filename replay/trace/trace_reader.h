#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "replay/trace/trace_line.h"

namespace penpose::replay {

/// Fills the start of a buffer with the next bytes of a file and gives their number, 0 at the end.
using ReadBytes = std::function<base::Result<std::size_t>(std::span<std::uint8_t>)>;

/// Bytes that are in memory already, as a file; they must outlive it.
[[nodiscard]] ReadBytes read_from(base::Bytes bytes);

/// Reads a trace line by line in memory that does not grow with the file. Written one after another, `text` and `end`
/// of all lines are the file's bytes.
class TraceReader {
 public:
  /// The longest line that is read as one, a report descriptor of 64 KiB among them; a longer one comes in pieces of
  /// kind `other`, all with its number.
  static constexpr std::size_t k_longest_line = std::size_t{1} << 18;

  /// What has no break of a line in so many bytes is no text.
  static constexpr std::size_t k_most_of_a_line = std::size_t{1} << 26;

  explicit TraceReader(ReadBytes read);

  /// The next line, nothing at the end. Errors: those of reading, and a line longer than k_most_of_a_line.
  base::Result<std::optional<TraceLine>> next();

  /// Once the end is reached: what is wrong with a last line that was cut off in the middle; nothing when the trace is
  /// whole.
  [[nodiscard]] const std::optional<base::Error>& cut() const { return cut_; }
  [[nodiscard]] const TraceStyle& style() const { return style_; }

 private:
  base::Status fill();
  TraceLine take(std::size_t length, std::size_t end_length);
  void note_style(const TraceLine& line);

  ReadBytes read_;
  std::vector<std::uint8_t> buffer_;
  std::size_t begin_ = 0;  ///< unread bytes of the buffer
  std::size_t end_ = 0;
  bool at_end_ = false;
  bool in_long_line_ = false;
  std::size_t long_line_ = 0;  ///< bytes of it so far
  std::uint64_t number_ = 0;
  std::vector<std::uint8_t> bytes_;
  TraceStyle style_;
  std::optional<base::Error> cut_;
};

}  // namespace penpose::replay
