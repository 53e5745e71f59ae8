#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/sample/pen_decoder.h"
#include "firmware_io/decode/table/tablet_table.h"

namespace penpose::decode {

/// A decoder, and the reason for its choice.
struct Recognition {
  std::unique_ptr<PenDecoder> decoder;
  /// "descriptor", "wacom FAMILY NAME", "protocol NAME", "descriptor, protocol NAME" or "event device"
  std::string method;
  bool is_pad = false;  ///< the interface has keys of a tablet but no pen
  /// Where nothing tells which tablet it is of several with the same ids: what samples of its table's protocol are read
  /// as. Empty otherwise.
  std::string guess = {};
};

/// Chooses the decoder of an interface, in this order: for a Linux input device the descriptor that stands for it
/// (hid/event_mark.h), whatever its ids; a Wacom format by product id; the pens that the descriptor
/// describes and, for every report that fits none of them, the protocol that the table of tablets names for the device.
///
/// `own` (may be null): the user's tablets, which take precedence, or a chosen one (chosen_tablet.h). Errors: no
/// decoder is known for this interface (a mouse, a touch screen), with the descriptor's own error if it is illegal.
[[nodiscard]] base::Result<Recognition> make_decoder(const DeviceIdentity& device, const TabletTable* own = nullptr);

/// Sets the report lengths that the descriptor implies where they are not known yet.
void complete_identity(DeviceIdentity& device);

}  // namespace penpose::decode
