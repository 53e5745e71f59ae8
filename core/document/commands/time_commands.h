#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/document/drawing/pose_curve.h"
#include "core/document/time/timeline.h"

// Commands of keys and views (command.h).

namespace penpose::document {

/// Keys the pose at a moment, in place of a key that is there. The pose may have a name.
struct SetKey {
  static constexpr std::string_view k_name = "set_key";
  double time_s = 0;
  std::string name;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("time_s", self.time_s);
    visit("name", self.name);
  }
  friend bool operator==(const SetKey&, const SetKey&) = default;
};

/// Keys what was performed: some controls at each of some moments. All else at a moment is what the timeline has there,
/// or the pose where nothing is keyed; keys between the moments are kept, with these controls evenly between. Errors:
/// no such parameter or one named twice, a value out of range, moments that do not ascend, another number of values.
struct KeyPoses {
  static constexpr std::string_view k_name = "key_poses";
  std::vector<std::string> names;
  std::vector<double> times_s;
  std::vector<double> values;  ///< one row a moment, one a name in it
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("names", self.names);
    visit("times_s", self.times_s);
    visit("values", self.values);
  }
  friend bool operator==(const KeyPoses&, const KeyPoses&) = default;
};

struct DeleteKey {
  static constexpr std::string_view k_name = "delete_key";
  double time_s = 0;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("time_s", self.time_s);
  }
  friend bool operator==(const DeleteKey&, const DeleteKey&) = default;
};

/// Errors: no key there, another key where it should go.
struct MoveKey {
  static constexpr std::string_view k_name = "move_key";
  double from_s = 0;
  double to_s = 0;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("from_s", self.from_s);
    visit("to_s", self.to_s);
  }
  friend bool operator==(const MoveKey&, const MoveKey&) = default;
};

struct SetKeyInterpolation {
  static constexpr std::string_view k_name = "set_key_interpolation";
  KeyInterpolation interpolation = KeyInterpolation::smooth;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("interpolation", self.interpolation);
  }
  friend bool operator==(const SetKeyInterpolation&, const SetKeyInterpolation&) = default;
};

/// Takes the pose of the timeline at a moment.
struct GoToTime {
  static constexpr std::string_view k_name = "go_to_time";
  double time_s = 0;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("time_s", self.time_s);
  }
  friend bool operator==(const GoToTime&, const GoToTime&) = default;
};

/// Keeps a view under a name, in place of one of that name.
struct SaveView {
  static constexpr std::string_view k_name = "save_view";
  std::string name;
  View view;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("name", self.name);
    visit("view", self.view);
  }
  friend bool operator==(const SaveView&, const SaveView&) = default;
};

struct DeleteView {
  static constexpr std::string_view k_name = "delete_view";
  std::string name;
  template <typename Self>
  static void fields(Self& self, auto&& visit) {
    visit("name", self.name);
  }
  friend bool operator==(const DeleteView&, const DeleteView&) = default;
};

}  // namespace penpose::document
