#include "replay/recording/byte_stream.h"

#include <algorithm>
#include <cstring>

namespace penpose::replay {
namespace {

/// Lines of a file to a converter, chunk by chunk.
class LineFeed {
 public:
  LineFeed(ReadBytes read, std::shared_ptr<LineConverter> converter)
      : read_(std::move(read)), converter_(std::move(converter)), chunk_(k_chunk) {}

  base::Result<bool> next(std::string& out) {
    const auto got = read_(chunk_);
    if (!got) return got.error();
    std::string_view text = base::as_text(base::Bytes(chunk_).first(std::min(*got, chunk_.size())));
    if (text.empty()) {
      if (length_ > 0) {
        if (auto done = end_line(out, ""); !done) return done.error();
      }
      converter_->finish(out);
      return false;
    }
    while (!text.empty()) {
      const std::size_t found = text.find('\n');
      if (auto done = add(text.substr(0, found)); !done) return done.error();
      if (found == std::string_view::npos) break;
      if (auto done = end_line(out, "\n"); !done) return done.error();
      text.remove_prefix(found + 1);
    }
    return true;
  }

 private:
  base::Status add(std::string_view text) {
    length_ += text.size();
    if (length_ > TraceReader::k_most_of_a_line) {
      return base::Error{"a line of more than " + std::to_string(TraceReader::k_most_of_a_line >> 20) + " MiB",
                         "line " + std::to_string(lines_ + 1), "give a recording, which is text"};
    }
    line_ += text.substr(0, TraceReader::k_longest_line - std::min(line_.size(), TraceReader::k_longest_line));
    return base::Done{};
  }

  base::Status end_line(std::string& out, std::string_view end) {
    std::string_view line = line_;
    if (!end.empty() && line.ends_with('\r')) line.remove_suffix(1);
    ++lines_;
    const std::size_t before = out.size();
    if (auto done = converter_->line(line, out); !done) return done.error();
    written_ +=
        static_cast<std::uint64_t>(std::count(out.begin() + static_cast<std::ptrdiff_t>(before), out.end(), '\n'));
    for (; written_ < lines_; ++written_) out += '\n';
    line_.clear();
    length_ = 0;
    return base::Done{};
  }

  ReadBytes read_;
  std::shared_ptr<LineConverter> converter_;
  std::vector<std::uint8_t> chunk_;
  std::string line_;         ///< what was read of the line so far, cut
  std::size_t length_ = 0;   ///< of the line, uncut
  std::uint64_t lines_ = 0;  ///< of the file
  std::uint64_t written_ = 0;
};

}  // namespace

base::Result<base::Bytes> ByteStream::peek(std::size_t count) {
  if (begin_ > 0) {
    buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(begin_));
    begin_ = 0;
  }
  while (!at_end_ && buffer_.size() < count) {
    const std::size_t filled = buffer_.size();
    buffer_.resize(std::min(count, filled + k_chunk));
    const auto got = read_(std::span(buffer_).subspan(filled));
    buffer_.resize(filled + (got ? std::min(*got, buffer_.size() - filled) : 0));
    if (!got) return got.error();
    at_end_ = *got == 0;
  }
  return base::Bytes(buffer_).first(std::min(count, buffer_.size()));
}

void ByteStream::skip(std::size_t count) {
  count = std::min(count, buffer_.size() - begin_);
  begin_ += count;
  offset_ += count;
}

base::Result<std::size_t> ByteStream::read(std::span<std::uint8_t> into) {
  const std::size_t held = std::min(buffer_.size() - begin_, into.size());
  if (held == 0) {
    if (at_end_) return std::size_t{0};
    const auto got = read_(into);
    if (got) offset_ += *got;
    return got;
  }
  std::copy_n(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_), held, into.begin());
  skip(held);
  return held;
}

ReadBytes read_pieces(NextPiece next) {
  struct State {
    NextPiece next;
    std::string piece;
    std::size_t given = 0;
    bool more = true;
  };
  auto state = std::make_shared<State>();
  state->next = std::move(next);
  return [state](std::span<std::uint8_t> into) -> base::Result<std::size_t> {
    while (state->given == state->piece.size() && state->more) {
      state->piece.clear();
      state->given = 0;
      const auto more = state->next(state->piece);
      if (!more) return more.error();
      state->more = *more;
    }
    const std::size_t count = std::min(into.size(), state->piece.size() - state->given);
    std::memcpy(into.data(), state->piece.data() + state->given, count);
    state->given += count;
    return count;
  };
}

ReadBytes convert_lines(ReadBytes read, std::shared_ptr<LineConverter> converter) {
  auto feed = std::make_shared<LineFeed>(std::move(read), std::move(converter));
  return read_pieces([feed](std::string& out) { return feed->next(out); });
}

void find_line(base::Bytes front, const std::function<bool(std::string_view line)>& found) {
  std::string_view text = base::as_text(front);
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos && front.size() >= k_front) return;
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (found(line) || end == std::string_view::npos) return;
    text.remove_prefix(end + 1);
  }
}

}  // namespace penpose::replay
