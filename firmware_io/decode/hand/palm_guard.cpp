#include "firmware_io/decode/hand/palm_guard.h"

#include <algorithm>

namespace penpose::decode {

void PalmGuard::pen(bool near, std::int64_t time_us) {
  if (near_ && !near) left_us_ = time_us;
  near_ = near;
  seen_ = seen_ || near;
}

bool PalmGuard::holds_back(std::int64_t time_us) const { return near_ || (seen_ && time_us - left_us_ < hold_us_); }

std::span<const TouchContact> PalmGuard::let_through(std::span<const TouchContact> contacts, std::int64_t time_us) {
  const auto is_palm = [&](std::uint32_t id) { return std::find(palms_.begin(), palms_.end(), id) != palms_.end(); };
  const auto is_down = [&](std::uint32_t id) {
    return std::any_of(contacts.begin(), contacts.end(), [id](const TouchContact& one) { return one.id == id; });
  };
  std::erase_if(palms_, [&](std::uint32_t id) { return !is_down(id); });
  const bool held = holds_back(time_us);
  through_.clear();
  for (const TouchContact& one : contacts) {
    if (is_palm(one.id)) continue;
    if (held) {
      palms_.push_back(one.id);
    } else {
      through_.push_back(one);
    }
  }
  return through_;
}

void PalmGuard::reset() { *this = PalmGuard(hold_us_); }

}  // namespace penpose::decode
