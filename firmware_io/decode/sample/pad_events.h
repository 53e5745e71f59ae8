#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "firmware_io/decode/sample/pad_sample.h"

namespace penpose::decode {

/// A dial of a tablet.
enum class PadDial : std::uint8_t {
  ring,   ///< a finger moves around it
  strip,  ///< a finger moves along it
  wheel,  ///< turns itself
};

enum class PadEventKind : std::uint8_t {
  key_down,  ///< `key`
  key_up,
  touched,  ///< a finger came to a ring or strip
  turned,   ///< a dial moved by `steps`
  let_go,   ///< the finger left
};

struct PadEvent {
  PadEventKind kind = PadEventKind::key_down;
  PadKey key = PadKey::button0;
  PadDial dial = PadDial::ring;
  std::uint8_t side = 0;   ///< which of two
  std::int8_t mode = 0;    ///< the light that is on there, from 0
  std::int32_t steps = 0;  ///< 120ths of a notch; clockwise, downwards and towards oneself are positive
  std::int64_t time_us = 0;

  friend bool operator==(const PadEvent&, const PadEvent&) = default;
};

/// Parts of a notch, as Linux counts them for wheels of high resolution.
inline constexpr std::int32_t k_notch = 120;
/// A ring's notches: one for each 10 degrees, about one intended step of a finger. A ring with fewer positions has one
/// for each.
inline constexpr std::int32_t k_ring_notches = 36;

/// Turns the states of a pad into events: a press and a release for each key, and turns with their distance.
class PadEvents {
 public:
  explicit PadEvents(const PadFeatures& features = {}) : features_(features) {}

  /// Appends the events of a state, keys first. `out` grows by at most a few dozen.
  void add(const PadSample& sample, std::int64_t time_us, std::vector<PadEvent>& out);
  /// Releases everything that is held when there are no more states.
  void finish(std::int64_t time_us, std::vector<PadEvent>& out);

  [[nodiscard]] const PadKeys& held() const { return last_.keys; }

 private:
  struct Touch {
    bool on = false;
    std::int32_t at = 0;
  };

  void add_keys(const PadSample& sample, std::int64_t time_us, std::vector<PadEvent>& out) const;
  void add_touch(PadEvent event, bool was, Touch now, std::int32_t by, std::vector<PadEvent>& out) const;
  void add_wheel(PadEvent event, const PadSample& sample, std::vector<PadEvent>& out) const;
  [[nodiscard]] std::int32_t ring_steps(std::int32_t from, std::int32_t to) const;
  [[nodiscard]] std::int32_t strip_steps(std::int32_t from, std::int32_t to) const;

  PadFeatures features_;
  PadSample last_;
};

}  // namespace penpose::decode
