#include "tests/judges/cases/random_gestures.h"

#include <gtest/gtest.h>
#include <set>

#include "tests/judges/rigs/control_words.h"
#include "tests/judges/rigs/random/random_rigs.h"

namespace penpose::judges {
namespace {

TEST(JudgesRandomGestures, AreTheSameFromTheSameSeedAndUnlikeOtherwise) {
  const Rig rig = random_rig(2);
  const auto first = random_gestures(rig, 7, 40);
  const auto again = random_gestures(rig, 7, 40);
  const auto other = random_gestures(rig, 8, 40);
  ASSERT_EQ(first.size(), 40U);
  ASSERT_EQ(again.size(), 40U);
  std::size_t unlike = 0;
  for (std::size_t k = 0; k < first.size(); ++k) {
    EXPECT_EQ(first[k].asked.name, again[k].asked.name);
    EXPECT_EQ(first[k].needed, again[k].needed);
    ASSERT_EQ(first[k].asked.references.size(), again[k].asked.references.size());
    for (std::size_t r = 0; r < first[k].asked.references.size(); ++r)
      EXPECT_EQ(first[k].asked.references[r].target, again[k].asked.references[r].target);
    unlike += first[k].asked.name != other[k].asked.name ? 1U : 0U;
  }
  EXPECT_GE(unlike, 30U);
}

TEST(JudgesRandomGestures, AskForControlsOfTheRig) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Rig rig = random_rig(seed);
    SCOPED_TRACE(rig.name + ": " + rig.kind);
    const auto gestures = random_gestures(rig, 1, 20);
    EXPECT_GE(gestures.size(), 15U);
    std::set<std::string> names;
    for (const Gesture& gesture : gestures) {
      EXPECT_TRUE(names.insert(gesture.asked.name).second) << gesture.asked.name;
      EXPECT_FALSE(gesture.asked.references.empty());
      EXPECT_NE(gesture.needed.empty(), !gesture.still_is_right) << gesture.asked.name;
      for (const auto& group : gesture.needed) {
        EXPECT_FALSE(group.empty()) << gesture.asked.name;
        for (const std::string& control : group)
          EXPECT_TRUE(rig::find_parameter(rig.model.rig->parameters(), control) ||
                      rig::find_parameter(rig.model.rig->parameters(), control + ".rx"))
              << control;
      }
    }
  }
}

}  // namespace
}  // namespace penpose::judges
