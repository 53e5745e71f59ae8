#include "ui/app/session/last_stroke.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/document/drawing/pose_problem.h"
#include "core/intent/solve.h"

namespace penpose::app {
namespace {

/// Share of its range from which on a parameter has moved.
constexpr double k_moved = 0.005;
/// Lines begin and end within this many times a hand's doubt of where they are meant to.
constexpr double k_ends_within = 4.0;

std::optional<intent::CurveLeft> left_of(document::Document document, document::CurveId curve,
                                         const intent::WholeModel& whole) {
  // The target that was drawn or dragged; the last one where all were solved again.
  auto drawn = std::find_if(document.curves.rbegin(), document.curves.rend(),
                            [&](const auto& one) { return one->target && (!curve || one->id == curve); });
  if (drawn == document.curves.rend()) return std::nullopt;
  document.curves = {*drawn};
  const auto left = intent::left_at_start(*document.model->rig, whole, document::intent_problem(document));
  if (!left || left->empty()) return std::nullopt;
  return left->front();
}

}  // namespace

bool LastStroke::within_hand(const document::Document& document, geometry::Viewport viewport) const {
  const double hand = document::hand_px(document, viewport);
  return left_px_ <= 2.0 * hand && beyond_px_ <= k_ends_within * hand;
}

void LastStroke::say(std::string text) {
  forget();
  text_ = std::move(text);
}

void LastStroke::grow_old() {
  newest_ = false;
  text_.clear();
}

void LastStroke::forget() {
  movements_.clear();
  left_px_ = -1;
  beyond_px_ = 0;
}

void LastStroke::look_at(const document::Document& before, const document::Document& after, document::CurveId drawn,
                         const intent::WholeModel& whole) {
  forget();
  const auto parameters = after.model->rig->parameters();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double by = after.pose[i] - before.pose[i];
    if (std::abs(by) < k_moved * (parameters[i].maximum - parameters[i].minimum)) continue;
    const bool at_limit = after.pose[i] == parameters[i].minimum || after.pose[i] == parameters[i].maximum;
    movements_.push_back({parameters[i].name, by, at_limit && after.pose[i] != parameters[i].rest});
  }
  std::stable_sort(movements_.begin(), movements_.end(),
                   [](const Movement& a, const Movement& b) { return std::abs(a.by) > std::abs(b.by); });
  newest_ = true;
  curve_ = drawn;
  if (const auto left = left_of(after, drawn, whole)) {
    left_px_ = left->px;
    beyond_px_ = left->beyond_px;
  }
}

}  // namespace penpose::app
