#pragma once

#include <string>
#include <vector>

#include "tests/judges/shared/shared_cases.h"

namespace penpose::judges {

/// A face of a kind that fails on other rigs: some shapes of the shared avatar, sums of others and mouths that go up
/// and down as a whole, with the gestures that such a rig reads otherwise.
struct Kind {
  std::string name;
  document::Model model;
  std::vector<Gesture> gestures;
};

/// kiss_or_ooh, open_or_surprise, small_smile, few_shapes, mouth_up, no_brow_shape.
[[nodiscard]] std::vector<std::string> kind_names();
/// Precondition: the name is one of those; the shared data is there.
[[nodiscard]] Kind make_kind(const std::string& name);

}  // namespace penpose::judges
