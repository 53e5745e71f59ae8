#include "core/base/large_angle.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

namespace penpose::base {
namespace {

// The binary digits of 2/pi after the point, 32 a word: enough for the largest double.
constexpr std::array<std::uint32_t, 38> k_two_over_pi_words = {
    0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab, 0xdebbc561,
    0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484,
    0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff, 0xde05980f,
    0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7, 0xebe5f17b,
    0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab};

// pi/2 as the sum of two doubles.
constexpr double k_half_pi_high = 0x1.921fb54442d18p0;
constexpr double k_half_pi_low = 0x1.1a62633145c07p-54;

constexpr int k_limbs = 9;
constexpr int k_digit_words = 7;

/// An unsigned number of 288 bits, its lowest word first.
using Wide = std::array<std::uint32_t, k_limbs>;

/// The word that begins at digit `first` of 2/pi, counted from 1.
std::uint32_t digits_at(int first) {
  const auto index = static_cast<std::size_t>(first - 1);
  const std::size_t word = index / 32;
  const std::size_t shift = index % 32;
  const auto at = [](std::size_t i) {
    return std::uint64_t{i < k_two_over_pi_words.size() ? k_two_over_pi_words[i] : 0};
  };
  return static_cast<std::uint32_t>(((at(word) << 32 | at(word + 1)) << shift) >> 32);
}

/// `digits` of 2/pi from the digit `first` on, times a number of 53 bits.
Wide product(int first, std::uint64_t mantissa) {
  Wide result{};
  const std::uint64_t factors[] = {mantissa & 0xffffffffU, mantissa >> 32};
  for (int f = 0; f < 2; ++f) {
    std::uint64_t carry = 0;
    for (int i = 0; i < k_digit_words; ++i) {
      const auto at = static_cast<std::size_t>(i + f);
      const std::uint64_t sum = factors[f] * digits_at(first + 32 * (k_digit_words - 1 - i)) + result[at] + carry;
      result[at] = static_cast<std::uint32_t>(sum);
      carry = sum >> 32;
    }
    result[static_cast<std::size_t>(k_digit_words + f)] = static_cast<std::uint32_t>(carry);
  }
  return result;
}

bool bit(const Wide& number, int i) { return ((number[static_cast<std::size_t>(i / 32)] >> (i % 32)) & 1U) != 0; }

/// The 53 bits below bit `top`, as a double of the scale 2^-places. Bits below the number are zero.
double piece(const Wide& number, int top, int places) {
  std::uint64_t bits = 0;
  for (int i = top - 1; i >= top - 53; --i) bits = bits << 1 | (i >= 0 && bit(number, i) ? 1U : 0U);
  // 2^(top - 53 - places) is a normal number: places is below 300.
  const double scale = std::bit_cast<double>(static_cast<std::uint64_t>(top - 53 - places + 1023) << 52);
  return static_cast<double>(bits) * scale;
}

struct Pair {
  double high;
  double low;
};

/// a * b without an error (Dekker 1971).
Pair exact_product(double a, double b) {
  constexpr double k_splitter = 134217729.0;  // 2^27 + 1
  const auto split = [](double x) {
    const double scaled = x * k_splitter;
    const double high = scaled - (scaled - x);
    return Pair{high, x - high};
  };
  const Pair x = split(a);
  const Pair y = split(b);
  const double high = a * b;
  return {high, ((x.high * y.high - high) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

}  // namespace

ReducedAngle reduce_large_angle(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int exponent = static_cast<int>((bits >> 52) & 0x7ffU) - 1075;
  const std::uint64_t mantissa = (bits & 0xfffffffffffffU) | 0x10000000000000U;
  // Digits that make multiples of 4 say nothing about the quadrant or what is left.
  const int first = std::max(1, exponent - 1);
  const int places = first + 32 * k_digit_words - 1 - exponent;  // of the product after its point
  Wide number = product(first, mantissa);
  std::int64_t quadrant = (bit(number, places) ? 1 : 0) + (bit(number, places + 1) ? 2 : 0);
  const bool upper = bit(number, places - 1);
  if (upper) {
    // Nearer to the next quadrant: what is left is below zero.
    ++quadrant;
    for (std::uint32_t& word : number) word = ~word;
  }
  int top = places;
  while (top > 53 && !bit(number, top - 1)) --top;
  const double part = piece(number, top, places);
  const double rest = piece(number, top - 53, places);
  const Pair whole = exact_product(part, k_half_pi_high);
  const double small = whole.low + (part * k_half_pi_low + rest * k_half_pi_high);
  const double high = whole.high + small;
  ReducedAngle reduced{high, (whole.high - high) + small, quadrant};
  if (upper != (x < 0)) {
    reduced.high = -reduced.high;
    reduced.low = -reduced.low;
  }
  if ((x < 0)) reduced.quadrant = -quadrant;
  return reduced;
}

}  // namespace penpose::base
