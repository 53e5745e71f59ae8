#include "core/io/fbx/tree/fbx_tree.h"

#include <algorithm>

#include "core/base/text/letters.h"
#include "core/io/fbx/tree/fbx_forms.h"

namespace penpose::io {
namespace {

constexpr std::string_view k_beginning = "Kaydara FBX Binary  ";
constexpr std::string_view k_other_end("Kaydara FBX Binary  \0\x1a\1", 23);  ///< numbers begin with their high bytes

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
  if (text.starts_with(k_fbx_magic)) return read_binary_fbx(bytes);
  if (text.starts_with(k_other_end)) {
    return base::Error{"the file has its numbers high bytes first", "byte offset 22",
                       "export it as binary FBX for other machines, or as text"};
  }
  if (text.starts_with(k_beginning)) {
    return base::Error{"the bytes of a binary FBX file were changed as if they were text", "byte offset 20",
                       "download or copy the file itself again, as it is"};
  }
  return read_text_fbx(bytes);
}

}  // namespace penpose::io
