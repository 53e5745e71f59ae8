#pragma once

#include <cstdint>
#include <vector>

#include "firmware_io/decode/sample/pen_sample.h"

namespace penpose::decode {

enum class PenEventKind : std::uint8_t {
  near,         ///< a tool came into range
  away,         ///< it left
  button_down,  ///< `button` of the tool
  button_up,
  hover,         ///< a position without contact
  stroke_begin,  ///< contact, with the stroke's first point
  stroke_point,
  stroke_end,  ///< contact ended; has no point of its own
};

struct PenEvent {
  PenEventKind kind = PenEventKind::hover;
  Tool tool = Tool::none;
  std::uint8_t button = 0;
  std::int64_t time_us = 0;
  PenSample sample;  ///< raw, from the decoder
};

/// When the tip counts as touching.
struct ContactRule {
  bool by_pressure = false;        ///< otherwise the device's own switch
  std::int32_t press_at = 1;       ///< contact begins at this pressure, in device units
  std::int32_t release_below = 1;  ///< and ends below this one; lower than `press_at`, so that noise makes no strokes
};

/// Turns a pen's samples into events. Every sample in range gives exactly one position event (hover, begin or point),
/// in order and unchanged; buttons and proximity are events of their own. Leaving range and changing the tool end a
/// stroke.
class PenEvents {
 public:
  explicit PenEvents(ContactRule rule = {}) : rule_(rule) {}

  /// Appends the events of a sample. `out` grows by at most a few dozen.
  void add(const PenSample& sample, std::int64_t time_us, std::vector<PenEvent>& out);
  /// Ends an open stroke and releases buttons when there are no more samples.
  void finish(std::int64_t time_us, std::vector<PenEvent>& out);

 private:
  [[nodiscard]] bool touches(const PenSample& sample) const;
  void leave(const PenSample& sample, std::int64_t time_us, std::vector<PenEvent>& out);
  void set_buttons(const PenSample& sample, std::uint32_t buttons, std::int64_t time_us, std::vector<PenEvent>& out);

  ContactRule rule_;
  Tool tool_ = Tool::none;
  std::uint64_t serial_ = 0;
  std::uint32_t buttons_ = 0;
  bool in_stroke_ = false;
  PenSample last_;
};

}  // namespace penpose::decode
