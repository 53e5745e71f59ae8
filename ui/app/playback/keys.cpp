#include "ui/app/playback/keys.h"

#include <algorithm>
#include <cmath>

#include "core/document/time/timeline.h"

namespace penpose::app {
namespace {

constexpr double k_same_moment_s = 1e-4;
constexpr double k_at_cursor_s = 1e-9;

}  // namespace

Keys::Keys(EditingSession& editing, Notices& notices, Playback& playback)
    : editing_(editing), notices_(notices), playback_(playback) {}

void Keys::set() { editing_.perform(document::SetKey{playback_.time_s(), name_at(playback_.time_s())}); }

void Keys::remove() { editing_.perform(document::DeleteKey{playback_.time_s()}); }

bool Keys::at_cursor() const {
  const auto& keys = editing_.document().timeline->keys;
  return std::any_of(keys.begin(), keys.end(), [&](const document::PoseKey& key) {
    return std::abs(key.time_s - playback_.time_s()) < k_at_cursor_s;
  });
}

void Keys::copy() {
  clipboard_ = copied_pose(editing_.document(), playback_.time_s());
  notices_.tell("the pose is copied: Paste keys it at another moment");
}

void Keys::paste() {
  if (!clipboard_) return notices_.tell("there is no pose to paste: copy one first");
  paste_pose(editing_, *clipboard_, playback_.time_s());
}

const document::PoseKey* Keys::find(double time_s) const {
  for (const auto& key : editing_.document().timeline->keys) {
    if (std::abs(key.time_s - time_s) < k_same_moment_s) return &key;
  }
  return nullptr;
}

std::string Keys::name_at(double time_s) const {
  const auto* key = find(time_s);
  return key != nullptr ? key->name : std::string();
}

void Keys::name(const std::string& name) {
  const auto* key = find(playback_.time_s());
  if (key == nullptr) return;
  const document::SetKey named{key->time_s, name};
  // A key takes the pose as it is, and the name shall not change the pose.
  if (key->pose != document::SharedPose(editing_.document().pose)) editing_.perform(document::GoToTime{named.time_s});
  editing_.perform(named);
}

void Keys::move(double from_s, double to_s) {
  to_s = std::clamp(to_s, 0.0, document::k_latest_key_s);
  if (std::abs(from_s - to_s) < k_same_moment_s) return;
  if (!editing_.perform(document::MoveKey{from_s, to_s})) return;
  playback_.place_cursor(to_s);
  editing_.shown().preview(std::nullopt);
  editing_.perform(document::GoToTime{to_s});
}

}  // namespace penpose::app
