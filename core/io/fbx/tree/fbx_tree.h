#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::io {

/// A value of a record: a whole number, another number, text, or an array of one of both.
using FbxValue = std::variant<std::int64_t, double, std::string, std::vector<std::int64_t>, std::vector<double>>;

/// A record of an FBX file: its name, its values and the records within.
struct FbxRecord {
  std::string name;
  std::vector<FbxValue> values;
  std::vector<FbxRecord> records;

  /// The first record of that name; null: none.
  [[nodiscard]] const FbxRecord* find(std::string_view record) const;
  /// The value's number or text; 0 or empty where there is none or of another kind.
  [[nodiscard]] std::int64_t whole(std::size_t value) const;
  [[nodiscard]] double number(std::size_t value) const;
  [[nodiscard]] std::string_view text(std::size_t value) const;
  /// The numbers of the array in the record of that name; empty: none.
  [[nodiscard]] std::vector<double> numbers(std::string_view record) const;
  [[nodiscard]] std::vector<std::int64_t> wholes(std::string_view record) const;
};

struct FbxTree {
  std::uint32_t version = 0;  ///< 7400 for 7.4
  FbxRecord root;
};

/// Reads the records of a binary or text file of versions 7.x. Nothing says what they mean. Errors (place: byte offset
/// or line): another version, cut off or damaged, arrays of over 512 MB in all, records nested deeper than 32.
[[nodiscard]] base::Result<FbxTree> read_fbx_tree(base::Bytes bytes);

[[nodiscard]] bool is_binary_fbx(base::Bytes bytes);
/// Whether the bytes begin as text files of FBX do.
[[nodiscard]] bool is_text_fbx(base::Bytes bytes);

}  // namespace penpose::io
