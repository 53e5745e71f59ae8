#pragma once

#include <functional>
#include <memory>

namespace penpose::app {

/// While it lives, Ctrl-C and the other ways of asking a program to end wake somebody up and do not end it, so that the
/// session is written to its last line and the window goes as it should. One at a time in a program.
class StopWatch {
 public:
  /// `wake` is called from another thread when the program was asked to end.
  explicit StopWatch(std::function<void()> wake);
  ~StopWatch();
  StopWatch(const StopWatch&) = delete;
  StopWatch& operator=(const StopWatch&) = delete;

  [[nodiscard]] static bool asked();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace penpose::app
