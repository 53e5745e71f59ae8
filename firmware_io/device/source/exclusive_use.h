#pragma once

#include <cstdint>
#include <functional>
#include <optional>

namespace penpose::device {

/// Keeps track of whether a device that others read as well is to be had alone. Only one program can have it: one that
/// is refused asks again and again, and the other may just be about to let go.
class ExclusiveUse {
 public:
  /// Takes it (true) or gives it back (false). False where another program has it.
  using Grab = std::function<bool(bool on)>;

  void want(bool wanted) {
    wanted_ = wanted;
    if (!wanted) refused_since_us_.reset();
  }
  /// Whether it is as wanted.
  [[nodiscard]] bool is_settled() const { return has_ == wanted_; }
  /// Makes it so. To be called only while nothing is held on the device: others would miss either its beginning or its
  /// end.
  void settle(const Grab& grab, std::int64_t now_us) {
    if (is_settled()) return;
    if (grab(wanted_)) {
      has_ = wanted_;
      refused_since_us_.reset();
    } else if (!refused_since_us_) {
      refused_since_us_ = now_us;
    }
  }
  /// Whether another program has had it for longer than letting go takes.
  [[nodiscard]] bool is_refused(std::int64_t now_us) const {
    return refused_since_us_ && now_us - *refused_since_us_ >= k_patience_us;
  }

 private:
  static constexpr std::int64_t k_patience_us = 1'000'000;

  bool wanted_ = false;
  bool has_ = false;
  std::optional<std::int64_t> refused_since_us_;
};

}  // namespace penpose::device
