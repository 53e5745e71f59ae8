#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/document/time/timeline.h"

namespace penpose::document {

/// A timeline whose keys are changed, each control's by itself. Preconditions: moments on the timeline, parameters of
/// the rig, values within their ranges.
class TimelineEditing {
 public:
  /// `unkeyed`: the values of controls without keys.
  TimelineEditing(const Timeline& timeline, std::span<const rig::Parameter> parameters, rig::Pose unkeyed);

  /// Sets a key, in place of one that is there.
  void set(double time_s, std::size_t parameter, double value, const ControlKey& key);
  /// Takes a key away, if there is one.
  void erase(double time_s, std::size_t parameter);
  /// Takes away the keys of a control in a span of time and sets free ones at its ends, so that its curve before and
  /// after it stays (for a key behind it that eases, nearly). Precondition: from_s < to_s.
  void open_span(std::size_t parameter, double from_s, double to_s);
  /// Sets a key where the curve of a control goes at a moment, which stays as it is (before a stepped key, nearly).
  /// Nothing before its first key.
  void cut(std::size_t parameter, double time_s);
  /// Sets a free key with one slope; where `before` or `after` is false, that side keeps the slope of open_span.
  void bend(double time_s, std::size_t parameter, double value, double slope, bool before, bool after);
  /// Names the moment; without a key there it has none.
  void name(double time_s, std::string name);

  /// What came of it: moments without keys are gone, poses at keys are what the curves of all controls say there, and
  /// slopes of free keys are no steeper than the range of their control allows.
  [[nodiscard]] Timeline finish() &&;

 private:
  struct Moment {
    rig::Pose pose;
    std::string name;
    std::vector<ControlKey> controls;
  };
  Moment& open(double time_s);

  const Timeline& before_;
  std::span<const rig::Parameter> parameters_;
  rig::Pose unkeyed_;
  std::map<double, Moment> changed_;
};

/// The place of a moment in the list of keys. Nothing: no key is there.
[[nodiscard]] std::optional<std::size_t> key_at(const Timeline& timeline, double time_s);

/// The keys of a span of time, which then begins at 0, with keys at both ends where a curve goes through them.
/// Precondition: from_s < to_s, moments on the timeline.
[[nodiscard]] Timeline trimmed(const Timeline& timeline, std::span<const rig::Parameter> parameters, double from_s,
                               double to_s);

/// Brings keys into the form in which TimelineEditing leaves them, as for keys that were read from a file.
[[nodiscard]] Timeline settled(Timeline timeline, std::span<const rig::Parameter> parameters);

}  // namespace penpose::document
