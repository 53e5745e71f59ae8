#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::decode {

/// A test of report bytes, written as blank-separated parts that must all hold:
///   `1.5` bit 5 of byte 1 is set (bit 0 is the lowest)    `!1.5` it is clear
///   `0=02` byte 0 is 02h    `0=02/10` it is 02h or 10h    `0!=02` it is not 02h
///   `1&fc=c0` byte 1 masked with FCh is C0h               `length>=12` the report has at least 12 bytes
/// Bytes and bits count in decimal, values are hexadecimal. A test of a byte beyond the end of the report fails.
/// Without parts: true.
class BitTest {
 public:
  [[nodiscard]] static base::Result<BitTest> parse(std::string_view text);

  [[nodiscard]] bool holds(base::Bytes report) const {
    if (report.size() < shortest_) return false;
    // Every part lies before `shortest_`.
    const std::uint8_t* const bytes = report.data();
    for (const auto& part : parts_) {
      if (!part.holds(bytes[part.byte])) return false;
    }
    return true;
  }
  /// Bytes that a report needs so that every part can be evaluated.
  [[nodiscard]] std::size_t reach() const { return shortest_; }
  /// The largest `length>=` part, 0 without one.
  [[nodiscard]] std::size_t stated_length() const { return stated_length_; }

 private:
  struct Part {
    std::uint16_t byte = 0;
    std::uint8_t mask = 0xff;
    bool wanted = true;
    std::uint32_t values = 0;  ///< four of a byte each, the last one repeated

    [[nodiscard]] bool holds(std::uint8_t raw) const {
      // All four at once: whether a byte of the difference is 0.
      const std::uint32_t difference = (static_cast<std::uint32_t>(raw & mask) * 0x01010101U) ^ values;
      const bool found = ((difference - 0x01010101U) & ~difference & 0x80808080U) != 0;
      return found == wanted;
    }
  };
  [[nodiscard]] static base::Result<Part> parse_part(std::string_view text);

  std::vector<Part> parts_;
  std::size_t shortest_ = 0;
  std::size_t stated_length_ = 0;
};

/// A number in a report, written as the runs of bits that make it up, lowest first and separated by blanks:
///   `2 3` bytes 2 and 3, little-endian    `9.1 3 2` bit 1 of byte 9, above it byte 3, above that byte 2
///   `7.4-7` bits 4 to 7 of byte 7         `!7.6` bit 6 of byte 7 inverted      `_4` four zero bits
///   `3=01/02` one bit that tells whether the test holds (any part of a BitTest with `=`)
///   `... | ...` two such lists OR-ed
/// followed by any of, in this order: `signed` (two's complement of the width), `negated`, `plus N` or `minus N`, and
/// `if TEST` (the number is absent unless the BitTest holds).
class BitNumber {
 public:
  [[nodiscard]] static base::Result<BitNumber> parse(std::string_view text);

  /// Precondition: the report has at least reach() bytes and is_there() says yes.
  [[nodiscard]] std::int64_t read(base::Bytes report) const {
    // Nearly all numbers have one run, or two consecutive bytes.
    std::uint64_t bits = 0;
    if (shape_ != Shape::any) {
      const std::uint8_t* const at = report.data() + first_.byte;
      bits = first_.of(*at);
      if (shape_ == Shape::two_bytes) bits |= std::uint64_t{at[1]} << 8;
    } else {
      for (const auto& run : runs_) bits |= run.of(report[run.byte]);
      for (const auto& flag : flags_) bits |= std::uint64_t{flag.test.holds(report)} << flag.up;
    }
    std::int64_t value = static_cast<std::int64_t>(bits);
    if (sign_bit_ != 0 && (bits & sign_bit_) != 0) value -= static_cast<std::int64_t>(sign_bit_ << 1);
    return (negated_ ? -value : value) + offset_;
  }
  /// Whether the `if` part, where there is one, holds.
  [[nodiscard]] bool is_there(base::Bytes report) const { return !gated_ || gate_.holds(report); }
  /// As read, or `otherwise` where the number is absent.
  [[nodiscard]] std::int64_t read_or(base::Bytes report, std::int64_t otherwise) const {
    return is_there(report) ? read(report) : otherwise;
  }
  /// Bytes that a report needs before read_or() may be called; 0 if an `if length>=N` checks that itself.
  [[nodiscard]] std::size_t reach() const { return reach_; }
  /// Bits that the runs fill, at most 32.
  [[nodiscard]] int width() const { return width_; }

 private:
  struct Run {
    std::uint16_t byte = 0;
    std::uint8_t mask = 0, flip = 0, down = 0, up = 0;

    [[nodiscard]] std::uint64_t of(std::uint8_t raw) const {
      return (std::uint64_t{static_cast<std::uint8_t>((raw ^ flip) & mask)} >> down) << up;
    }
  };
  struct Flag {
    BitTest test;
    std::uint8_t up = 0;
  };
  enum class Shape : std::uint8_t { one_run, two_bytes, any };
  base::Status add_run(std::string_view word, int& position);
  void find_shape();

  Run first_;  ///< where `shape_` is not any
  Shape shape_ = Shape::any;
  std::vector<Run> runs_;
  std::vector<Flag> flags_;
  BitTest gate_;
  std::uint64_t sign_bit_ = 0;
  std::int64_t offset_ = 0;
  std::size_t reach_ = 0;
  int width_ = 0;
  bool negated_ = false;
  bool gated_ = false;
};

}  // namespace penpose::decode
