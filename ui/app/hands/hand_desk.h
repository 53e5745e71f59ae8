#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/sample/pen_sample.h"
#include "firmware_io/decode/table/tablet_table.h"
#include "replay/session/hand_input.h"
#include "ui/app/hands/binding.h"
#include "ui/app/input/touch_gestures.h"

namespace penpose::app {

/// A tablet as its user sees it: all of its interfaces are one, a remote is one of its own.
struct DeskTablet {
  std::string key;   ///< of its bindings in the settings, the same for all of one model
  std::string unit;  ///< tells it from another one of its model
  std::string name;
  std::vector<int> devices;  ///< its interfaces
  int pad = -1;              ///< the interface that has the keys; -1: none
  decode::PadFeatures features;
  bool has_pen = false;
  bool pen_wheel = false;
  bool pen_rotation = false;
  std::array<std::int8_t, decode::k_pad_sides> next_mode{};  ///< without lights: what the dials do now
  decode::Battery battery;
  bool low_told = false;  ///< that its battery is low
  std::string guess;      ///< which of several models with its ids it is taken for; empty where something tells

  [[nodiscard]] bool has_anything() const { return features.any() || has_pen; }
  [[nodiscard]] bool is(const std::pair<std::string, std::string>& which) const {
    return key == which.first && unit == which.second;
  }
};

/// Names the settings of a tablet: the table's name where it is one for certain, else its ids and its own name. A
/// tablet over Bluetooth is the same one as over its cable.
[[nodiscard]] std::string tablet_key(const decode::DeviceIdentity& identity, const decode::TabletTable* own = nullptr);

/// A key or a button that is held, with what it meant when it was pressed.
struct HeldBinding {
  int device = 0;
  PadControl control;
  Binding binding;
};

/// The tablets on the desk and what is held on them. Knows what things mean and does none of it.
class HandDesk {
 public:
  void add(int device, const decode::DeviceIdentity& identity, const replay::HandInput& hands,
           const decode::PenAxes* pen, const decode::TabletTable* own);
  /// The interface is gone, and its tablet with the last of them.
  void remove(int device);

  [[nodiscard]] const std::vector<DeskTablet>& tablets() const { return tablets_; }
  /// The tablet of an interface, null when it is none.
  [[nodiscard]] DeskTablet* find(int device);
  [[nodiscard]] const DeskTablet* find(int device) const;

  void press(const HeldBinding& held) { held_.push_back(held); }
  /// What was held under that control, nothing when it was not.
  std::optional<Binding> release(int device, const PadControl& control);
  /// What was pressed last of a kind and is still held.
  [[nodiscard]] const Binding* held(Binding::Kind kind) const;
  [[nodiscard]] bool is_held(int device, const PadControl& control) const;
  /// What is held on an interface, for the one who says that it is let go.
  [[nodiscard]] std::vector<HeldBinding> held_on(int device) const;

  /// Whole steps out of turns, of which the rest is kept for the next: one each `per` 120ths.
  [[nodiscard]] int whole_steps(int device, const PadControl& control, std::int32_t by, std::int32_t per);
  void forget_rest(int device);

  /// How far a pen's own wheel, or the pen about itself, went since its last position; notches of 120. 0 for the first.
  [[nodiscard]] std::int32_t pen_turned(int device, bool rotation, std::int32_t value, const decode::Axis& axis);
  void pen_left(int device);

  /// The fingers of an interface, as events for gestures.
  struct Finger {
    FingerKind kind;
    std::int64_t id;
    decode::TouchContact contact;
  };
  [[nodiscard]] std::vector<Finger> fingers_changed(int device, std::span<const decode::TouchContact> now);

 private:
  std::vector<DeskTablet> tablets_;
  std::vector<HeldBinding> held_;
  std::map<std::pair<int, std::string>, std::int32_t> rests_;
  std::map<std::pair<int, bool>, std::int32_t> pen_at_;
  std::map<int, std::vector<decode::TouchContact>> fingers_;
};

}  // namespace penpose::app
