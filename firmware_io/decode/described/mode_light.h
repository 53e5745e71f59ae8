#pragma once

#include <cstdint>

namespace penpose::decode {

/// The lights at a ring or strip; the one that is on shows the ring's current mode. Tablets do not report it. It
/// follows from the presses of the mode key: each moves on to the next light, starting from the first.
class ModeLight {
 public:
  /// The light after a report in which the mode key is `down`.
  std::int8_t press(bool down, unsigned lights) {
    if (down && !held_ && lights > 0) light_ = static_cast<std::int8_t>((static_cast<unsigned>(light_) + 1) % lights);
    held_ = down;
    return light_;
  }
  /// Where each light has a key of its own: bit i of `down` turns on light i.
  std::int8_t choose(unsigned down, unsigned lights) {
    for (unsigned i = 0; i < lights; ++i) {
      if ((down >> i & 1) == 0) continue;
      light_ = static_cast<std::int8_t>(i);
      break;
    }
    return light_;
  }
  [[nodiscard]] std::int8_t now() const { return light_; }
  void set(std::int8_t light, unsigned lights) {
    if (light >= 0 && static_cast<unsigned>(light) < lights) light_ = light;
  }
  void reset() { *this = {}; }

 private:
  std::int8_t light_ = 0;
  bool held_ = false;
};

}  // namespace penpose::decode
