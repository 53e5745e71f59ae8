#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/sample/pad_decoder.h"
#include "firmware_io/decode/sample/touch_decoder.h"
#include "firmware_io/decode/table/tablet_table.h"

namespace penpose::decode {

/// The hand decoders of one interface of a tablet: keys and wheels, and fingers. Both may be null. They work in
/// parallel with the interface's PenDecoder, and on interfaces without a pen.
struct HandDecoders {
  std::unique_ptr<PadDecoder> pad;
  std::unique_ptr<TouchDecoder> touch;
  std::string guess = {};  ///< as Recognition::guess, where one of them is the table's
};

/// Chooses the hand decoders in the same order as make_decoder chooses the pen's: the user's tablets
/// (`own`, may be null), a Wacom format by product id, what the descriptor describes, and the table of tablets.
///
/// `touch_switch` (may be null) is that of the interface's tablet; it is correct only if all reports of the tablet's
/// pad are decoded.
[[nodiscard]] HandDecoders make_hand_decoders(const DeviceIdentity& device, const TabletTable* own = nullptr,
                                              std::shared_ptr<TouchSwitch> touch_switch = nullptr);

/// The hand decoders for reports of the named protocol; both null if it is unknown or has neither.
[[nodiscard]] HandDecoders make_protocol_hand_decoders(std::string_view protocol);

}  // namespace penpose::decode
