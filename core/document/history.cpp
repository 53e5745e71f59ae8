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

/// What a list has in the middle that a neighbour's has not, and how many at the front and at the end are the same.
template <typename List>
List middle_of(const List& own, const List& there, std::size_t& first, std::size_t& last) {
  const auto front = std::mismatch(own.begin(), own.end(), there.begin(), there.end());
  // Not counted twice where one was added or taken away between the two.
  const auto back = std::mismatch(own.rbegin(), std::make_reverse_iterator(front.first), there.rbegin(),
                                  std::make_reverse_iterator(front.second));
  first = static_cast<std::size_t>(front.first - own.begin());
  last = static_cast<std::size_t>(back.first - own.rbegin());
  return List(front.first, back.first.base());
}

/// Puts around a middle what it has in common with a neighbour.
template <typename List>
void complete(List& own, const List& there, std::size_t first, std::size_t last) {
  own.insert(own.begin(), there.begin(), there.begin() + static_cast<std::ptrdiff_t>(first));
  own.insert(own.end(), there.end() - static_cast<std::ptrdiff_t>(last), there.end());
}

}  // namespace

void History::Step::take_out(const Document& neighbour) {
  other.curves = middle_of(other.curves, neighbour.curves, first_curves, last_curves);
  timeline = {};
  same_timeline = other.timeline == neighbour.timeline;
  if (!same_timeline) {
    timeline.keys = middle_of(other.timeline->keys, neighbour.timeline->keys, first_keys, last_keys);
  }
  // Held by nobody else, an old timeline goes.
  other.timeline.reset();
  same_pose = taken_out(other.pose, neighbour.pose);
  same_locks = taken_out(other.locked, neighbour.locked);
  same_views = taken_out(other.views, neighbour.views);
}

void History::Step::put_back(const Document& neighbour) {
  complete(other.curves, neighbour.curves, first_curves, last_curves);
  if (same_timeline) {
    other.timeline = neighbour.timeline;
  } else {
    complete(timeline.keys, neighbour.timeline->keys, first_keys, last_keys);
    other.timeline = std::make_shared<const Timeline>(std::move(timeline));
  }
  if (same_pose) other.pose = neighbour.pose;
  if (same_locks) other.locked = neighbour.locked;
  if (same_views) other.views = neighbour.views;
}

base::Status History::perform(const Command& command, ApplyWorkspace& work) {
  auto changed = apply(current_, command, work);
  if (!changed) return changed.error();
  Step step;
  step.command = called(command);
  step.other = std::exchange(current_, std::move(changed).value());
  step.take_out(current_);
  done_.push_back(std::move(step));
  undone_.clear();
  return base::Done{};
}

void History::cross(std::vector<Step>& from, std::vector<Step>& to) {
  Step step = std::move(from.back());
  from.pop_back();
  step.put_back(current_);
  std::swap(current_, step.other);
  step.take_out(current_);
  to.push_back(std::move(step));
}

base::Status History::undo() {
  if (done_.empty()) return base::Error{"there is nothing to undo", "", ""};
  cross(done_, undone_);
  return base::Done{};
}

base::Status History::redo() {
  if (undone_.empty()) return base::Error{"there is nothing to redo", "", ""};
  cross(undone_, done_);
  return base::Done{};
}

}  // namespace penpose::document
