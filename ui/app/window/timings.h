#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace penpose::app {

/// How long frames and reports took, for measurements.
struct Timings {
  std::string way;  ///< to draw
  std::int64_t began_us = 0;
  std::int64_t first_frame_us = 0;        ///< from the start to the first picture
  std::vector<std::int64_t> frames_us;    ///< CPU time of the main thread for each frame
  std::vector<std::int64_t> posed_us;     ///< those of frames in which the face had moved
  std::vector<std::int64_t> drawn_us;     ///< CPU time of the thread that draws, for each picture
  std::vector<std::int64_t> prepared_us;  ///< the same without handing it over

  /// "name value" lines.
  [[nodiscard]] std::string text() const;
};

/// CPU time of the calling thread.
[[nodiscard]] std::int64_t thread_cpu_us();
/// The value that a share of all is not above; 0 of none.
[[nodiscard]] std::int64_t percentile(std::vector<std::int64_t> values, double share);

}  // namespace penpose::app
