#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/io/text/text_lines.h"
#include "core/io/tracks/read_track.h"
#include "core/io/tracks/values/value_rows.h"
#include "core/io/tracks/values/value_tables.h"

namespace penpose::io {
namespace {

constexpr std::string_view k_ext = "/VMC/Ext/";
constexpr double k_vmc_fps = 60;

/// The words of a message as text or JSON: what stands in quotes is one, other signs part them.
class MessageWords {
 public:
  explicit MessageWords(std::string_view text) : text_(text) {}
  struct Word {
    std::string_view text;
    bool quoted = false;
  };
  std::optional<Word> next() {
    constexpr std::string_view k_parts = " \t\r\n,:;()[]{}=";
    while (!text_.empty() && k_parts.find(text_.front()) != std::string_view::npos) text_.remove_prefix(1);
    if (text_.empty()) return std::nullopt;
    if (const char quote = text_.front(); quote == '"' || quote == '\'') {
      const std::size_t end = text_.find(quote, 1);
      const Word word{text_.substr(1, std::min(end, text_.size()) - 1), true};
      text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
      return word;
    }
    std::size_t end = 0;
    // The colons of a time of the day stay.
    while (end < text_.size() && (k_parts.find(text_[end]) == std::string_view::npos || is_within_time(end))) ++end;
    const Word word{text_.substr(0, end), false};
    text_.remove_prefix(end);
    return word;
  }

 private:
  [[nodiscard]] bool is_within_time(std::size_t at) const {
    const auto digit = [&](std::size_t i) { return i < text_.size() && text_[i] >= '0' && text_[i] <= '9'; };
    return text_[at] == ':' && at > 0 && digit(at - 1) && digit(at + 1);
  }
  std::string_view text_;
};

/// Words of how a message is written down rather than of it.
bool is_frame_word(std::string_view word) {
  constexpr std::array<std::string_view, 14> k_words{"args",  "arguments", "values", "value", "type",
                                                     "types", "s",         "f",      "sf",    "name",
                                                     "data",  "string",    "float",  "params"};
  return std::any_of(k_words.begin(), k_words.end(), [&](std::string_view one) { return one == word; });
}

bool is_vmc_time(std::string_view word) {
  return base::parse_double(word).has_value() || parse_timecode(word).has_value();
}

class VmcReader {
 public:
  base::Status read(std::string_view text) {
    std::size_t line = 1;
    std::size_t counted = 0;
    std::size_t at = text.find(k_ext);
    tail(text.substr(0, std::min(at, text.size())));
    while (at != std::string_view::npos) {
      line += static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(counted),
                                                  text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
      counted = at;
      const std::size_t next = text.find(k_ext, at + 1);
      std::string_view message =
          text.substr(at + k_ext.size(), (next == std::string_view::npos ? text.size() : next) - at - k_ext.size());
      if (auto taken = take(message, line); !taken) return taken;
      at = next;
    }
    if (dirty_ && !applied_) return close(line);
    return base::Done{};
  }

  [[nodiscard]] bool empty() const { return rows_.values.empty(); }
  base::Result<animation::WeightTrack> finish() {
    if (bones_) rows_.notes.emplace_back("it has bones as well, which are left out");
    for (auto& values : rows_.values) values.resize(rows_.names.size());
    return make_value_track(std::move(rows_), clock_);
  }

 private:
  /// The last time that follows a message's own words is the time of the next message.
  void tail(std::string_view text) {
    MessageWords words(text);
    while (const auto word = words.next()) {
      if (is_vmc_time(word->text)) stamp_ = word->text;
    }
  }

  base::Status take(std::string_view message, std::size_t line) {
    const bool value = message.starts_with("Blend/Val");
    if (message.starts_with("Blend/Apply")) {
      applied_ = true;
      auto closed = dirty_ ? close(line) : base::Status(base::Done{});
      tail(message);
      return closed;
    }
    bones_ = bones_ || message.starts_with("Bone/");
    if (!value && !message.starts_with("T")) {
      const std::size_t end = message.find('\n');
      if (end != std::string_view::npos) tail(message.substr(end));
      return base::Done{};
    }
    const std::size_t address = message.find_first_of(" \t\r\n,:;()[]{}=\"'");
    if (address == std::string_view::npos) return base::Done{};
    // The quote that ends an address of JSON.
    message.remove_prefix(address + (message[address] == '"' || message[address] == '\'' ? 1 : 0));
    MessageWords words(message);
    std::optional<std::string_view> name;
    std::optional<double> number;
    std::string_view stamp = stamp_;
    while (const auto word = words.next()) {
      if (value && !name) {
        if (!is_frame_word(word->text) && (word->quoted || !base::parse_double(word->text))) name = word->text;
      } else if (!number) {
        number = base::parse_double(word->text);
      } else if (is_vmc_time(word->text)) {
        stamp = word->text;
      }
    }
    if (!value && number) relative_s_ = number;
    if (value && name && number && !name->empty() && name->size() <= 200) {
      if (auto set = this->set(*name, *number, line); !set) return set;
    }
    stamp_ = stamp;
    return base::Done{};
  }

  base::Status set(std::string_view name, double value, std::size_t line) {
    auto found = index_.find(name);
    // Without a word that ends a frame, a name that comes again begins the next one.
    if (!applied_ && found != index_.end() && seen_[found->second]) {
      if (auto closed = close(line); !closed) return closed;
    }
    if (found == index_.end()) {
      if (index_.size() >= 10'000)
        return base::Error{"a take has at most 10,000 names", "line " + std::to_string(line), "cut it"};
      found = index_.emplace(std::string(name), rows_.names.size()).first;
      rows_.names.emplace_back(name);
      now_.push_back(0);
      seen_.push_back(false);
    }
    now_[found->second] = std::isfinite(value) && std::abs(value) < 1e6 ? value : 0;
    seen_[found->second] = true;
    dirty_ = true;
    return base::Done{};
  }

  base::Status close(std::size_t line) {
    if (rows_.values.size() >= k_most_track_frames || (rows_.values.size() + 1) * rows_.names.size() > k_most_values) {
      return base::Error{"the take has too many frames", "line " + std::to_string(line), "cut it"};
    }
    rows_.values.push_back(now_);
    rows_.why.emplace_back();
    rows_.named.push_back("line " + std::to_string(line));
    if (relative_s_) {
      clock_.add("", relative_s_);
    } else {
      clock_.add(stamp_, base::parse_double(stamp_));
    }
    relative_s_.reset();
    std::fill(seen_.begin(), seen_.end(), false);
    dirty_ = false;
    return base::Done{};
  }

  ValueRows rows_;
  ValueClock clock_{k_vmc_fps};
  std::map<std::string, std::size_t, std::less<>> index_;
  std::vector<double> now_;
  std::vector<bool> seen_;
  std::optional<double> relative_s_;  ///< of "/VMC/Ext/T" since the last frame
  std::string_view stamp_;
  bool dirty_ = false, applied_ = false, bones_ = false;
};

}  // namespace

bool has_vmc(std::string_view text) {
  constexpr std::size_t k_beginning = std::size_t{1} << 18U;
  return text.substr(0, k_beginning).find("/VMC/Ext/Blend/") != std::string_view::npos;
}

base::Result<animation::WeightTrack> read_vmc_dump(base::Bytes bytes) {
  VmcReader reader;
  if (auto read = reader.read(base::as_text(bytes)); !read) return read.error();
  if (reader.empty())
    return base::Error{"there is no /VMC/Ext/Blend/Val with a name and a value", "line 1", "write down all messages"};
  return reader.finish();
}

}  // namespace penpose::io
