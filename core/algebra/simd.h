#pragma once

#include <cstdint>
#include <cstring>

namespace penpose::algebra {

// Four numbers side by side, by the vector extension that GCC and Clang share. Each lane is an ordinary IEEE operation,
// so that the results are those of a plain loop, bit for bit, on every machine.
using Float4 = float __attribute__((vector_size(16)));
using Double4 = double __attribute__((vector_size(32)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

inline Float4 splat(float value) { return Float4{value, value, value, value}; }
inline Double4 splat(double value) { return Double4{value, value, value, value}; }
inline Float4 lower(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 upper(Float4 a, Float4 b) { return a > b ? a : b; }
inline Double4 lower(Double4 a, Double4 b) { return a < b ? a : b; }
inline Double4 upper(Double4 a, Double4 b) { return a > b ? a : b; }
/// Four doubles at any address.
inline Double4 load(const double* p) {
  Double4 value;
  std::memcpy(&value, p, sizeof value);
  return value;
}
inline void store(double* p, Double4 value) { std::memcpy(p, &value, sizeof value); }
inline double sum_of(Double4 lanes) { return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]); }
inline Double4 widen(Float4 a) { return __builtin_convertvector(a, Double4); }

}  // namespace penpose::algebra
