#pragma once

#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace penpose::base {

/// Why an operation failed, for a person: what is wrong, where in the input (line, byte offset or JSON pointer; may be
/// empty) and what the user can do about it (may be empty). Bytes carry no name, so the file is added by whoever opened
/// it.
struct Error {
  std::string what;
  std::string place;
  std::string remedy;

  /// One line: "FILE: PLACE: WHAT; REMEDY". Empty pieces are left out.
  [[nodiscard]] std::string line(std::string_view file = {}) const;
};

/// A value or the error that stood in its way. Not a std::variant: there is one for each type of value, and they take
/// longer to compile than what they are used in.
template <typename T>
class [[nodiscard]] Result {
 public:
  using Value = T;

  Result(T value) : value_(std::move(value)) {}  // NOLINT(google-explicit-constructor): `return value;` is the point
  Result(Error error) : error_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] bool ok() const { return value_.has_value(); }
  explicit operator bool() const { return ok(); }

  /// The value. Precondition: ok(); a violated precondition ends the program rather than reading garbage.
  [[nodiscard]] T& value() & {
    require(ok());
    return *value_;
  }
  [[nodiscard]] const T& value() const& {
    require(ok());
    return *value_;
  }
  [[nodiscard]] T&& value() && {
    require(ok());
    return std::move(*value_);
  }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  /// The error. Precondition: !ok().
  [[nodiscard]] const Error& error() const {
    require(!ok());
    return error_;
  }

 private:
  static void require(bool condition) {
    if (!condition) std::abort();
  }

  std::optional<T> value_;
  Error error_;
};

/// The result of an operation that gives nothing back but may fail.
struct Done {};
using Status = Result<Done>;

}  // namespace penpose::base
