#pragma once

#include <array>
#include <optional>
#include <vector>

#include "firmware_io/decode/described/described_control.h"
#include "firmware_io/decode/sample/touch_decoder.h"

namespace penpose::decode {

/// The controls with a finger's values; values persist while other reports arrive.
struct MultitouchFinger {
  std::optional<DescribedControl> id, x, y, tip, in_range, confidence;
  std::uint8_t report_id = 0;
};

/// The fingers of one application (a touch screen, a touch pad).
struct MultitouchApplication {
  hid::Usage usage = 0;
  std::vector<std::uint8_t> report_ids;
  std::vector<MultitouchFinger> fingers;  ///< in order of the descriptor
  std::optional<DescribedControl> count, scan_time;
  std::uint8_t count_report = 0;
  std::uint8_t scan_time_report = 0;
};

struct MultitouchLayout {
  bool has_report_ids = false;
  bool certified = false;  ///< certified for Windows 8: palms, hovering, one place for each finger
  std::array<std::uint32_t, 256> report_length{};  ///< 0 for reports without fingers
  std::vector<MultitouchApplication> applications;
  TouchAxes axes;
};

/// The fingers that an interface describes with the Digitizer page and numbers; nothing when it describes none.
[[nodiscard]] std::optional<MultitouchLayout> find_multitouch(const hid::ReportDescriptor& descriptor);

/// Fingers as the Digitizer page describes them (HID Usage Tables 1.3, 16.5), read as Linux does (hid-multitouch.c).
/// A frame may span several reports; the first has the number of fingers.
class MultitouchDecoder final : public TouchDecoder {
 public:
  explicit MultitouchDecoder(MultitouchLayout layout);

  bool decode(base::Bytes report) override;
  void reset() override;

 private:
  struct State {
    std::vector<ReportedFinger> fingers;
    std::int64_t count = 0;
    std::int64_t scan_time = 0;
    std::int64_t last_scan_time = 0;
    std::int64_t expected = 0;
    std::int64_t received = 0;
  };

  bool decode_application(const MultitouchApplication& layout, State& state);
  void read(const MultitouchApplication& layout, State& state, std::uint8_t id, base::Bytes report) const;
  /// False when the finger is not one of this frame.
  bool take(const MultitouchApplication& layout, const State& state, const ReportedFinger& finger);

  MultitouchLayout layout_;
  std::vector<State> states_;  ///< of the applications
  std::vector<bool> palms_;    ///< by slot: lifted as a palm, to be reported once more
};

}  // namespace penpose::decode
