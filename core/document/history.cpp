#include "core/document/history.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace penpose::document {

namespace {

/// Empties a list that is another's copy, and says whether it is.
template <typename List>
bool taken_out(List& list, const List& copied_from) {
  if (!(list == copied_from)) return false;
  List().swap(list);
  return true;
}

}  // namespace

void History::Step::take_out(const Document& neighbour) {
  auto& own = other.curves;
  const auto& there = neighbour.curves;
  const auto front = std::mismatch(own.begin(), own.end(), there.begin(), there.end());
  // Not counted twice where a curve was added or taken away between the two.
  const auto back = std::mismatch(own.rbegin(), std::make_reverse_iterator(front.first), there.rbegin(),
                                  std::make_reverse_iterator(front.second));
  first_curves = static_cast<std::size_t>(front.first - own.begin());
  last_curves = static_cast<std::size_t>(back.first - own.rbegin());
  own = std::vector(front.first, back.first.base());
  same_pose = taken_out(other.pose, neighbour.pose);
  same_locks = taken_out(other.locked, neighbour.locked);
  same_views = taken_out(other.views, neighbour.views);
}

void History::Step::put_back(const Document& neighbour) {
  const auto& there = neighbour.curves;
  auto& own = other.curves;
  own.insert(own.begin(), there.begin(), there.begin() + static_cast<std::ptrdiff_t>(first_curves));
  own.insert(own.end(), there.end() - static_cast<std::ptrdiff_t>(last_curves), there.end());
  if (same_pose) other.pose = neighbour.pose;
  if (same_locks) other.locked = neighbour.locked;
  if (same_views) other.views = neighbour.views;
}

base::Status History::perform(const Command& command, ApplyWorkspace& work) {
  auto changed = apply(current_, command, work);
  if (!changed) return changed.error();
  Step step{name_of(command), std::exchange(current_, std::move(changed).value())};
  step.take_out(current_);
  done_.push_back(std::move(step));
  undone_.clear();
  return base::Done{};
}

base::Status History::undo() {
  if (done_.empty()) return base::Error{"there is nothing to undo", "", ""};
  Step step = std::move(done_.back());
  done_.pop_back();
  step.put_back(current_);
  std::swap(current_, step.other);
  step.take_out(current_);
  undone_.push_back(std::move(step));
  return base::Done{};
}

base::Status History::redo() {
  if (undone_.empty()) return base::Error{"there is nothing to redo", "", ""};
  Step step = std::move(undone_.back());
  undone_.pop_back();
  step.put_back(current_);
  std::swap(current_, step.other);
  step.take_out(current_);
  done_.push_back(std::move(step));
  return base::Done{};
}

}  // namespace penpose::document
