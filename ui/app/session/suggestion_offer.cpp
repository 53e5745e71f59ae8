#include "ui/app/session/suggestion_offer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/app/view/user_messages.h"

namespace penpose::app {
namespace {

/// Whether nothing but locks is different.
bool locks_alone(const document::Document& a, const document::Document& b) {
  return a.model == b.model && a.pose == b.pose && a.curves == b.curves && a.time_s == b.time_s &&
         (a.timeline == b.timeline || *a.timeline == *b.timeline) && a.locked != b.locked;
}

}  // namespace

void SuggestionOffer::show(EditingSession& editing) {
  const document::Document& document = editing.document();
  const auto parameters = document.model->rig->parameters();
  movements_.clear();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double by = suggestion_->pose[i] - document.pose[i];
    if (by == 0) continue;
    const double value = suggestion_->pose[i];
    movements_.push_back({parameters[i].name, by, value == parameters[i].minimum || value == parameters[i].maximum});
  }
  std::stable_sort(movements_.begin(), movements_.end(),
                   [](const Movement& a, const Movement& b) { return std::abs(a.by) > std::abs(b.by); });
  asked_ = document;
  revision_ = editing.revision();
  editing.shown().preview(suggestion_->pose);
}

base::Status SuggestionOffer::ask(EditingSession& editing) {
  auto suggestion = document::suggest_rest(editing.document());
  if (!suggestion) {
    dismiss(editing);
    return suggestion.error();
  }
  suggestion_ = std::move(suggestion).value();
  show(editing);
  return base::Done{};
}

void SuggestionOffer::set_strength(EditingSession& editing, double strength) {
  if (!suggestion_) return;
  auto other = document::suggest_rest(editing.document(), editing.document().timeline->keys, suggestion_->command.held,
                                      std::clamp(strength, 0.0, 1.0));
  if (!other) return dismiss(editing);
  suggestion_ = std::move(other).value();
  show(editing);
}

void SuggestionOffer::take(EditingSession& editing) {
  if (!suggestion_) return;
  const document::SuggestRest command = suggestion_->command;
  dismiss(editing);
  editing.perform(command);
}

void SuggestionOffer::dismiss(EditingSession& editing) {
  if (!suggestion_) return;
  suggestion_.reset();
  editing.shown().preview(std::nullopt);
}

void SuggestionOffer::follow(EditingSession& editing) {
  if (!suggestion_) return;
  if (editing.revision() != revision_) {
    if (!locks_alone(asked_, editing.document())) return dismiss(editing);
    static_cast<void>(ask(editing));
    return;
  }
  // A stroke, a slider or the timeline shows a pose of its own, which stays.
  if (!editing.shown().previews() ||
      (!editing.shown().live().active() && editing.shown().pose() != suggestion_->pose)) {
    suggestion_.reset();
  }
}

const std::string& SuggestionOffer::why_not(const EditingSession& editing) {
  if (looked_at_ == editing.revision()) return why_not_;
  looked_at_ = editing.revision();
  const auto error = document::no_suggestion(editing.document());
  why_not_ = error ? message_of(*error) : std::string();
  return why_not_;
}

}  // namespace penpose::app
