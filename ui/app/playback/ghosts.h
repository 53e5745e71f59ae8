#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/commands/command.h"
#include "core/document/document.h"
#include "ui/app/canvas/canvas.h"
#include "ui/app/notices.h"
#include "ui/app/playback/playback.h"
#include "ui/app/session/editing_session.h"
#include "ui/render/cpu/ghost_veil.h"
#include "ui/render/ghosts/ghost_drawings.h"

namespace penpose::app {

using geometry::PxPoint;

/// A change of a moment that goes out on both sides of it.
struct GhostEdit {
  double time_s = 0;
  std::vector<std::size_t> controls;  ///< that move
  std::vector<double> by;             ///< one a control
  double from_s = 0, to_s = 0;        ///< its reach: the moment lies in it, or is one of its ends
};
/// What brings the face at a moment to another pose. The reach goes up to the keys before and after that. Nothing:
/// nothing moves.
[[nodiscard]] std::optional<GhostEdit> ghost_edit(const document::Document& document, double time_s,
                                                  const rig::Pose& posed);
/// Keys what moves: at the moment, at keys within its reach, and at the reach's ends.
[[nodiscard]] document::Command command_of(const document::Document& document, const GhostEdit& edit);

/// How much of a change at a moment is left at another one that lies within its reach: 1 there, 0 at the reach's ends.
[[nodiscard]] double share_left(double time_s, double changed_s, double from_s, double to_s);

/// The face at other moments: shows it beside the face as it is now, has lines drawn on it, and has the last change in
/// hand whose reach may still be another one.
class GhostHand {
 public:
  struct Parts {
    EditingSession& editing;
    Playback& playback;
    Notices& notices;
    const Canvas& canvas;
    const CanvasLook& look;
  };
  explicit GhostHand(const Parts& parts) : parts_(parts) {}

  /// Looks at ghosts as they are now: beside which moment (nothing: none are shown), and where a pen is that would draw
  /// on them (nothing: none would).
  void follow(std::optional<double> time_s, std::optional<PxPoint> pen);
  [[nodiscard]] const render::GhostFaces& faces() const { return faces_; }
  [[nodiscard]] std::span<const render::CurveDrawing> drawings() const { return drawings_; }
  /// Whether the next frame shows them otherwise, without any event.
  [[nodiscard]] bool waits() const { return !faces_.settled(); }
  /// Of translucent faces; null: none.
  [[nodiscard]] const std::shared_ptr<const render::Image>& veil() const { return veil_; }
  /// The moment that takes a line which begins where the pen is; nothing: none does.
  [[nodiscard]] std::optional<double> lit_s() const;
  /// Says what a line would do there, or how to come to ghosts.
  [[nodiscard]] std::string hint() const;

  /// A line begins there: the ghost that takes it is the one that is nearest.
  void press(PxPoint at) { lit_ = place_at(at); }
  /// What a line does that is drawn on a ghost: that moment is posed as the tool Draw would there.
  void draw(std::span<const PxPoint> line);
  /// The last change, until something else is done; null: none.
  [[nodiscard]] const GhostEdit* last() const {
    return last_ && parts_.editing.revision() == revision_ ? &*last_ : nullptr;
  }
  /// Gives the last change another reach, in its place. The moment stays in it.
  void reach(double from_s, double to_s);

 private:
  /// What drawings_ and veil_ were made of.
  struct Made {
    std::uint64_t faces = 0;
    std::uint64_t pose = 0;
    document::View view;
    render::GhostStyle style = render::GhostStyle::contours;
    float scale = 1;
    std::optional<render::GhostPlace> lit;
    friend bool operator==(const Made&, const Made&) = default;
  };
  [[nodiscard]] std::optional<render::GhostPlace> place_at(PxPoint at) const;
  [[nodiscard]] std::optional<rig::Pose> solved(const render::Ghost& ghost, const render::GhostLine& near,
                                                std::span<const PxPoint> line);
  void draw_veil(const geometry::Camera& camera);
  bool perform(const GhostEdit& edit);

  Parts parts_;
  render::GhostFaces faces_;
  std::optional<render::GhostPlace> lit_;
  Made made_;
  std::vector<render::CurveDrawing> drawings_;
  std::shared_ptr<const render::Image> veil_;
  std::unique_ptr<render::GhostVeil> draws_veil_;  ///< null: nothing translucent is drawn
  std::optional<GhostEdit> last_;
  std::uint64_t revision_ = 0;  ///< with it
};

}  // namespace penpose::app
