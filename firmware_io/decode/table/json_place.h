#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/json/json.h"
#include "core/base/result.h"

namespace penpose::decode {

/// Parses at most 16 MiB of UTF-8 (a byte order mark is taken), nested at most 32 deep. The error names the byte
/// offset.
[[nodiscard]] base::Result<json::Json> parse_json(std::string_view text);

/// A place in a document that knows its JSON pointer. Reads never fail immediately: the first error is kept in
/// the error that all places of a document share, and the reader checks it once, at the end.
class JsonPlace {
 public:
  /// `error` must outlive every place made from this one; it does not change without an error.
  JsonPlace(const json::Json& value, base::Error& error) : value_(&value), error_(&error) {}

  [[nodiscard]] const std::string& pointer() const { return pointer_; }
  /// False for a missing member and for null.
  [[nodiscard]] bool present() const { return !value_->is_null(); }
  [[nodiscard]] bool is_text() const { return value_->is_string(); }
  [[nodiscard]] bool is_array() const { return value_->is_array(); }

  /// The member of that name; a missing place when there is none.
  [[nodiscard]] JsonPlace at(std::string_view name) const;
  /// The items of an array; none for an absent place.
  [[nodiscard]] std::vector<JsonPlace> items() const;
  /// The members of an object in the order of the document; none for an absent place.
  [[nodiscard]] std::vector<std::pair<std::string, JsonPlace>> members() const;

  /// An absent place is an error here; check present() first if it may be absent.
  [[nodiscard]] std::string text(std::size_t longest = 256) const;
  [[nodiscard]] std::int64_t integer(std::int64_t least, std::int64_t most) const;
  [[nodiscard]] double number(double least, double most) const;
  [[nodiscard]] bool boolean() const;

  /// Every member that is not in the list is an error, so that a misspelt name is noticed.
  void allow_only(std::initializer_list<std::string_view> names) const;
  /// Keeps the first error of the document.
  void fail(std::string what, std::string remedy) const;

 private:
  JsonPlace(const json::Json& value, base::Error& error, std::string pointer)
      : value_(&value), error_(&error), pointer_(std::move(pointer)) {}

  void expect_object() const;

  const json::Json* value_;
  base::Error* error_;
  std::string pointer_;
};

}  // namespace penpose::decode
