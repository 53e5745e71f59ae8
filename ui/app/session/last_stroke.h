#pragma once

#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/intent/live.h"

namespace penpose::app {

/// A parameter that the last stroke moved.
struct Movement {
  std::string name;
  double by = 0;
  bool at_limit = false;  ///< it stands at an end of its range
};

/// What the last stroke that solved did: what it moved, and what it left of the way.
class LastStroke {
 public:
  /// The parameters that it moved, the most first.
  [[nodiscard]] const std::vector<Movement>& movements() const { return movements_; }
  /// px that it leaves between its curve and its target, in the mean; negative: not known.
  [[nodiscard]] double left_px() const { return left_px_; }
  /// Whether that is no more than what a hand leaves in a view.
  [[nodiscard]] bool within_hand(const document::Document& document, geometry::Viewport viewport) const;
  /// Whose target it was; null: several.
  [[nodiscard]] document::CurveId curve() const { return curve_; }
  /// Whether nothing has happened since.
  [[nodiscard]] bool is_newest() const { return left_px_ >= 0 && newest_; }
  /// The same, also where nothing is known of what is left.
  [[nodiscard]] bool is_fresh() const { return newest_; }
  /// What is said in place of what it moved; empty: nothing.
  [[nodiscard]] const std::string& text() const { return text_; }
  /// Says something in place of what it moved, until something else happens.
  void say(std::string text);

  /// Something happened that is no stroke.
  void grow_old();
  /// Nothing is known of what it moved any more.
  void forget();
  /// Looks at what it did to a document. `drawn`: the curve with a new target; null: all were solved again.
  void look_at(const document::Document& before, const document::Document& after, document::CurveId drawn,
               const intent::WholeModel& whole);

 private:
  std::vector<Movement> movements_;
  double left_px_ = -1;
  double beyond_px_ = 0;  ///< that the line's farther end lies from the curve
  document::CurveId curve_;
  bool newest_ = false;
  std::string text_;
};

}  // namespace penpose::app
