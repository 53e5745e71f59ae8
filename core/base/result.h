#pragma once

#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

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

/// A value or the error that stood in its way.
template <typename T>
class [[nodiscard]] Result {
 public:
  using Value = T;

  Result(T value) : state_(std::move(value)) {}  // NOLINT(google-explicit-constructor): `return value;` is the point
  Result(Error error) : state_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] bool ok() const { return std::holds_alternative<T>(state_); }
  explicit operator bool() const { return ok(); }

  /// The value. Precondition: ok(); a violated precondition ends the program rather than reading garbage.
  [[nodiscard]] T& value() & {
    require(ok());
    return *std::get_if<T>(&state_);
  }
  [[nodiscard]] const T& value() const& {
    require(ok());
    return *std::get_if<T>(&state_);
  }
  [[nodiscard]] T&& value() && {
    require(ok());
    return std::move(*std::get_if<T>(&state_));
  }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  /// The error. Precondition: !ok().
  [[nodiscard]] const Error& error() const {
    require(!ok());
    return *std::get_if<Error>(&state_);
  }

 private:
  static void require(bool condition) {
    if (!condition) std::abort();
  }

  std::variant<T, Error> state_;
};

/// The result of an operation that gives nothing back but may fail.
struct Done {};
using Status = Result<Done>;

}  // namespace penpose::base
