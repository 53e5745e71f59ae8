#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "firmware_io/decode/sample/device_identity.h"
#include "replay/session/hand_input.h"

namespace penpose::app {

/// The tablets of this run of the app, by the numbers of their interfaces. A new document hears of them again.
struct KnownTablets {
  std::map<int, decode::DeviceIdentity> seen;                ///< that were ever there
  std::set<int> plugged;                                     ///< those of them that are
  std::map<int, std::vector<std::uint8_t>> receiver_status;  ///< what receivers said last
  std::map<int, decode::Lights> lights;                      ///< that are on beside the dials
};

}  // namespace penpose::app
