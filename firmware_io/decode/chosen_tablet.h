#pragma once

#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/table/tablet_table.h"

namespace penpose::decode {

/// The device itself, or where it has no ids and `own` (may be null) is a tablet that was chosen by its name, the
/// device with the ids of that tablet: of those of its pen, then of those of its keys and fingers, the first that
/// nothing known of the device contradicts, and before others one of a Wacom model that is known. Recordings of other
/// programs name no ids.
[[nodiscard]] DeviceIdentity identified(const DeviceIdentity& device, const TabletTable* own);

}  // namespace penpose::decode
