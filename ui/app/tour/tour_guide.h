#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "ui/app/actions.h"
#include "ui/app/canvas/canvas.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/playback/playback.h"
#include "ui/app/tour/tour.h"

namespace penpose::app {

class Files;

/// A tour that is under way: it waits for what its step asks for, looks at what the user did and says what to try
/// again. Works on the user's own document and changes it only to take back what was not meant.
class TourGuide {
 public:
  struct Parts {
    EditingSession& editing;
    Canvas& canvas;
    Playback& playback;
    PanelState& panels;
    const Player& player;
    const Files& files;
    Actions& actions;
  };
  explicit TourGuide(const Parts& parts) : parts_(parts) {}

  /// Begins on a document that was just opened. Precondition: it is the tour's model.
  void begin(Tour tour);
  /// Looks at what was done since; call it when the surface is up to date.
  void follow();
  /// A line was begun on the tour's own card, which lies over the foot of the picture.
  void drag_beside();
  /// Does the step in the user's place.
  void skip();
  void leave() { tour_.reset(); }

  [[nodiscard]] bool active() const { return tour_.has_value(); }
  // Preconditions of what follows: active().
  [[nodiscard]] const Tour& tour() const { return *tour_; }
  /// Of its steps the one that is due, from 0; the number of them once all are done.
  [[nodiscard]] std::size_t step() const { return begun_.size() - 1; }
  [[nodiscard]] bool done() const { return step() >= tour_->steps.size(); }
  /// The sentence that is to be read now.
  [[nodiscard]] std::string says() const;
  /// What to try again; empty: nothing was tried.
  [[nodiscard]] const std::string& again() const { return again_; }
  /// The line to draw, on the model; empty: none.
  [[nodiscard]] std::span<const geometry::ModelPoint> ghost() const { return ghost_; }
  [[nodiscard]] bool ghost_closed() const;
  /// Under which label lies what is to be pressed or moved; empty: nothing is.
  [[nodiscard]] std::string pointed() const;
  /// The moment to go to, where the step asks for one.
  [[nodiscard]] std::optional<double> asked_time() const;

 private:
  struct Answer {
    bool right = false;
    std::string again;
    bool taken_back = true;  ///< what was done, where it is not right
  };
  void begin_step(std::size_t commands);
  /// What a step draws, on the model as it is now; empty: nothing.
  [[nodiscard]] std::vector<geometry::ModelPoint> line_of(std::size_t step) const;
  [[nodiscard]] const document::Command* wanted() const;
  /// Of the commands since the step began the first that it may ask for; nothing: there is none.
  [[nodiscard]] std::optional<std::size_t> given() const;
  [[nodiscard]] Answer judge() const;
  [[nodiscard]] Answer judge_drawn() const;
  /// What to try again after a stroke, in px of the view, that did nothing; empty: nothing is known of it.
  [[nodiscard]] std::string why_not(const std::vector<geometry::PxPoint>& stroke) const;

  void bring_into_sight(std::span<const geometry::ModelPoint> line);

  Parts parts_;
  std::optional<Tour> tour_;
  std::vector<std::size_t> begun_;  ///< how many commands were done when each step began, up to the one that is due
  std::vector<geometry::ModelPoint> ghost_;
  std::vector<geometry::ModelPoint> ghost_before_;  ///< of the step before
  std::string again_;
  std::vector<geometry::PxPoint> stroke_;  ///< under the pen
  std::size_t before_stroke_ = 0;          ///< so many commands were done
};

}  // namespace penpose::app
