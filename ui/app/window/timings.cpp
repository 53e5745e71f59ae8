#include "ui/app/window/timings.h"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace penpose::app {

std::int64_t thread_cpu_us() {
  std::timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1'000'000 + now.tv_nsec / 1000;
}

std::int64_t percentile(std::vector<std::int64_t> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const auto at = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  return values[std::min(values.size() - 1, at == 0 ? 0 : at - 1)];
}

std::string Timings::text() const {
  const auto line = [](const char* name, std::int64_t value) {
    return std::string(name) + " " + std::to_string(value) + "\n";
  };
  return "drawn_by " + way + "\n" + line("first_frame_us", first_frame_us) +
         line("frames", static_cast<std::int64_t>(frames_us.size())) +
         line("frame_cpu_median_us", percentile(frames_us, 0.5)) +
         line("frame_cpu_p99_us", percentile(frames_us, 0.99)) +
         line("posed_frames", static_cast<std::int64_t>(posed_us.size())) +
         line("posed_frame_cpu_median_us", percentile(posed_us, 0.5)) +
         line("posed_frame_cpu_p99_us", percentile(posed_us, 0.99)) +
         line("draw_cpu_median_us", percentile(drawn_us, 0.5)) + line("draw_cpu_p99_us", percentile(drawn_us, 0.99)) +
         line("prepare_cpu_median_us", percentile(prepared_us, 0.5)) +
         line("prepare_cpu_p99_us", percentile(prepared_us, 0.99));
}

}  // namespace penpose::app
