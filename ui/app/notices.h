#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace penpose::app {

/// Something that is said for a while.
struct Notice {
  std::string text;
  bool is_error = false;
  std::int64_t until_us = 0;
};

/// What is said to the user, newest last.
class Notices {
 public:
  /// Microseconds of a clock that never goes back.
  using Clock = std::function<std::int64_t()>;

  /// `fades`: what was said long enough goes little by little, else at once.
  explicit Notices(Clock clock, bool fades = true) : clock_(std::move(clock)), fades_(fades) {}

  /// Says it again where it is said already.
  void tell(std::string text, bool is_error = false);
  /// Takes away what a test of a notice is true of.
  template <typename Test>
  void take_away(const Test& test) {
    std::erase_if(all_, test);
  }
  /// Something hides it: what is said now stays its full time from here on.
  void wait();
  /// Takes away what was said long enough.
  void expire();
  [[nodiscard]] const std::vector<Notice>& all() const { return all_; }
  /// How much of it is still seen, 0 to 1.
  [[nodiscard]] double opacity(const Notice& notice) const;
  /// Milliseconds until one of them begins to fade, or of the next frame while one does; -1: nothing is said.
  [[nodiscard]] int next_frame_ms() const;

 private:
  Clock clock_;
  bool fades_;
  std::vector<Notice> all_;
};

}  // namespace penpose::app
