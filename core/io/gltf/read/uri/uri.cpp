#include "core/io/gltf/read/uri/uri.h"

#include <algorithm>

#include "core/base/text/letters.h"
#include "core/io/remedies.h"

namespace penpose::io {
namespace {

std::optional<int> base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;
  if (c == '/' || c == '_') return 63;
  return std::nullopt;
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

std::optional<std::vector<std::uint8_t>> decode_base64(std::string_view text) {
  while (!text.empty() && (text.back() == '=' || is_blank(text.back()))) text.remove_suffix(1);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    if (is_blank(c)) continue;
    const auto digit = base64_digit(c);
    if (!digit) return std::nullopt;
    bits = (bits << 6) | static_cast<std::uint32_t>(*digit);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> held));
  }
  return bytes;
}

/// Resolves %XX (RFC 3986, section 2.1).
std::string decode_percent(std::string_view uri) {
  std::string path;
  path.reserve(uri.size());
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size() && base::hex_value(uri[i + 1]) && base::hex_value(uri[i + 2])) {
      path += static_cast<char>(*base::hex_value(uri[i + 1]) * 16 + *base::hex_value(uri[i + 2]));
      i += 2;
    } else {
      path += uri[i];
    }
  }
  return path;
}

std::string plain_path(std::string_view path) {
  std::string plain;
  while (!path.empty()) {
    const std::size_t slash = path.find('/');
    const std::string_view piece = path.substr(0, slash);
    if (!piece.empty() && piece != ".") plain.append(plain.empty() ? "" : "/").append(piece);
    path.remove_prefix(slash == std::string_view::npos ? path.size() : slash + 1);
  }
  return plain;
}

/// A model file may name files in its own folder and below, nothing else.
bool stays_below(std::string_view path) {
  if (path.empty() || path.front() == '/' || path.find(':') != std::string_view::npos) return false;
  if (path.find('\0') != std::string_view::npos) return false;
  while (true) {
    const std::size_t slash = path.find('/');
    if (path.substr(0, slash) == "..") return false;
    if (slash == std::string_view::npos) return true;
    path.remove_prefix(slash + 1);
  }
}

std::optional<std::string> path_of(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  if (!stays_below(name)) return std::nullopt;
  std::string path = plain_path(name);
  return path.empty() ? std::nullopt : std::optional(std::move(path));
}

}  // namespace

bool is_data_uri(std::string_view uri) { return base::lower_case(uri.substr(0, 5)) == "data:"; }

base::Result<std::vector<std::uint8_t>> decode_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) {
    return base::Error{"a data: URI without a comma before its data", "", k_copy_again};
  }
  const std::string_view data = uri.substr(comma + 1);
  const bool escaped = data.find('%') != std::string_view::npos;
  const std::string decoded = escaped ? decode_percent(data) : std::string();
  const std::string_view text = escaped ? std::string_view(decoded) : data;
  if (!base::lower_case(uri.substr(0, comma)).ends_with(";base64")) {
    return std::vector<std::uint8_t>(text.begin(), text.end());
  }
  auto bytes = decode_base64(text);
  if (!bytes) return base::Error{"a data: URI with a character that is not base64", "", k_copy_again};
  return std::move(*bytes);
}

std::optional<std::string> path_of_uri(std::string_view uri) { return path_of(decode_percent(uri)); }
std::optional<std::string> path_as_written(std::string_view uri) { return path_of(std::string(uri)); }

}  // namespace penpose::io
