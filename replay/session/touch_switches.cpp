#include "replay/session/touch_switches.h"

#include <algorithm>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/decode/hand_factory.h"

namespace penpose::replay {
namespace {

/// Where the hub is into which a unit is plugged, "usb-0000:00:14.0-2" of "usb-0000:00:14.0-2.1"; empty where none is
/// named.
std::string hub_of(const std::string& unit) {
  const std::size_t point = unit.rfind('.');
  if (point == std::string::npos || point + 1 == unit.size()) return {};
  const bool is_port = std::all_of(unit.begin() + static_cast<std::ptrdiff_t>(point) + 1, unit.end(),
                                   [](char c) { return c >= '0' && c <= '9'; });
  return is_port ? unit.substr(0, point) : std::string();
}

}  // namespace

/// Whether one of the two feels fingers and nothing else, and the other has no fingers.
bool TouchSwitches::complements(const Group& group, const decode::DeviceIdentity& identity) const {
  const auto has_pen = [&](const decode::DeviceIdentity& one) { return decode::make_decoder(one, own_).ok(); };
  const auto has_touch = [&](const decode::DeviceIdentity& one) {
    return decode::make_hand_decoders(one, own_).touch != nullptr;
  };
  const bool group_pen = std::any_of(group.parts.begin(), group.parts.end(), has_pen);
  const bool group_touch = std::any_of(group.parts.begin(), group.parts.end(), has_touch);
  const bool touch = has_touch(identity);
  if (touch) return !has_pen(identity) && group_pen && !group_touch;
  return group_touch && !group_pen;
}

bool TouchSwitches::belongs(const Group& group, const decode::DeviceIdentity& identity) const {
  const decode::DeviceIdentity& first = group.parts.front();
  if (first.vendor != identity.vendor) return false;
  const auto same_unit = [&](const decode::DeviceIdentity& one) { return one.unit == identity.unit; };
  if (std::any_of(group.parts.begin(), group.parts.end(), same_unit)) return true;
  const std::string hub = hub_of(identity.unit);
  return !hub.empty() && hub == hub_of(first.unit) && first.product != identity.product && complements(group, identity);
}

std::shared_ptr<decode::TouchSwitch> TouchSwitches::join(int device, const decode::DeviceIdentity& identity) {
  leave(device);
  auto found = std::find_if(groups_.begin(), groups_.end(), [&](const Group& one) { return belongs(one, identity); });
  if (found == groups_.end()) {
    groups_.push_back({{}, {}, std::make_shared<decode::TouchSwitch>()});
    found = groups_.end() - 1;
  }
  found->parts.push_back(identity);
  found->devices.insert(device);
  return found->gate;
}

void TouchSwitches::leave(int device) {
  for (Group& group : groups_) group.devices.erase(device);
  std::erase_if(groups_, [](const Group& group) { return group.devices.empty(); });
}

}  // namespace penpose::replay
