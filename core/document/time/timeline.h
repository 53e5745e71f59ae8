#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/document/model.h"
#include "core/rig/rig.h"

namespace penpose::document {

/// An immutable pose, shared by all copies: undo keeps many timelines that differ by one key.
class SharedPose {
 public:
  SharedPose() : SharedPose(rig::Pose()) {}
  SharedPose(rig::Pose pose)  // NOLINT(google-explicit-constructor): a pose is one
      : pose_(std::make_shared<const rig::Pose>(std::move(pose))) {}

  operator const rig::Pose&() const { return *pose_; }  // NOLINT(google-explicit-constructor)
  [[nodiscard]] double operator[](std::size_t parameter) const { return (*pose_)[parameter]; }
  [[nodiscard]] std::size_t size() const { return pose_->size(); }
  [[nodiscard]] auto begin() const { return pose_->begin(); }
  [[nodiscard]] auto end() const { return pose_->end(); }
  friend bool operator==(const SharedPose& a, const SharedPose& b) {
    return a.pose_ == b.pose_ || *a.pose_ == *b.pose_;
  }

 private:
  std::shared_ptr<const rig::Pose> pose_;
};

/// How a control goes on from a key to its next one.
enum class KeyKind : std::uint8_t {
  smooth,     ///< cubic Hermite whose tangents never overshoot the keys (Fritsch and Carlson 1980)
  linear,     ///< straight
  stepped,    ///< holds its value up to the next key
  ease_in,    ///< starts slowly: a square of time
  ease_out,   ///< arrives slowly: a square of time
  ease,       ///< both: a cubic with flat ends
  free,       ///< cubic Hermite with the slopes that the key has, within the control's range
  overshoot,  ///< as free, and the curve may leave the control's range
  none,       ///< no key of this control here
};

/// Whether a key of that kind has slopes of its own.
[[nodiscard]] constexpr bool has_slopes(KeyKind kind) { return kind == KeyKind::free || kind == KeyKind::overshoot; }

/// The key of one control.
struct ControlKey {
  KeyKind kind = KeyKind::smooth;
  // Slopes of a free or overshooting key, in units of the control a second: of what leads to the key, and of what
  // leaves it.
  double in = 0, out = 0;
  friend bool operator==(const ControlKey&, const ControlKey&) = default;
};

/// The keys of all controls at one moment, immutable and shared by all copies. By default each control has a smooth
/// one.
class ControlKeys {
 public:
  ControlKeys() = default;
  /// One a parameter.
  ControlKeys(std::vector<ControlKey> keys);  // NOLINT(google-explicit-constructor): a list is one

  [[nodiscard]] ControlKey operator[](std::size_t parameter) const {
    return keys_ ? (*keys_)[parameter] : ControlKey{};
  }
  [[nodiscard]] bool has(std::size_t parameter) const { return !keys_ || (*keys_)[parameter].kind != KeyKind::none; }
  /// Every control has a smooth key.
  [[nodiscard]] bool usual() const { return !keys_; }
  /// Every control has a key.
  [[nodiscard]] bool whole() const;
  /// No control has one.
  [[nodiscard]] bool empty() const;
  /// One for each of so many parameters.
  [[nodiscard]] std::vector<ControlKey> list(std::size_t parameters) const;
  friend bool operator==(const ControlKeys& a, const ControlKeys& b) {
    return a.keys_ == b.keys_ || (a.keys_ && b.keys_ && *a.keys_ == *b.keys_);
  }

 private:
  std::shared_ptr<const std::vector<ControlKey>> keys_;  ///< null: usual()
};

/// The keys at one moment.
struct PoseKey {
  double time_s = 0;
  SharedPose pose;            ///< one value a parameter of the rig: keyed, or what comes of the keys around (settled())
  std::string name;           ///< of the pose, or empty
  ControlKeys controls = {};  ///< which controls have a key here, and how they go on
  friend bool operator==(const PoseKey&, const PoseKey&) = default;
};

/// Keys, ascending in time, no two at the same time.
struct Timeline {
  std::vector<PoseKey> keys;
  friend bool operator==(const Timeline&, const Timeline&) = default;
};

/// The latest time of a key, seconds.
inline constexpr double k_latest_key_s = 36000;

/// The place in the list of the first key at or after a moment; their number, where there is none.
[[nodiscard]] std::size_t first_from(const Timeline& timeline, double time_s);

/// The cubic between two keys of one control.
struct KeySegment {
  double from_s = 0, to_s = 0;
  double from = 0, to = 0;              ///< values
  double slope_from = 0, slope_to = 0;  ///< units a second
  KeyKind kind = KeyKind::smooth;       ///< of the key before
  bool overshoots = false;              ///< it may leave the control's range
};
[[nodiscard]] double value_at(const KeySegment& segment, double time_s);
[[nodiscard]] double slope_at(const KeySegment& segment, double time_s);
/// The least and the greatest value of the segment.
[[nodiscard]] std::pair<double, double> extremes(const KeySegment& segment);

/// The last key of a control at or before that place in the list, and the first at or after it.
[[nodiscard]] std::optional<std::size_t> key_before(const Timeline& timeline, std::size_t parameter, std::size_t place);
[[nodiscard]] std::optional<std::size_t> key_after(const Timeline& timeline, std::size_t parameter, std::size_t place);
/// The segment between two neighbouring keys of a control.
[[nodiscard]] KeySegment segment_of(const Timeline& timeline, std::size_t parameter, std::size_t from, std::size_t to);

/// The key of a control at that place of the list with the slopes that its curve has there, whatever its kind.
/// Precondition: the control has a key there.
[[nodiscard]] ControlKey with_slopes(const Timeline& timeline, std::size_t place, std::size_t parameter);

/// One control at a time, held before its first and after its last key. Nothing: it has no key.
[[nodiscard]] std::optional<double> sample(const Timeline& timeline, std::size_t parameter, double time_s);
/// The pose at a time. Controls without a key are as in `unkeyed`. Precondition: one value a parameter of the keys.
[[nodiscard]] rig::Pose sample(const Timeline& timeline, double time_s, rig::Pose unkeyed);

/// The slope of a smooth key between its neighbours, in units a second (Fritsch and Carlson 1980): the mean of both
/// secants, cut so that neither segment overshoots; flat where the curve turns.
[[nodiscard]] double monotone_slope(double secant_before, double secant_after);

}  // namespace penpose::document
