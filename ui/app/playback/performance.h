#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/document/commands/command.h"
#include "core/document/document.h"

namespace penpose::app {

/// A pose that is recorded frame by frame while the pen makes it. Controls that the pen moves are recorded; all others
/// are what the timeline has. Moments are seconds of the timeline.
class Performance {
 public:
  /// `still`: the pose before the pen moves anything.
  Performance(double time_s, int rate, rig::Pose still);

  /// What the pen makes of the pose at a moment. Frames since the moment before are filled evenly; a moment before that
  /// one begins another round over the same frames. `drawn_px`: the length of the line that the pen has drawn so far.
  void take(double time_s, const rig::Pose& pen, double drawn_px = 0);
  /// A pose of the timeline with what the pen moved so far.
  [[nodiscard]] rig::Pose over(rig::Pose background, const rig::Pose& pen) const;

  /// The frames that were recorded.
  [[nodiscard]] std::size_t frame_count() const { return frames_.size(); }
  /// The moment of the first one. Precondition: there is one.
  [[nodiscard]] double first_s() const;
  /// The moment of the last one. Precondition: there is one.
  [[nodiscard]] double last_s() const;
  /// What was recorded; nothing where the pen moved nothing. `now`: controls that are not as they were before are keyed
  /// too, as the pen has left them. Precondition: the parameters that the poses are of.
  [[nodiscard]] std::optional<document::KeyPoses> keys(std::span<const rig::Parameter> parameters,
                                                       const rig::Pose& now) const;
  /// What a line did that was drawn: what it meant shows when all of it is there, so the face goes to `now` as the pen
  /// went along the line, and holds there. Nothing where the line moved nothing. Precondition: as keys.
  [[nodiscard]] std::optional<document::KeyPoses> keys_of_line(std::span<const rig::Parameter> parameters,
                                                               const rig::Pose& now) const;

 private:
  struct Frame {
    rig::Pose pose;
    double drawn_px = 0;
  };
  void note_moved(const rig::Pose& pose);
  template <class Value>
  [[nodiscard]] std::optional<document::KeyPoses> keys_with(std::span<const rig::Parameter> parameters,
                                                            const std::vector<std::size_t>& numbers, Value value) const;
  int rate_;
  rig::Pose still_;
  std::vector<bool> moved_;      ///< one a parameter
  std::map<int, Frame> frames_;  ///< by number
  double at_;                    ///< the moment of the last take, in frames
  Frame last_;                   ///< and what was there
};

}  // namespace penpose::app
