#pragma once

#include <memory>
#include <string_view>

#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/sample/pad_decoder.h"
#include "firmware_io/decode/sample/touch_decoder.h"
#include "firmware_io/decode/table/tablet_table.h"

namespace penpose::decode {

/// What reads the hand on one interface of a tablet: keys and wheels, fingers. Both may be null. They work beside the
/// interface's PenDecoder, and on interfaces that have no pen.
struct HandDecoders {
  std::unique_ptr<PadDecoder> pad;
  std::unique_ptr<TouchDecoder> touch;
};

/// Chooses how to read the hand, in the order in which make_decoder chooses how to read the pen: the user's tablets
/// (`own`, may be null), a Wacom format by product id, what the descriptor describes, and the table of tablets.
///
/// `touch_switch` (may be null) is the one of the tablet to which the interface belongs; all reports of its pad have to
/// be decoded for it to be right.
[[nodiscard]] HandDecoders make_hand_decoders(const DeviceIdentity& device, const TabletTable* own = nullptr,
                                              std::shared_ptr<TouchSwitch> touch_switch = nullptr);

/// What reads the hand in reports of the named protocol; both null when it is unknown or has neither.
[[nodiscard]] HandDecoders make_protocol_hand_decoders(std::string_view protocol);

}  // namespace penpose::decode
