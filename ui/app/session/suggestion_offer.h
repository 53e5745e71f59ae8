#pragma once

#include <optional>
#include <string>

#include "core/document/suggestion.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// The rest of the face as the keys suggest it: shown on the model, and no command before it is taken. Anything else
/// that changes the document or shows another pose ends it.
class SuggestionOffer {
 public:
  /// Shows what is suggested. Errors: there are no keys to learn from, nothing is posed, ...
  base::Status ask(EditingSession& editing);
  [[nodiscard]] bool open() const { return suggestion_.has_value(); }
  /// Precondition: open.
  [[nodiscard]] const document::Suggestion& suggestion() const { return *suggestion_; }
  /// Controls that it moves, the most first; by shares of their ranges.
  [[nodiscard]] const std::vector<Movement>& movements() const { return movements_; }
  /// How much of the way, 0..1.
  void set_strength(EditingSession& editing, double strength);
  /// Makes it a command.
  void take(EditingSession& editing);
  void dismiss(EditingSession& editing);
  /// Call it for every frame. What was locked since ("not this one") is asked again; what else happened ends the offer.
  void follow(EditingSession& editing);

  /// Why there is nothing to ask for, in an animator's words; empty where there is.
  [[nodiscard]] const std::string& why_not(const EditingSession& editing);

 private:
  void show(EditingSession& editing);

  std::optional<document::Suggestion> suggestion_;
  std::vector<Movement> movements_;
  document::Document asked_;  ///< what it was asked of
  std::uint64_t revision_ = 0;
  std::optional<std::uint64_t> looked_at_;  ///< the revision that why_not_ is of
  std::string why_not_;
};

}  // namespace penpose::app
