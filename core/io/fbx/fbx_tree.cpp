#include "core/io/fbx/fbx_tree.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <zlib.h>

#include "core/base/text/letters.h"
#include "core/io/remedies.h"

namespace penpose::io {
namespace {

constexpr std::string_view k_beginning = "Kaydara FBX Binary  ";
constexpr std::string_view k_magic("Kaydara FBX Binary  \0\x1a\0", 23);
constexpr std::string_view k_other_end("Kaydara FBX Binary  \0\x1a\1", 23);  ///< numbers begin with their high bytes
constexpr int k_deepest = 32;
constexpr std::size_t k_most_bytes = std::size_t{512} << 20;
constexpr std::uint32_t k_oldest = 7000;
constexpr std::uint32_t k_long_offsets = 7500;  ///< from this version on offsets have 64 bits

base::Error old_version(std::uint32_t version) {
  return {"the file is of FBX version " + std::to_string(version / 1000) + "." + std::to_string(version / 100 % 10), "",
          "export it as FBX 7.4 (2014) or later"};
}

class BinaryReader {
 public:
  explicit BinaryReader(base::Bytes bytes) : bytes_(bytes), reader_(bytes) {}

  base::Result<FbxTree> read() {
    reader_.seek(k_magic.size());
    const auto version = reader_.read<std::uint32_t>();
    if (!version) return cut();
    if (*version < k_oldest) return old_version(*version);
    FbxTree tree;
    tree.version = *version;
    long_ = *version >= k_long_offsets;
    while (true) {
      FbxRecord record;
      auto more = read_record(record, bytes_.size(), 0);
      if (!more) return more.error();
      if (!*more) return tree;
      tree.root.records.push_back(std::move(record));
    }
  }

 private:
  [[nodiscard]] base::Error cut() const {
    return {"a record reaches beyond the file or the one that holds it",
            "byte offset " + std::to_string(reader_.offset()), k_copy_again};
  }
  std::optional<std::uint64_t> read_offset() {
    if (long_) return reader_.read<std::uint64_t>();
    return reader_.read<std::uint32_t>();
  }

  /// False: the record that ends a list.
  base::Result<bool> read_record(FbxRecord& record, std::size_t end_of_list, int depth) {
    const auto end = read_offset();
    const auto count = read_offset();
    const auto length = read_offset();
    const auto name_length = reader_.read<std::uint8_t>();
    if (!end || !count || !length || !name_length) return cut();
    if (*end == 0) return false;
    const auto name = reader_.take(*name_length);
    if (!name || *end > end_of_list || *end < reader_.offset() || *length > *end - reader_.offset()) return cut();
    if (depth > k_deepest) return base::Error{"records are nested too deeply", place(), k_copy_again};
    record.name = base::as_text(*name);
    const std::size_t values_end = reader_.offset() + static_cast<std::size_t>(*length);
    for (std::uint64_t i = 0; i < *count && reader_.offset() < values_end; ++i) {
      if (auto status = read_value(record); !status) return status.error();
    }
    if (reader_.offset() > values_end) return cut();
    reader_.seek(values_end);
    while (reader_.offset() < *end) {
      FbxRecord inner;
      auto more = read_record(inner, static_cast<std::size_t>(*end), depth + 1);
      if (!more) return more.error();
      if (!*more) break;
      record.records.push_back(std::move(inner));
    }
    reader_.seek(static_cast<std::size_t>(*end));
    return true;
  }
  [[nodiscard]] std::string place() const { return "byte offset " + std::to_string(reader_.offset()); }

  template <typename Unsigned, typename Signed>
  bool read_whole(FbxRecord& record) {
    const auto raw = reader_.read<Unsigned>();
    if (raw) record.values.emplace_back(static_cast<std::int64_t>(static_cast<Signed>(*raw)));
    return raw.has_value();
  }

  base::Status read_value(FbxRecord& record) {
    const auto kind = reader_.read<std::uint8_t>();
    if (!kind) return cut();
    bool good = true;
    switch (*kind) {
      case 'Y':
        good = read_whole<std::uint16_t, std::int16_t>(record);
        break;
      case 'B':
      case 'C':
        good = read_whole<std::uint8_t, std::uint8_t>(record);
        break;
      case 'Z':
        good = read_whole<std::uint8_t, std::int8_t>(record);
        break;
      case 'I':
        good = read_whole<std::uint32_t, std::int32_t>(record);
        break;
      case 'L':
        good = read_whole<std::uint64_t, std::int64_t>(record);
        break;
      case 'F': {
        const auto value = reader_.read_f32();
        good = value.has_value();
        if (good) record.values.emplace_back(static_cast<double>(*value));
        break;
      }
      case 'D': {
        const auto value = reader_.read_f64();
        good = value.has_value();
        if (good) record.values.emplace_back(*value);
        break;
      }
      case 'S':
      case 'R': {
        const auto size = reader_.read<std::uint32_t>();
        const auto text = size ? reader_.take(*size) : std::nullopt;
        good = text.has_value();
        if (good) record.values.emplace_back(*kind == 'S' ? std::string(base::as_text(*text)) : std::string());
        break;
      }
      case 'f':
        return read_array(record, 4, true);
      case 'd':
        return read_array(record, 8, true);
      case 'i':
        return read_array(record, 4, false);
      case 'l':
        return read_array(record, 8, false);
      case 'b':
      case 'c':
        return read_array(record, 1, false);
      default:
        return base::Error{"a value is of an unknown kind", place(), k_copy_again};
    }
    if (!good) return cut();
    return base::Done{};
  }

