#pragma once

#include <cstdint>

namespace penpose::app {

/// Whether a picture is drawn coarsely: while the view moves, where whole pictures came too slowly. Times are
/// microseconds of a clock that never goes back.
class MovingDetail {
 public:
  /// Before a picture is drawn; `moved`: its view is not that of the one before. Whether to draw it coarsely.
  [[nodiscard]] bool begin(bool moved, std::int64_t now_us);
  /// After it.
  void end(std::int64_t now_us);
  /// Whether the last picture is coarse: one more is due when the view rests.
  [[nodiscard]] bool coarse() const { return coarse_; }

  static constexpr std::int64_t k_most_us = 33'000;  ///< of a picture, for 30 a second
  static constexpr int k_slow_pictures = 2;          ///< in a row that took longer
  static constexpr std::int64_t k_rest_us = 80'000;  ///< a view that stays so long rests

 private:
  bool coarse_ = false;
  bool tells_ = false;  ///< the picture being drawn is a whole one of a new view
  int slow_ = 0;
  std::int64_t began_us_ = 0;
  std::int64_t moved_us_ = 0;
};

}  // namespace penpose::app
