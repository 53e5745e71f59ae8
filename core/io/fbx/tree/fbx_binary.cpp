#include <optional>
#include <zlib.h>

#include "core/io/fbx/tree/fbx_forms.h"
#include "core/io/remedies.h"

namespace penpose::io {
namespace {

constexpr std::size_t k_least_unpacked = std::size_t{1} << 20;
/// Times the size of the file.
constexpr std::size_t k_most_unpacked = 40;

constexpr std::size_t k_most_fbx_bytes = std::size_t{512} << 20;
constexpr std::uint32_t k_long_offsets = 7500;  ///< from this version on offsets have 64 bits

class BinaryReader {
 public:
  explicit BinaryReader(base::Bytes bytes) : bytes_(bytes), reader_(bytes) {}

  base::Result<FbxTree> read() {
    reader_.seek(k_fbx_magic.size());
    const auto version = reader_.read<std::uint32_t>();
    if (!version) return cut();
    if (*version < k_oldest_fbx) return old_fbx_version(*version);
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
    if (depth > k_deepest_fbx_record) return base::Error{"records are nested too deeply", place(), k_copy_again};
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
    if (used_ > k_most_fbx_bytes)
      return base::Error{"the arrays of the file are larger than 512 MB", place(), "simplify it"};
    const auto raw = reader_.take(*packed != 0 ? std::size_t{*length} : bytes);
    if (!raw) return cut();
    std::vector<std::uint8_t> plain;
    base::Bytes data = *raw;
    if (*packed != 0) {
      // Deflate packs no more than 1032 to one.
      if (bytes / 1032 > raw->size()) return cut();
      unpacked_ += bytes;
      if (unpacked_ > k_least_unpacked + k_most_unpacked * bytes_.size())
        return base::Error{"the arrays of the file unpack to more than 40 times its size", place(), "simplify it"};
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
  std::size_t unpacked_ = 0;  ///< bytes
};

}  // namespace

base::Result<FbxTree> read_binary_fbx(base::Bytes bytes) { return BinaryReader(bytes).read(); }

base::Error old_fbx_version(std::uint32_t version) {
  return {"the file is of FBX version " + std::to_string(version / 1000) + "." + std::to_string(version / 100 % 10), "",
          "export it as FBX 7.4 (2014) or later"};
}

}  // namespace penpose::io
