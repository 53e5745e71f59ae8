#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "firmware_io/event/event_device.h"

namespace penpose::event {

/// Reads the lines of a recording of evemu-record (evemu(1), formats 1.0 to 1.3), without its line ends.
class EvemuLines {
 public:
  enum class Kind : std::uint8_t {
    other,   ///< comments, and what evemu adds in the future
    facts,   ///< of the device, put into `axes`
    event,   ///< `event` at `time_us`
    broken,  ///< begins like one of those and is none
  };

  /// Whether a line is the first of such a recording.
  [[nodiscard]] static bool marks(std::string_view line);

  Kind read(std::string_view line);

  /// What the lines read so far say of the device. Where it is plugged in they do not say.
  [[nodiscard]] const EventAxes& axes() const { return axes_; }
  [[nodiscard]] const Event& event() const { return event_; }
  [[nodiscard]] std::int64_t time_us() const { return time_us_; }

 private:
  bool read_ids(std::string_view words);
  bool read_bits(std::string_view words, bool properties);
  bool read_range(std::string_view words);
  bool read_event(std::string_view words);

  EventAxes axes_;
  Event event_;
  std::int64_t time_us_ = 0;
  std::uint16_t bits_type_ = 0;  ///< of the last line of bits
  std::uint32_t next_bit_ = 0;   ///< whose next line begins with this one
  std::uint32_t next_property_ = 0;
};

}  // namespace penpose::event
