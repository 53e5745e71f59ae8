#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/time/overlap.h"
#include "ui/app/notices.h"
#include "ui/app/playback/keys.h"
#include "ui/app/playback/playback.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// How controls trail, in an animator's units.
struct OverlapValues {
  std::optional<std::size_t> leader;  ///< whose motion they take; nothing: each its own
  double delay_frames = 2;
  double period_frames = 8;
  double swing = 0;   ///< how far they swing past, a share of the way
  double amount = 1;  ///< of a leader's motion
  friend bool operator==(const OverlapValues&, const OverlapValues&) = default;
};

inline constexpr double k_most_delay_frames = 24;
inline constexpr double k_most_period_frames = document::k_longest_period_frames;

/// Controls whose keys are selected trail: shown on the face and as curves while it is open, and no keys before they
/// are baked. Anything else that changes the document ends it, unless the artist shows by drawing where the trailing
/// part should be: what was drawn then says how stiff the spring is, and is taken back.
class OverlapOffer {
 public:
  OverlapOffer(EditingSession& editing, Playback& playback, Keys& keys, Notices& notices)
      : editing_(editing), playback_(playback), keys_(keys), notices_(notices) {}

  /// A control that trails.
  struct Trailing {
    document::Overlap overlap;
    std::shared_ptr<const document::LedWay> way;
    document::TrailingCurve curve;
    document::TrailingKeys keys;  ///< that it is baked as
  };

  /// Begins with the selected keys; tells what to select where there are none.
  void begin();
  [[nodiscard]] bool open() const { return !trailing_.empty(); }
  [[nodiscard]] const std::vector<Trailing>& trailing() const { return trailing_; }
  [[nodiscard]] const OverlapValues& values() const { return values_; }
  void set(const OverlapValues& values);
  /// Controls that move and do not trail.
  [[nodiscard]] std::vector<std::size_t> leaders() const;
  /// The value of a control that trails, at a moment; nothing: it does not.
  [[nodiscard]] std::optional<double> value_at(std::size_t control, double time_s) const;

  /// Whether strokes say where the trailing part should be.
  [[nodiscard]] bool shows() const { return shows_; }
  void show_by_drawing(bool on);
  /// What came of the last drawing, in a sentence; empty: nothing was drawn.
  [[nodiscard]] const std::string& said() const { return said_; }

  /// One step.
  void bake();
  /// All is as it was.
  void dismiss();
  /// Another document was opened.
  void forget();
  /// Call it for every frame.
  void follow();

 private:
  void reckon();
  [[nodiscard]] rig::Pose pose_at(double time_s) const;
  /// The spring that the drawn pose says.
  void look_at(const rig::Pose& drawn);
  /// The face is posed as it is shown, to be drawn on.
  void pose_for_drawing();
  /// Takes back that pose and what was drawn on it.
  void take_back();
  /// The pose is that of the timeline, and not one that going elsewhere would lose.
  [[nodiscard]] bool keyed() const;
  void follow_drawing();
  void end();

  EditingSession& editing_;
  Playback& playback_;
  Keys& keys_;
  Notices& notices_;
  std::vector<Trailing> trailing_;
  OverlapValues values_;
  std::string said_;
  std::shared_ptr<const document::Timeline> timeline_;  ///< that it was asked of
  std::shared_ptr<const rig::CharacterRig> rig_;
  std::uint64_t revision_ = 0;
  bool shows_ = false;
  std::size_t commands_ = 0;             ///< that there were before the pose to draw on
  std::size_t posed_commands_ = 0;       ///< with it
  std::optional<rig::Pose> to_draw_on_;  ///< that pose, while it is the document's
  double posed_s_ = 0;
};

}  // namespace penpose::app