  base::Status read_array(FbxRecord& record, std::size_t size, bool real) {
    const auto count = reader_.read<std::uint32_t>();
    const auto packed = reader_.read<std::uint32_t>();
    const auto length = reader_.read<std::uint32_t>();
    if (!count || !packed || !length) return cut();
    const std::size_t bytes = std::size_t{*count} * size;
    used_ += std::size_t{*count} * 8;
    if (used_ > k_most_bytes)
      return base::Error{"the arrays of the file are larger than 512 MB", place(), "simplify it"};
    const auto raw = reader_.take(*packed != 0 ? std::size_t{*length} : bytes);
    if (!raw) return cut();
    std::vector<std::uint8_t> plain;
    base::Bytes data = *raw;
    if (*packed != 0) {
      // Deflate packs no more than 1032 to one.
      if (bytes / 1032 > raw->size()) return cut();
      plain.resize(bytes);
      uLongf got = static_cast<uLongf>(bytes);
      if (::uncompress(plain.data(), &got, raw->data(), static_cast<uLong>(raw->size())) != Z_OK || got != bytes)
        return base::Error{"an array cannot be unpacked", place(), k_copy_again};
      data = plain;
    }
    base::ByteReader reader(data);
    if (real) {
      std::vector<double> out(*count);
      for (double& one : out) one = size == 4 ? static_cast<double>(*reader.read_f32()) : *reader.read_f64();
      record.values.emplace_back(std::move(out));
      return base::Done{};
    }
    std::vector<std::int64_t> out(*count);
    for (std::int64_t& one : out) {
      one = size == 1   ? static_cast<std::int64_t>(*reader.read<std::uint8_t>())
            : size == 4 ? static_cast<std::int64_t>(static_cast<std::int32_t>(*reader.read<std::uint32_t>()))
                        : static_cast<std::int64_t>(*reader.read<std::uint64_t>());
    }
    record.values.emplace_back(std::move(out));
    return base::Done{};
  }

  base::Bytes bytes_;
  base::ByteReader reader_;
  bool long_ = false;
  std::size_t used_ = 0;
};

class TextReader {
 public:
  explicit TextReader(base::Bytes bytes) : text_(base::without_mark(base::as_text(bytes))) {}

  base::Result<FbxTree> read() {
    FbxTree tree;
    // Old files are of another form: their version comes first.
    if (const auto old = version_in_text(); old && *old < k_oldest) return old_version(*old);
    if (auto status = read_list(tree.root, 0); !status) return status.error();
    if (const FbxRecord* header = tree.root.find("FBXHeaderExtension")) {
      if (const FbxRecord* version = header->find("FBXVersion"))
        tree.version = static_cast<std::uint32_t>(version->whole(0));
    }
    if (tree.version < k_oldest) return old_version(tree.version);
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
    if (depth > k_deepest) return damaged("records are nested too deeply");
    for (skip(true); at_ < text_.size(); skip(true)) {
      if (next_is('}')) {
        if (depth == 0) return damaged("a brace closes nothing");
        ++at_;
        return base::Done{};
      }
      const std::size_t colon = text_.find_first_of(":\n{}", at_);
      if (colon == std::string_view::npos || text_[colon] != ':') return damaged("a record has no name");
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
};

}  // namespace

const FbxRecord* FbxRecord::find(std::string_view record) const {
  const auto at =
      std::find_if(records.begin(), records.end(), [&](const FbxRecord& one) { return one.name == record; });
  return at == records.end() ? nullptr : &*at;
}

std::int64_t FbxRecord::whole(std::size_t value) const {
  if (value >= values.size()) return 0;
  const auto* number = std::get_if<std::int64_t>(&values[value]);
  return number != nullptr ? *number : 0;
}

double FbxRecord::number(std::size_t value) const {
  if (value >= values.size()) return 0;
  const auto* number = std::get_if<double>(&values[value]);
  return number != nullptr ? *number : static_cast<double>(whole(value));
}

std::string_view FbxRecord::text(std::size_t value) const {
  if (value >= values.size()) return {};
  const auto* text = std::get_if<std::string>(&values[value]);
  return text != nullptr ? std::string_view(*text) : std::string_view();
}

std::vector<double> FbxRecord::numbers(std::string_view record) const {
  const FbxRecord* one = find(record);
  if (one == nullptr || one->values.empty()) return {};
  if (const auto* real = std::get_if<std::vector<double>>(&one->values[0])) return *real;
  if (const auto* whole = std::get_if<std::vector<std::int64_t>>(&one->values[0]))
    return {whole->begin(), whole->end()};
  return {};
}

std::vector<std::int64_t> FbxRecord::wholes(std::string_view record) const {
  const FbxRecord* one = find(record);
  if (one == nullptr || one->values.empty()) return {};
  const auto* whole = std::get_if<std::vector<std::int64_t>>(&one->values[0]);
  return whole != nullptr ? *whole : std::vector<std::int64_t>();
}

bool is_binary_fbx(base::Bytes bytes) { return base::as_text(bytes).starts_with(k_beginning); }

bool is_text_fbx(base::Bytes bytes) {
  const std::string_view text = base::without_mark(base::as_text(bytes)).substr(0, 4096);
  return text.starts_with("; FBX ") || text.find("FBXHeaderExtension:") != std::string_view::npos;
}

base::Result<FbxTree> read_fbx_tree(base::Bytes bytes) {
  const std::string_view text = base::as_text(bytes);
  if (text.starts_with(k_magic)) return BinaryReader(bytes).read();
  if (text.starts_with(k_other_end)) {
    return base::Error{"the file has its numbers high bytes first", "byte offset 22",
                       "export it as binary FBX for other machines, or as text"};
  }
  if (text.starts_with(k_beginning)) {
    return base::Error{"the bytes of a binary FBX file were changed as if they were text", "byte offset 20",
                       "download or copy the file itself again, as it is"};
  }
  return TextReader(bytes).read();
}

}  // namespace penpose::io
