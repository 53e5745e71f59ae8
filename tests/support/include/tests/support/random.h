#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <random>
#include <vector>

namespace penpose::tests {

/// Uniform numbers from a seed, the same with every standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(generator_() >> 11) * 0x1p-53;
  }
  /// 0..count - 1.
  std::size_t index(std::size_t count) { return static_cast<std::size_t>(generator_() % count); }
  glm::dvec3 vector(double size = 1) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }

 private:
  std::mt19937_64 generator_;
};

/// So many numbers from -2 to 2.
inline std::vector<double> random_numbers(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back(random(-2, 2));
  return all;
}

}  // namespace penpose::tests
