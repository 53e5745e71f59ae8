#include "ui/app/session/suggestion_offer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/app/view/said.h"

namespace penpose::app {
namespace {

/// Whether nothing but locks is different.
bool locks_alone(const document::Document& a, const document::Document& b) {
  return a.model == b.model && a.pose == b.pose && a.curves == b.curves && a.time_s == b.time_s &&
         (a.timeline == b.timeline || *a.timeline == *b.timeline) && a.locked != b.locked;
}

}  // namespace

void SuggestionOffer::show(Workspace& workspace) {
  const document::Document& document = workspace.document();
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
  revision_ = workspace.revision();
  workspace.preview(suggestion_->pose);
}

base::Status SuggestionOffer::ask(Workspace& workspace) {
  auto suggestion = document::suggest_rest(workspace.document());
  if (!suggestion) {
    dismiss(workspace);
    return suggestion.error();
  }
  suggestion_ = std::move(suggestion).value();
  show(workspace);
  return base::Done{};
}

void SuggestionOffer::set_strength(Workspace& workspace, double strength) {
  if (!suggestion_) return;
  auto other = document::suggest_rest(workspace.document(), workspace.document().timeline->keys,
                                      suggestion_->command.held, std::clamp(strength, 0.0, 1.0));
  if (!other) return dismiss(workspace);
  suggestion_ = std::move(other).value();
  show(workspace);
}

void SuggestionOffer::take(Workspace& workspace) {
  if (!suggestion_) return;
  const document::SuggestRest command = suggestion_->command;
  dismiss(workspace);
  workspace.perform(command);
}

void SuggestionOffer::dismiss(Workspace& workspace) {
  if (!suggestion_) return;
  suggestion_.reset();
  workspace.preview(std::nullopt);
}

void SuggestionOffer::follow(Workspace& workspace) {
  if (!suggestion_) return;
  if (workspace.revision() != revision_) {
    if (!locks_alone(asked_, workspace.document())) return dismiss(workspace);
    static_cast<void>(ask(workspace));
    return;
  }
  // A stroke, a slider or the timeline shows a pose of its own, which stays.
  if (!workspace.previews() || (!workspace.live().active() && workspace.shown_pose() != suggestion_->pose)) {
    suggestion_.reset();
  }
}

const std::string& SuggestionOffer::why_not(const Workspace& workspace) {
  if (looked_at_ == workspace.revision()) return why_not_;
  looked_at_ = workspace.revision();
  const auto error = document::no_suggestion(workspace.document());
  why_not_ = error ? said(*error) : std::string();
  return why_not_;
}

}  // namespace penpose::app
