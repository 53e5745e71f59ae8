#include "ui/app/hands/hand_desk.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>

#include "firmware_io/decode/wacom/wacom_models.h"

namespace penpose::app {
namespace {

/// Tablets that go by another number over Bluetooth. Source: libwacom's data files, which list both for a model.
struct Wired {
  std::uint16_t bluetooth;
  std::uint16_t usb;
};
constexpr std::array k_wired{Wired{0x00bd, 0x00bc}, Wired{0x0360, 0x0357}, Wired{0x0361, 0x0358},
                             Wired{0x0377, 0x0376}, Wired{0x0379, 0x0378}, Wired{0x0393, 0x0392},
                             Wired{0x03c6, 0x03c5}, Wired{0x03c8, 0x03c7}, Wired{0x03dd, 0x03dc}};

/// A pen that turns farther between two reports was lifted and put down.
constexpr std::int32_t k_farthest_turn = 12 * decode::k_notch;
constexpr std::int32_t k_pen_wheel_notches = 24;

std::uint16_t wired_product(const decode::DeviceIdentity& identity) {
  if (identity.vendor != decode::k_vendor_wacom) return identity.product;
  for (const Wired& one : k_wired) {
    if (one.bluetooth == identity.product) return one.usb;
  }
  return identity.product;
}

std::string plain(std::string name) {
  for (char& c : name) {
    if (c == '|' || c == '=' || static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return name;
}

}  // namespace

std::string tablet_key(const decode::DeviceIdentity& identity, const decode::TabletTable* own) {
  char ids[16];
  std::snprintf(ids, sizeof ids, "%04x:%04x", identity.vendor, wired_product(identity));
  // Wacom's numbers are one for each model; others share theirs.
  if (identity.vendor == decode::k_vendor_wacom) return ids;
  const auto match = decode::find_tablet(identity, own);
  if (match && match->certain) return plain(match->tablet->vendor + " " + match->tablet->name);
  return plain(std::string(ids) + " " + identity.name);
}

void HandDesk::add(int device, const decode::DeviceIdentity& identity, const replay::HandInput& hands,
                   const decode::PenAxes* pen, const decode::TabletTable* own) {
  remove(device);
  const std::string key = tablet_key(identity, own);
  auto found = std::find_if(tablets_.begin(), tablets_.end(), [&](const DeskTablet& one) {
    return one.is({key, identity.unit});
  });
  if (found == tablets_.end()) {
    const auto twins =
        std::count_if(tablets_.begin(), tablets_.end(), [&](const DeskTablet& one) { return one.key == key; });
    tablets_.push_back({});
    found = tablets_.end() - 1;
    found->key = key;
    found->unit = identity.unit;
    found->name = identity.name + (twins > 0 ? " (" + std::to_string(twins + 1) + ")" : "");
  }
  found->devices.push_back(device);
  if (const auto* pad = hands.pad(device); pad != nullptr && pad->features().any()) {
    found->pad = device;
    found->features = pad->features();
  }
  if (pen == nullptr) return;
  found->has_pen = true;
  found->pen_wheel = found->pen_wheel || pen->wheel.present;
  found->pen_rotation = found->pen_rotation || pen->rotation.present;
}

void HandDesk::remove(int device) {
  std::erase_if(held_, [&](const HeldBinding& one) { return one.device == device; });
  forget_rest(device);
  pen_left(device);
  fingers_.erase(device);
  for (DeskTablet& tablet : tablets_) {
    std::erase(tablet.devices, device);
    if (tablet.pad != device) continue;
    tablet.pad = -1;
    tablet.features = {};
    tablet.battery = {};
  }
  std::erase_if(tablets_, [](const DeskTablet& tablet) { return tablet.devices.empty(); });
}

DeskTablet* HandDesk::find(int device) {
  for (DeskTablet& tablet : tablets_) {
    if (std::find(tablet.devices.begin(), tablet.devices.end(), device) != tablet.devices.end()) return &tablet;
  }
  return nullptr;
}

const DeskTablet* HandDesk::find(int device) const {
  for (const DeskTablet& tablet : tablets_) {
    if (std::find(tablet.devices.begin(), tablet.devices.end(), device) != tablet.devices.end()) return &tablet;
  }
  return nullptr;
}

std::optional<Binding> HandDesk::release(int device, const PadControl& control) {
  const auto found = std::find_if(held_.begin(), held_.end(), [&](const HeldBinding& one) {
    return one.device == device && one.control == control;
  });
  if (found == held_.end()) return std::nullopt;
  const Binding binding = found->binding;
  held_.erase(found);
  return binding;
}

const Binding* HandDesk::held(Binding::Kind kind) const {
  const auto found =
      std::find_if(held_.rbegin(), held_.rend(), [&](const HeldBinding& one) { return one.binding.kind == kind; });
  return found == held_.rend() ? nullptr : &found->binding;
}

bool HandDesk::is_held(int device, const PadControl& control) const {
  return std::any_of(held_.begin(), held_.end(),
                     [&](const HeldBinding& one) { return one.device == device && one.control == control; });
}

std::vector<HeldBinding> HandDesk::held_on(int device) const {
  std::vector<HeldBinding> all;
  std::copy_if(held_.begin(), held_.end(), std::back_inserter(all),
               [&](const HeldBinding& one) { return one.device == device; });
  return all;
}

int HandDesk::whole_steps(int device, const PadControl& control, std::int32_t by, std::int32_t per) {
  std::int32_t& rest = rests_[{device, name_of(control)}];
  // Turned back, it does not first have to make up for what was left.
  if ((rest > 0 && by < 0) || (rest < 0 && by > 0)) rest = 0;
  rest += by;
  const std::int32_t whole = rest / per;
  rest -= whole * per;
  return whole;
}

void HandDesk::forget_rest(int device) {
  std::erase_if(rests_, [&](const auto& one) { return one.first.first == device; });
}

std::int32_t HandDesk::pen_turned(int device, bool rotation, std::int32_t value, const decode::Axis& axis) {
  const std::int64_t range = std::int64_t{axis.maximum} - axis.minimum + 1;
  if (!axis.present || range < 2) return 0;
  const auto known = pen_at_.find({device, rotation});
  if (known == pen_at_.end()) {
    pen_at_[{device, rotation}] = value;
    return 0;
  }
  std::int64_t by = std::int64_t{value} - known->second;
  if (rotation && 2 * by > range) by -= range;
  if (rotation && 2 * by < -range) by += range;
  const std::int64_t notches = rotation ? decode::k_ring_notches : k_pen_wheel_notches;
  const std::int64_t steps = by * notches * decode::k_notch / range;
  // What is too little for a step stays for the next.
  if (steps == 0) return 0;
  known->second = value;
  return std::abs(steps) > k_farthest_turn ? 0 : static_cast<std::int32_t>(steps);
}

void HandDesk::pen_left(int device) {
  pen_at_.erase({device, false});
  pen_at_.erase({device, true});
}

std::vector<HandDesk::Finger> HandDesk::fingers_changed(int device, std::span<const decode::TouchContact> now) {
  std::vector<decode::TouchContact>& before = fingers_[device];
  std::vector<Finger> changed;
  const auto id_of = [&](const decode::TouchContact& one) { return (std::int64_t{device} << 32) | one.id; };
  const auto in = [](std::span<const decode::TouchContact> all, std::uint32_t id) {
    return std::find_if(all.begin(), all.end(), [id](const auto& one) { return one.id == id; });
  };
  for (const auto& one : before) {
    if (in(now, one.id) == now.end()) changed.push_back({FingerKind::up, id_of(one), one});
  }
  for (const auto& one : now) {
    const auto was = std::find_if(before.begin(), before.end(), [&](const auto& old) { return old.id == one.id; });
    if (was == before.end()) {
      changed.push_back({FingerKind::down, id_of(one), one});
    } else if (!(*was == one)) {
      changed.push_back({FingerKind::move, id_of(one), one});
    }
  }
  before.assign(now.begin(), now.end());
  return changed;
}

}  // namespace penpose::app
