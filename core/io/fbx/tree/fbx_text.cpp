#include <charconv>
#include <optional>

#include "core/base/text/letters.h"
#include "core/io/fbx/tree/fbx_forms.h"
#include "core/io/remedies.h"

namespace penpose::io {
namespace {

/// A file may have this many records, plus one for every `k_bytes_a_record` bytes.
constexpr std::size_t k_least_records = 1000, k_bytes_a_record = 8;

class TextReader {
 public:
  explicit TextReader(base::Bytes bytes) : text_(base::without_mark(base::as_text(bytes))) {}

  base::Result<FbxTree> read() {
    FbxTree tree;
    // Old files are of another form: their version comes first.
    if (const auto old = version_in_text(); old && *old < k_oldest_fbx) return old_fbx_version(*old);
    if (auto status = read_list(tree.root, 0); !status) return status.error();
    if (const FbxRecord* header = tree.root.find("FBXHeaderExtension")) {
      if (const FbxRecord* version = header->find("FBXVersion"))
        tree.version = static_cast<std::uint32_t>(version->whole(0));
    }
    if (tree.version < k_oldest_fbx) return old_fbx_version(tree.version);
    return tree;
  }

 private:
  [[nodiscard]] std::optional<std::uint32_t> version_in_text() const {
    constexpr std::string_view k_name = "FBXVersion:";
    const std::string_view head = text_.substr(0, 4096);
    std::size_t at = head.find(k_name);
    if (at == std::string_view::npos) return std::nullopt;
    at = head.find_first_not_of(" \t", at + k_name.size());
    std::uint32_t version = 0;
    if (at == std::string_view::npos ||
        std::from_chars(head.data() + at, head.data() + head.size(), version).ec != std::errc())
      return std::nullopt;
    return version;
  }
  [[nodiscard]] base::Error damaged(const char* what) const {
    return {what, "line " + std::to_string(line_), k_copy_again};
  }
  void skip(bool lines) {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == ';') {
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
      } else if (c == '\n') {
        if (!lines) return;
        ++line_;
        ++at_;
      } else if (c == ' ' || c == '\t' || c == '\r') {
        ++at_;
      } else {
        return;
      }
    }
  }
  [[nodiscard]] bool next_is(char c) const { return at_ < text_.size() && text_[at_] == c; }

  /// Records up to a closing brace, or to the end of the file.
  base::Status read_list(FbxRecord& into, int depth) {
    if (depth > k_deepest_fbx_record) return damaged("records are nested too deeply");
    for (skip(true); at_ < text_.size(); skip(true)) {
      if (next_is('}')) {
        if (depth == 0) return damaged("a brace closes nothing");
        ++at_;
        return base::Done{};
      }
      const std::size_t colon = text_.find_first_of(":\n{}", at_);
      if (colon == std::string_view::npos || text_[colon] != ':') return damaged("a record has no name");
      if (++records_ > k_least_records + text_.size() / k_bytes_a_record) return damaged("it has too many records");
      FbxRecord record;
      record.name = text_.substr(at_, colon - at_);
      at_ = colon + 1;
      if (auto status = read_values(record, depth); !status) return status;
      into.records.push_back(std::move(record));
    }
    if (depth > 0) return damaged("the file ends within a record");
    return base::Done{};
  }

  base::Status read_values(FbxRecord& record, int depth) {
    skip(false);
    if (next_is('*')) return read_array(record);
    while (at_ < text_.size()) {
      skip(false);
      if (at_ >= text_.size() || next_is('\n')) break;
      if (next_is('{')) {
        ++at_;
        return read_list(record, depth + 1);
      }
      if (next_is('}')) break;
      if (next_is(',')) {
        ++at_;
        skip(true);
        continue;
      }
      if (next_is('"')) {
        const std::size_t end = text_.find('"', at_ + 1);
        if (end == std::string_view::npos) return damaged("text has no end");
        record.values.emplace_back(std::string(text_.substr(at_ + 1, end - at_ - 1)));
        at_ = end + 1;
        continue;
      }
      const std::string_view word = take_word();
      if (word.empty()) return damaged("a value cannot be read");
      record.values.push_back(value_of(word));
    }
    return base::Done{};
  }
  std::string_view take_word() {
    const std::size_t from = at_;
    while (at_ < text_.size() && std::string_view(" \t\r\n,{};").find(text_[at_]) == std::string_view::npos) ++at_;
    return text_.substr(from, at_ - from);
  }
  static FbxValue value_of(std::string_view word) {
    std::int64_t whole = 0;
    const char* end = word.data() + word.size();
    if (const auto got = std::from_chars(word.data(), end, whole); got.ec == std::errc() && got.ptr == end)
      return whole;
    double number = 0;
    if (const auto got = std::from_chars(word.data(), end, number); got.ec == std::errc() && got.ptr == end)
      return number;
    return std::string(word);
  }

  /// *COUNT { a: 1,2,3 }
  base::Status read_array(FbxRecord& record) {
    ++at_;
    (void)take_word();
    skip(true);
    if (!next_is('{')) return damaged("an array has no brace");
    ++at_;
    skip(true);
    if (text_.substr(at_, 2) == "a:") at_ += 2;
    std::vector<double> numbers;
    std::vector<std::int64_t> wholes;
    bool real = false;
    for (skip(true); at_ < text_.size() && !next_is('}'); skip(true)) {
      if (next_is(',')) {
        ++at_;
        continue;
      }
      const std::string_view word = take_word();
      const FbxValue value = value_of(word);
      if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        wholes.push_back(*whole);
        numbers.push_back(static_cast<double>(*whole));
      } else if (const auto* number = std::get_if<double>(&value)) {
        real = true;
        numbers.push_back(*number);
      } else {
        return damaged("an array holds what is no number");
      }
    }
    if (!next_is('}')) return damaged("an array has no end");
    ++at_;
    if (real) {
      record.values.emplace_back(std::move(numbers));
    } else {
      record.values.emplace_back(std::move(wholes));
    }
    return base::Done{};
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::size_t records_ = 0;
};

}  // namespace

base::Result<FbxTree> read_text_fbx(base::Bytes bytes) { return TextReader(bytes).read(); }

}  // namespace penpose::io
