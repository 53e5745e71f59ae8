#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/app/face/face_readings.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// What the other readings of the last line move, in words, the best first: "lips pucker +0.30", "without jaw opens".
/// Both sides that go alike are one. `words`: one a parameter. Empty: the last line has no others, or something else
/// came after it.
[[nodiscard]] std::vector<std::string> words_of_readings(const document::Document& document,
                                                         std::span<const document::ControlWords> words);

/// One of them.
struct OfferedReading {
  std::string words;           ///< what it moves, or the feature that the line then is
  std::optional<int> percent;  ///< how likely it is, rounded; nothing: not known
  document::SharedPose pose;   ///< what the face shows
  document::Command command;   ///< what makes it a step
  std::string feature = {};    ///< the name of the feature that a line of the face then is

  /// What it moves most, without numbers: "lips pucker", "without jaw opens".
  [[nodiscard]] std::string brief() const;
};

/// Other readings of the last line, "did you mean": one is shown on the face where the pen is over it, and becomes a
/// step when it is taken. The reading that it took the place of is then among them. The next step ends the offer. Of a
/// line of the face they are other features; those of an older line are offered while its menu asks for them.
class ReadingOffer {
 public:
  /// Call it for every frame. `quiet`: nothing is offered now. `asked`: the line of the face whose menu is open.
  void follow(EditingSession& editing, bool quiet, std::optional<document::CurveId> asked);
  [[nodiscard]] bool open() const { return !readings_.empty(); }
  [[nodiscard]] const std::vector<OfferedReading>& readings() const { return readings_; }
  /// The line of the face that they are readings of; nothing: a target.
  [[nodiscard]] std::optional<document::CurveId> face_line() const { return face_.line(); }
  /// More may be found in the next frame.
  [[nodiscard]] bool searches() const { return face_.searches(); }
  /// Whether the line moved nothing, though it asks for more than the hand's doubt.
  [[nodiscard]] bool nothing_moved() const { return nothing_moved_; }
  /// Shows one on the face; nothing: none.
  void show(EditingSession& editing, std::optional<std::size_t> which);
  /// Makes one a step, where there are so many.
  void take(EditingSession& editing, std::size_t which);

 private:
  void close(EditingSession& editing);
  void look_at_target(EditingSession& editing);
  void look_at_face(EditingSession& editing, document::CurveId line);

  std::vector<OfferedReading> readings_;
  FaceReadings face_;
  NewestFaceLine newest_;
  std::optional<document::CurveId> drawn_;  ///< the line of the face that the newest step was about
  bool nothing_moved_ = false;
  std::optional<std::size_t> shown_;
  rig::Pose shown_pose_;
  std::optional<std::uint64_t> revision_;  ///< that was followed last
  bool looked_ = false;                    ///< at its target
};

}  // namespace penpose::app
