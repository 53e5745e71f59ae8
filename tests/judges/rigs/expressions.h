#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace penpose::judges {

/// What a face does that people have a word for: muscles (parts.h) and how much of each.
struct Expression {
  std::string name;
  std::vector<std::pair<std::string, double>> muscles;
};

/// smile, open_smile, frown, surprise, anger, sad, wink_L, blink, jaw_open, pucker, smirk_L, brows_up, brow_up_R,
/// disgust, talk, lips_aside, eyes_wide, laugh, stretch. The smallest controls that make a muscle make it in a known
/// pose.
[[nodiscard]] std::span<const Expression> expressions();

}  // namespace penpose::judges
