#include "ui/app/notices.h"

#include <algorithm>
#include <utility>

#include "ui/app/view/toast_place.h"

namespace penpose::app {
namespace {

constexpr std::int64_t k_notice_us = 4'000'000;
constexpr std::size_t k_most_notices = 4;
constexpr int k_fading_frame_ms = 32;

}  // namespace

void Notices::tell(std::string text, bool is_error) {
  const std::int64_t until = clock_() + k_notice_us;
  std::erase_if(all_, [&](const Notice& one) { return one.text == text; });
  all_.push_back({std::move(text), is_error, until});
  if (all_.size() > k_most_notices) all_.erase(all_.begin());
}

void Notices::wait() {
  const std::int64_t until = clock_() + k_notice_us;
  for (Notice& one : all_) one.until_us = until;
}

void Notices::expire() {
  const std::int64_t now = clock_();
  std::erase_if(all_, [&](const Notice& one) { return one.until_us <= now; });
}

double Notices::opacity(const Notice& notice) const {
  if (!fades_) return 1;
  return std::clamp(static_cast<double>(notice.until_us - clock_()) * 1e-6 / k_fade_s, 0.0, 1.0);
}

int Notices::next_frame_ms() const {
  if (all_.empty()) return -1;
  std::int64_t first = all_.front().until_us;
  for (const Notice& one : all_) first = std::min(first, one.until_us);
  // From then on it fades, or is gone.
  const std::int64_t fades = first - (fades_ ? static_cast<std::int64_t>(k_fade_s * 1e6) : 0);
  const std::int64_t now = clock_();
  if (fades <= now) return k_fading_frame_ms;
  return static_cast<int>(std::max<std::int64_t>(1, (fades - now) / 1000 + 1));
}

}  // namespace penpose::app
