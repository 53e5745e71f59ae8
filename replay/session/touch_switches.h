#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "firmware_io/decode/sample/touch_decoder.h"
#include "firmware_io/decode/table/tablet_table.h"

namespace penpose::replay {

/// Which devices share the switch that turns their fingers off: the interfaces of one tablet, and a display's pen and
/// fingers where they are USB devices of their own behind the hub that is in it. Two tablets of one model share none,
/// and one that comes again begins anew. As Linux has it (wacom_sys.c, wacom_are_sibling), but that a display without
/// both parts is needed for the latter.
class TouchSwitches {
 public:
  explicit TouchSwitches(const decode::TabletTable* own = nullptr) : own_(own) {}

  /// The switch of a device that came.
  [[nodiscard]] std::shared_ptr<decode::TouchSwitch> join(int device, const decode::DeviceIdentity& identity);
  void leave(int device);

 private:
  struct Group {
    std::vector<decode::DeviceIdentity> parts;
    std::set<int> devices;
    std::shared_ptr<decode::TouchSwitch> gate;
  };
  [[nodiscard]] bool belongs(const Group& group, const decode::DeviceIdentity& identity) const;
  [[nodiscard]] bool complements(const Group& group, const decode::DeviceIdentity& identity) const;

  const decode::TabletTable* own_;
  std::vector<Group> groups_;
};

}  // namespace penpose::replay
