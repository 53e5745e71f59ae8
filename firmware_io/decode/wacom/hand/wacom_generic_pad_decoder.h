#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "firmware_io/decode/described/described_control.h"
#include "firmware_io/decode/described/mode_light.h"
#include "firmware_io/decode/sample/pad_decoder.h"
#include "firmware_io/decode/sample/touch_decoder.h"

namespace penpose::decode {

enum class PadRole : std::uint8_t {
  key,
  strip,
  ring,
  ring_status,
  turn,  ///< a ring that reports turns, not positions
  touch_on,
  mute_touch,
  battery,
  charging,
  motion,  ///< of the tablet itself: only a sign of life
};

/// One control of the pad.
struct PadControl {
  PadRole role = PadRole::key;
  std::uint8_t report_id = 0;
  bool in_block = false;     ///< in a block of function keys, the only sign of a hand
  bool is_hand = false;      ///< counts as a hand at the pad: state becomes visible while it is there
  bool is_mode_key = false;  ///< also advances the light
  PadKey key = PadKey::button0;
  std::uint8_t side = 0;
  std::int32_t shift = 0;  ///< of a ring: added to the reported value
  bool reversed = false;   ///< of a ring: counts the other way round
  DescribedControl place;
};

struct PadLayout {
  bool has_report_ids = false;
  std::vector<PadControl> controls;                                            ///< in order of the descriptor
  std::vector<std::uint32_t> report_length = std::vector<std::uint32_t>(256);  ///< by id; 0 for reports without a pad
  PadFeatures features;
};

/// The keys that a Wacom tablet describes with its vendor pages; nothing if it describes neither keys nor a battery.
[[nodiscard]] std::optional<PadLayout> find_wacom_pad(const hid::ReportDescriptor& descriptor, std::uint16_t product);

/// Keys, rings and strips of Wacom tablets that describe their reports: Intuos Pro (2017), MobileStudio, Cintiq Pro and
/// all later ones. Differs from a plain reading: rings start at the tablet's left and increase clockwise on every
/// model, and values outside of the logical range are ignored.
class WacomGenericPadDecoder final : public PadDecoder {
 public:
  /// `touch` (may be null) receives the state of the key or slide that turns touch off.
  WacomGenericPadDecoder(PadLayout layout, std::shared_ptr<TouchSwitch> touch);

  bool decode(base::Bytes report) override;
  void reset() override;
  void set_light(std::size_t side, std::int8_t light) override;

 private:
  void reset_switch();
  void apply(const PadControl& control, std::int64_t value);

  PadLayout layout_;
  std::shared_ptr<TouchSwitch> touch_;
  PadSample pending_;
  ModeLight light_;
  bool in_use_ = false;  ///< something was reported since the hand left
};

}  // namespace penpose::decode
