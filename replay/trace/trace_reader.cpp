#include "replay/trace/trace_reader.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>

namespace penpose::replay {

namespace {

/// Enough for nearly every line; it grows for the long ones.
constexpr std::size_t k_first_buffer = std::size_t{1} << 14;

}  // namespace

ReadBytes read_from(base::Bytes bytes) {
  return [bytes](std::span<std::uint8_t> into) mutable -> base::Result<std::size_t> {
    const std::size_t count = std::min(bytes.size(), into.size());
    std::copy_n(bytes.begin(), count, into.begin());
    bytes = bytes.subspan(count);
    return count;
  };
}

TraceReader::TraceReader(ReadBytes read) : read_(std::move(read)), buffer_(k_first_buffer) {}

base::Status TraceReader::fill() {
  if (begin_ > 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  if (end_ == buffer_.size() && buffer_.size() < 2 * k_longest_line) buffer_.resize(2 * buffer_.size());
  while (!at_end_ && end_ < buffer_.size()) {
    const auto got = read_(std::span(buffer_).subspan(end_));
    if (!got) return got.error();
    if (*got == 0) at_end_ = true;
    end_ += std::min(*got, buffer_.size() - end_);
  }
  return base::Done{};
}

base::Result<std::optional<TraceLine>> TraceReader::next() {
  const auto find_break = [&]() -> const std::uint8_t* {
    const std::size_t searched = std::min(end_ - begin_, k_longest_line + 2);
    if (searched == 0) return nullptr;
    return static_cast<const std::uint8_t*>(std::memchr(buffer_.data() + begin_, '\n', searched));
  };
  const std::uint8_t* found = find_break();
  while (found == nullptr && !at_end_ && end_ - begin_ < k_longest_line + 2) {
    if (const auto filled = fill(); !filled) return filled.error();
    found = find_break();
  }
  if (begin_ == end_) return std::optional<TraceLine>();

  if (found == nullptr) {
    const std::size_t rest = end_ - begin_;
    if (rest > k_longest_line) {
      long_line_ = in_long_line_ ? long_line_ + k_longest_line : k_longest_line;
      if (long_line_ > k_most_of_a_line) {
        return base::Error{"a line of more than " + std::to_string(k_most_of_a_line >> 20) + " MiB",
                           "line " + std::to_string(number_), "give a trace, which is text"};
      }
      TraceLine piece = take(k_longest_line, 0);
      in_long_line_ = true;
      return std::optional(piece);
    }
    TraceLine line = take(rest, 0);
    if (line.text.size() == 1 && std::string_view("DRNPIE").find(line.text[0]) != std::string_view::npos) {
      line.problem = "is a single letter";
    }
    if (!line.problem.empty()) {
      cut_ = base::Error{"the last line is cut off: it " + std::string(line.problem), "line " + std::to_string(number_),
                         "everything before it was read"};
    }
    return std::optional(line);
  }
  std::size_t length = static_cast<std::size_t>(found - (buffer_.data() + begin_));
  const bool carriage_return = length > 0 && buffer_[begin_ + length - 1] == '\r';
  if (carriage_return) --length;
  TraceLine line = take(length, carriage_return ? 2 : 1);
  in_long_line_ = false;
  return std::optional(line);
}

TraceLine TraceReader::take(std::size_t length, std::size_t end_length) {
  const std::string_view text = base::as_text(base::Bytes(buffer_).subspan(begin_, length));
  const std::string_view end = base::as_text(base::Bytes(buffer_).subspan(begin_ + length, end_length));
  begin_ += length + end_length;
  if (!in_long_line_) ++number_;
  TraceLine line;
  if (in_long_line_ || (end_length == 0 && length == k_longest_line)) {
    line.text = text;
  } else {
    line = parse_trace_line(text, bytes_);
  }
  line.number = number_;
  line.end = end;
  note_style(line);
  return line;
}

void TraceReader::note_style(const TraceLine& line) {
  if (line.end.size() == 2) style_.carriage_return = true;
  switch (line.kind) {
    case TraceLineKind::device:
      style_.blank_after_device = line.text.size() > 2 && line.text[2] == ' ';
      break;
    case TraceLineKind::identity:
      if (line.text.find_first_of("ABCDEF") != std::string_view::npos) style_.upper_case_ids = true;
      break;
    case TraceLineKind::report: {
      const std::size_t start = line.text.find_first_of("0123456789");
      const std::size_t point = line.text.find('.');
      if (point == std::string_view::npos || point <= start) break;
      if (line.text[start] == '0') style_.second_digits = static_cast<int>(std::min<std::size_t>(point - start, 18));
      break;
    }
    default:
      break;
  }
}

}  // namespace penpose::replay
