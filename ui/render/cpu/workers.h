#pragma once

#include <functional>
#include <memory>

namespace penpose::render {

/// Threads that share work on pictures, this one among them. Without a second processor, or where the program may not
/// start threads, this one does all of it.
class Workers {
 public:
  /// `most`: threads in all, at least 1.
  explicit Workers(unsigned most);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Calls `work(index, worker)` for each index below `count`, in any order; `worker` counts the threads from 0. Comes
  /// back when all is done. `work` must not throw.
  void share(int count, const std::function<void(int index, unsigned worker)>& work);
  [[nodiscard]] unsigned count() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace penpose::render
