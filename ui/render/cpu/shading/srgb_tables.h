#pragma once

#include <array>
#include <cstdint>

namespace penpose::render {

/// sRGB by tables, the same on every machine.
class SrgbTables {
 public:
  [[nodiscard]] static const SrgbTables& get();

  /// Linear light of a byte.
  [[nodiscard]] float linear(std::uint8_t byte) const { return linear_[byte]; }
  /// What is displayed, 0..1, by the square root of linear light, 0..1. Within 0.1 of a step of 8 bits.
  [[nodiscard]] float display_of_root(float root) const {
    return display_[static_cast<std::size_t>(root * (k_steps - 1) + 0.5F)];
  }

 private:
  SrgbTables();

  static constexpr int k_steps = 4096;
  std::array<float, 256> linear_{};
  std::array<float, k_steps> display_{};
};

}  // namespace penpose::render
