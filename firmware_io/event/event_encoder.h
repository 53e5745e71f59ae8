#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/base/hidden.h"
#include "firmware_io/event/event_device.h"

namespace penpose::event {

struct EventLayout;

/// Turns the events of one device into reports under the descriptor that `report_descriptor` gives it: the state of
/// pen, keys or fingers at the end of each frame, as the next SYN_REPORT closes it. Events of controls that the device
/// did not announce are ignored.
class EventEncoder {
 public:
  using Reports = std::vector<std::vector<std::uint8_t>>;

  explicit EventEncoder(const EventAxes& axes);

  /// A value that a control has already; gives no report.
  void begin_with(const Event& event);
  /// Takes an event. After SYN_DROPPED all is ignored up to the next SYN_REPORT, as input devices ask of their readers.
  /// At a frame's end it gives the reports of what the frame was about, mostly one; else nothing. Valid until the next
  /// call.
  [[nodiscard]] std::span<const std::vector<std::uint8_t>> take(const Event& event);

 private:
  struct Finger {
    bool on = false;
    bool palm = false;
    bool was_on = false;    ///< in the last report
    bool replaced = false;  ///< another finger took its slot within this frame
    std::int32_t x = 0;
    std::int32_t y = 0;
  };
  struct Value {
    std::int32_t now = 0;
    bool of_pen = false;
    bool of_pad = false;
  };
  enum class Kind : std::uint8_t { none, pen, puck };

  bool store(const Event& event);
  bool store_finger(const Event& event);
  void end_frame();
  void encode_pen();
  void encode_pad();
  void encode_fingers();
  void begin_report(std::uint8_t id, std::size_t length);
  [[nodiscard]] Kind tool_in_range() const;
  [[nodiscard]] std::int32_t value_of(std::uint16_t type, std::uint16_t code) const;
  [[nodiscard]] bool is_on_ring() const;

  base::Hidden<const EventLayout> layout_;
  std::map<std::uint32_t, Value> values_;  ///< by type and code
  std::vector<Finger> fingers_;
  std::size_t slot_ = 0;
  Kind last_tool_ = Kind::none;
  bool pen_changed_ = false;
  bool pad_changed_ = false;
  bool fingers_changed_ = false;
  bool dropped_ = false;
  Reports reports_;
};

}  // namespace penpose::event
