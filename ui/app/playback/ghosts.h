#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/document/commands/command.h"
#include "core/document/document.h"
#include "ui/app/notices.h"
#include "ui/app/playback/playback.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

using geometry::PxPoint;

/// A curve of the face as it lies at a neighbouring key.
struct Ghost {
  double time_s = 0;
  document::PoseCurve curve;    ///< a reference without a target
  std::vector<PxPoint> places;  ///< px of the view
};

/// The curves of the document, of one without any those of its model, at the keys before and after its moment.
[[nodiscard]] std::vector<Ghost> ghosts_of(const document::Document& document, const document::View& view);

/// A change of a moment that goes out on both sides of it.
struct GhostEdit {
  double time_s = 0;
  std::vector<std::size_t> controls;  ///< that move
  std::vector<double> by;             ///< one a control
  double from_s = 0, to_s = 0;        ///< its reach: the moment lies in it, or is one of its ends
};
/// What a line means that is drawn where a ghost's curve should be: the face is solved for it as at the ghost's moment.
/// The reach goes up to the keys before and after that. Nothing: no ghost is near the line, or nothing moves.
[[nodiscard]] std::optional<GhostEdit> ghost_meant(const document::Document& document, const document::View& view,
                                                   std::span<const PxPoint> line);
/// Keys what moves: at the moment, at keys within its reach, and at the reach's ends.
[[nodiscard]] document::Command command_of(const document::Document& document, const GhostEdit& edit);

/// How much of a change at a moment is left at another one that lies within its reach: 1 there, 0 at the reach's ends.
[[nodiscard]] double share_left(double time_s, double changed_s, double from_s, double to_s);

/// Draws on ghosts, and has the last change in hand whose reach may still be another one.
class GhostHand {
 public:
  GhostHand(EditingSession& editing, Playback& playback, Notices& notices)
      : editing_(editing), playback_(playback), notices_(notices) {}

  void draw(std::span<const PxPoint> line);
  /// The last change, until something else is done; null: none.
  [[nodiscard]] const GhostEdit* last() const { return last_ && editing_.revision() == revision_ ? &*last_ : nullptr; }
  /// Gives the last change another reach, in its place. The moment stays in it.
  void reach(double from_s, double to_s);

 private:
  bool perform(const GhostEdit& edit);

  EditingSession& editing_;
  Playback& playback_;
  Notices& notices_;
  std::optional<GhostEdit> last_;
  std::uint64_t revision_ = 0;  ///< with it
};

}  // namespace penpose::app
