#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "firmware_io/decode/described/described_control.h"
#include "firmware_io/decode/sample/touch_decoder.h"

namespace penpose::decode {

enum class FingerRole : std::uint8_t { x, y, id, tip, confidence, valid, other };

/// One control of a report of fingers.
struct FingerControl {
  FingerRole role = FingerRole::other;
  bool ends_finger = false;  ///< the last control of a finger
  bool ends_group = false;   ///< the last of its collection
  DescribedControl place;
};

/// A report of fingers.
struct FingerReport {
  std::uint8_t id = 0;
  std::uint32_t length = 0;
  std::int32_t fingers = 0;               ///< the most fingers in it
  std::optional<DescribedControl> count;  ///< the number of fingers of the frame, 0 in its further reports
  std::vector<FingerControl> controls;    ///< in order of the descriptor
};

struct FingerLayout {
  bool has_report_ids = false;
  std::vector<FingerReport> reports;
  TouchAxes axes;
};

/// The fingers that a Wacom interface describes; nothing when it describes none.
[[nodiscard]] std::optional<FingerLayout> find_wacom_fingers(const hid::ReportDescriptor& descriptor);

/// Fingers on Wacom's tablets and screens that describe their reports. Differs from the standard reading: a frame ends
/// after as many fingers as its first report announced, a finger that was never down takes no slot, and nothing is
/// reported while the tablet's own switch is off.
class WacomGenericTouchDecoder final : public TouchDecoder {
 public:
  WacomGenericTouchDecoder(FingerLayout layout, std::shared_ptr<TouchSwitch> gate);

  bool decode(base::Bytes report) override;
  void reset() override;

 private:
  [[nodiscard]] bool muted() const { return gate_ != nullptr && gate_->mutes(); }
  void begin(const FingerReport& layout, base::Bytes report);
  void apply(const FingerControl& control, std::int64_t value);
  void end_finger();
  bool end_group();

  FingerLayout layout_;
  std::shared_ptr<TouchSwitch> gate_;
  ReportedFinger finger_;
  std::int32_t expected_ = 0;
  std::int32_t received_ = 0;
  bool invalid_ = false;
  bool down_ = false;  ///< a finger was down when the last frame ended
};

}  // namespace penpose::decode
