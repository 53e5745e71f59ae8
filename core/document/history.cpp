#include "core/document/history.h"

#include <utility>

namespace penpose::document {

base::Status History::perform(const Command& command, ApplyWorkspace& work) {
  auto changed = apply(current_, command, work);
  if (!changed) return changed.error();
  done_.push_back({name_of(command), std::exchange(current_, std::move(changed).value())});
  undone_.clear();
  return base::Done{};
}

base::Status History::undo() {
  if (done_.empty()) return base::Error{"there is nothing to undo", "", ""};
  Step step = std::move(done_.back());
  done_.pop_back();
  std::swap(current_, step.other);
  undone_.push_back(std::move(step));
  return base::Done{};
}

base::Status History::redo() {
  if (undone_.empty()) return base::Error{"there is nothing to redo", "", ""};
  Step step = std::move(undone_.back());
  undone_.pop_back();
  std::swap(current_, step.other);
  done_.push_back(std::move(step));
  return base::Done{};
}

}  // namespace penpose::document
