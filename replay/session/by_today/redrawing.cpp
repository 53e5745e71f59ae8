#include "replay/session/by_today/redrawing.h"

#include <algorithm>
#include <utility>

#include "core/document/commands/command_text.h"
#include "core/document/commands/text_form.h"

namespace penpose::replay {
namespace {

using document::Document;
using document::KeyKind;

constexpr std::string_view k_line_mark = "# penpose ";
constexpr std::string_view k_does = "do ";
constexpr std::size_t k_longest_what = 40;
/// Steps of today's that one undo takes back: a bound on what a made-up session can ask for.
constexpr std::size_t k_most_together = 100;

}  // namespace

std::optional<std::string_view> step_line(std::string_view comment) {
  if (!comment.starts_with(k_line_mark)) return std::nullopt;
  comment.remove_prefix(k_line_mark.size());
  const bool is_step = comment.starts_with(k_does) || comment == "undo" || comment == "redo";
  return is_step ? std::optional(comment) : std::nullopt;
}

Redrawing::Redrawing(std::uint32_t edition)
    : one_kind_(one_kind_of(edition).has_value()), kind_(one_kind_of(edition).value_or(KeyKind::smooth)) {
  out_.edition = edition;
  make_hashers();
}

void Redrawing::make_hashers() {
  hashers_.clear();
  for (document::HashForm form : hash_forms_of(out_.edition)) {
    if (form.one_kind) form.one_kind = kind_;
    hashers_.emplace_back(form);
  }
}

void Redrawing::set_kind(KeyKind kind) {
  if (kind == kind_) return;
  kind_ = kind;
  of_kind_ = nullptr;
  if (one_kind_) make_hashers();
}

bool Redrawing::began_on(const Document& document, const base::Hash128& named) {
  recorded_ = named;
  now_ = hashers_.front()(document).whole;
  const auto is_named = [&](document::DocumentHasher& hasher) { return hasher(document).whole == named; };
  if (std::any_of(hashers_.begin(), hashers_.end(), is_named)) return true;
  out_.other_model = !one_kind_;
  if (!one_kind_) return false;
  // A project that the session went on with may have had the other kind.
  set_kind(kind_ == KeyKind::smooth ? KeyKind::linear : KeyKind::smooth);
  if (is_named(hashers_.front())) return true;
  set_kind(KeyKind::smooth);
  out_.other_model = true;
  return false;
}

void Redrawing::begin(std::uint64_t number, std::string_view what, Does does) {
  close(std::nullopt, false);
  Pending step;
  step.step.line = number;
  step.step.what = what;
  step.does = does;
  step.kind_before = kind_;
  pending_ = std::move(step);
}

void Redrawing::begin_stroke(std::uint64_t number) {
  begin(number, "stroke", Does::change);
  pending_->step.stroke = ++out_.strokes;
}

void Redrawing::begin_line(std::uint64_t number, std::string_view line) {
  if (line == "undo") return begin(number, line, Does::undo);
  if (line == "redo") return begin(number, line, Does::redo);
  line.remove_prefix(k_does.size());
  begin(number, line.substr(0, std::min(line.find(' '), k_longest_what)), Does::change);
}

base::Result<std::vector<SessionLine>> Redrawing::today(std::string_view line, const Document& now) {
  std::vector<SessionLine> lines;
  const auto refused = [&](const base::Error& why, bool unknown) {
    refuse(why, unknown);
    return why;
  };
  if (pending_->does != Does::change) {
    const bool undo = pending_->does == Does::undo;
    const std::vector<Past>& steps = undo ? done_ : undone_;
    if (steps.empty()) return refused({"there is nothing to " + std::string(line), "", ""}, false);
    lines.assign(steps.back().today, undo ? SessionLine(Undone{}) : SessionLine(Redone{}));
    return lines;
  }
  line.remove_prefix(k_does.size());
  auto older = today_of(out_.edition, line, now);
  if (!older) return refused(older.error(), true);
  if (*older) {
    if ((*older)->refused) return refused(*(*older)->refused, false);
    if ((*older)->keys) set_kind(*(*older)->keys);
    for (document::Command& command : (*older)->commands) lines.emplace_back(Performed{std::move(command)});
    return lines;
  }
  auto command = document::parse_command(line);
  if (!command) return refused(command.error(), true);
  lines.emplace_back(Performed{std::move(command).value()});
  return lines;
}

void Redrawing::did(const base::Status& status) {
  if (!status) return refuse(status.error(), false);
  ++pending_->done;
}

void Redrawing::refuse(const base::Error& why, bool unknown) {
  pending_->refused = true;
  pending_->unknown = unknown;
  pending_->step.reason = why.line();
  set_kind(pending_->kind_before);
}

std::optional<SessionLine> Redrawing::follow_up(const Document& now) {
  if (pending_->does != Does::change) {
    cross(pending_->does == Does::undo);
    return std::nullopt;
  }
  if (!one_kind_ || now.timeline == of_kind_) return std::nullopt;
  of_kind_ = now.timeline;
  if (auto needed = with_one_kind(*now.timeline, kind_)) return Performed{*std::move(needed)};
  return std::nullopt;
}

/// An undo or a redo is done.
void Redrawing::cross(bool back) {
  std::vector<Past>& from = back ? done_ : undone_;
  std::vector<Past>& to = back ? undone_ : done_;
  // What was drawn anew in between has made the editor forget what it could bring back.
  if (pending_->refused) return from.clear();
  to.push_back(from.back());
  from.pop_back();
  set_kind(back ? to.back().before : to.back().after);
}

/// Which steps undo took back then: those that changed something then, whatever they do today. What changed nothing
/// then and does now goes with the step before it.
void Redrawing::keep_past(const Pending& step, bool changed_then, bool changed_now) {
  if (!changed_then && step.refused && step.done == 0) return;
  if (!changed_then && changed_now && (done_.empty() || done_.back().today < k_most_together)) {
    if (!done_.empty()) done_.back().today += step.done;
    return;
  }
  undone_.clear();
  done_.push_back({step.done, step.kind_before, kind_});
}

void Redrawing::close(std::optional<bool> changed_then, bool changed_now) {
  if (!pending_) return;
  Pending step = *std::exchange(pending_, std::nullopt);
  // What today cannot express is taken for what changed something then.
  if (step.does == Does::change) keep_past(step, changed_then.value_or(!step.refused || step.unknown), changed_now);
  RedrawnStep& out = step.step;
  if (step.refused && changed_then.value_or(step.unknown)) {
    out.came_out = CameOut::not_drawn;
  } else if (out.came_out != CameOut::not_compared) {
    out.reason.clear();
  }
  ++out_.counts[static_cast<std::size_t>(out.came_out)];
  if (out_.steps.size() < k_most_redrawn) out_.steps.push_back(std::move(out));
}

void Redrawing::reached(const document::DocumentState& recorded, const Document& now, std::uint64_t line) {
  const bool changed_then = !(recorded.whole == std::exchange(recorded_, recorded.whole));
  if (!pending_ && changed_then) {
    begin(line, "step", Does::change);
    refuse({"what the session has before this line is no step today", "", ""}, true);
  }
  std::optional<std::vector<std::string_view>> parts;  // of the form in which the fewest differ
  bool equal = false;
  const base::Hash128 before = now_;
  for (std::size_t i = 0; i < hashers_.size() && !equal; ++i) {
    const document::DocumentState state = hashers_[i](now);
    if (i == 0) now_ = state.whole;
    equal = state == recorded;
    auto differing = document::differing_parts(state, recorded);
    if (!parts || differing.size() < parts->size()) parts = std::move(differing);
  }
  if (pending_) {
    RedrawnStep& step = pending_->step;
    step.came_out = equal ? CameOut::equal : CameOut::differently;
    step.parts = *parts;
    for (const std::string_view part : *parts) {
      if (std::find(differing_.begin(), differing_.end(), part) == differing_.end()) step.since.push_back(part);
    }
  }
  differing_ = *std::move(parts);
  close(changed_then, !(now_ == before));
}

RedrawnSession Redrawing::finish() {
  close(std::nullopt, false);
  return std::move(out_);
}

}  // namespace penpose::replay
