#include "core/speech/mouth_keys.h"

#include <algorithm>
#include <cmath>

#include "core/document/time/timeline.h"
#include "core/phonetics/nine_mouths.h"

namespace penpose::speech {
namespace {

/// A mouth on frames, from when it is there to when it begins to go.
struct Held {
  std::int64_t from = 0, to = 0;
  const std::string* mouth = nullptr;
  bool meets = false;
};

bool meets(const std::string& mouth) { return mouth == name_of(NineMouth::closed) || mouth == name_of(NineMouth::f); }

/// Takes away the frames on which lips that meet are there; false where none are left.
bool give_way(Held& one, const std::vector<Held>& meeting) {
  for (const Held& other : meeting) {
    if (other.to < one.from || other.from > one.to) continue;
    if (other.from > one.from) {
      one.to = other.from - 1;
    } else {
      one.from = other.to + 1;
    }
  }
  return one.from <= one.to;
}

std::vector<Held> held_mouths(const Cues& cues, const KeyOptions& options) {
  constexpr double k_last = document::k_latest_key_s;
  const auto frame = [&](double time_s) {
    return static_cast<std::int64_t>(
        std::floor(std::clamp(time_s + options.offset_s, 0.0, k_last) * options.fps + 1e-6));
  };
  std::vector<Held> meeting;
  for (std::size_t i = 0; i < cues.size(); ++i) {
    if (!meets(cues[i].mouth)) continue;
    const double end = i + 1 < cues.size() ? cues[i + 1].time_s : cues[i].time_s;
    Held one{frame(cues[i].time_s), 0, &cues[i].mouth, true};
    one.to = std::max(one.from + 1, frame(end));
    if (!meeting.empty() && one.from <= meeting.back().to) {
      if (one.from <= meeting.back().from + 1) one.from = meeting.back().from + 2;
      meeting.back().to = one.from - 1;
      one.to = std::max(one.to, one.from + 1);
    }
    meeting.push_back(one);
  }
  std::vector<Held> all = meeting;
  for (std::size_t i = 0; i < cues.size(); ++i) {
    if (meets(cues[i].mouth)) continue;
    Held one{frame(cues[i].time_s - options.lead_s), 0, &cues[i].mouth, false};
    const bool last = i + 1 == cues.size();
    one.to = last ? one.from : std::max(one.from, frame(cues[i + 1].time_s - options.lead_s) - 1);
    if (give_way(one, meeting)) all.push_back(one);
  }
  std::stable_sort(all.begin(), all.end(), [](const Held& a, const Held& b) { return a.from < b.from; });
  return all;
}

}  // namespace

document::SpokenMouths mouth_keys(const Cues& cues, const KeyOptions& options) {
  const std::vector<Held> all = held_mouths(cues, options);
  document::SpokenMouths keys;
  const auto add = [&](std::int64_t frame, const std::string& mouth) {
    const double time = static_cast<double>(frame) / options.fps;
    if (time <= document::k_latest_key_s && (keys.empty() || keys.back().time_s < time)) keys.push_back({time, mouth});
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Held& one = all[i];
    add(one.from, *one.mouth);
    // Lips that meet stay as long as they do; other mouths until they are on their way.
    const std::int64_t next = i + 1 < all.size() ? all[i + 1].from : one.to;
    const std::int64_t leaves = one.meets ? std::min(one.to, next - 1) : std::min(one.to, next - k_change_frames);
    if (leaves > one.from && i + 1 < all.size()) add(leaves, *one.mouth);
  }
  return keys;
}

}  // namespace penpose::speech
