#pragma once

#include <functional>
#include <memory>

#include "core/base/interface.h"

namespace penpose::render {

/// Threads that share work on pictures, this one among them. Without a second processor, or where the program may not
/// start threads, this one does all of it.
class Workers : base::Fixed {
 public:
  /// `most`: threads in all, at least 1.
  explicit Workers(unsigned most);
  ~Workers();

  /// Calls `work(index, worker)` for each index below `count`, in any order; `worker` counts the threads from 0. Comes
  /// back when all is done. `work` must not throw.
  void share(int count, const std::function<void(int index, unsigned worker)>& work);
  [[nodiscard]] unsigned count() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace penpose::render
