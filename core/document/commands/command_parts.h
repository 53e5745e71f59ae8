#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "core/base/members.h"
#include "core/base/result.h"

// What a command is made of (command.h).

namespace penpose::document {

struct ApplyParts;
struct Document;

/// The document that a command makes. Errors: what is wrong with the command; the place is a member of it or empty.
using Changed = base::Result<Document>;

/// What a command is called.
struct Called {
  std::string_view name;   ///< in files
  std::string_view words;  ///< in the list of what was done
};

/// A text that types can be made of.
template <std::size_t size>
struct Text {
  char letters[size]{};
  consteval Text(const char (&text)[size]) { std::copy_n(text, size, letters); }  // NOLINT(google-explicit-constructor)
  [[nodiscard]] constexpr std::string_view view() const { return {letters, size - 1}; }
};

/// A command that has no other members than these.
template <typename Members, Text name, Text words>
struct Plain : Members {
  static constexpr Called k_called{name.view(), words.view()};
};

/// Commands are the same where all their members are.
template <typename One>
requires requires { One::k_called; }
[[nodiscard]] bool operator==(const One& a, const One& b) { return One::members(a) == One::members(b); }

}  // namespace penpose::document
