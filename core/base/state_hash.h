#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/byte_reader.h"
#include "core/base/hidden.h"

namespace penpose::base {

/// A 128-bit hash, most significant half first.
struct Hash128 {
  std::uint64_t high = 0;
  std::uint64_t low = 0;
  friend bool operator==(const Hash128&, const Hash128&) = default;

  /// 32 lower-case hexadecimal digits.
  [[nodiscard]] std::string hex() const;
};

/// Hashes a canonical byte stream (XXH3, 128 bits). Every add writes the same bytes on every machine: integers and
/// doubles little-endian, text with its length in front, -0 as +0 and every NaN as one NaN.
class StateHash {
 public:
  StateHash();

  void add(std::uint64_t value);
  void add(double value);
  void add(std::string_view text);
  void add(std::span<const double> values);
  void add_bytes(Bytes bytes);

  [[nodiscard]] Hash128 digest() const;

 private:
  struct State;
  Hidden<State> state_;
};

/// The hash of 32 hexadecimal digits; nothing where the text is anything else.
[[nodiscard]] std::optional<Hash128> parse_hash(std::string_view text);

/// The hash of one run of bytes.
[[nodiscard]] Hash128 hash_bytes(Bytes bytes);

}  // namespace penpose::base
