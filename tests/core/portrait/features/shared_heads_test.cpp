#include "tests/core/portrait/shared_heads.h"

#include <gtest/gtest.h>

#include "core/portrait/features/find_features.h"

namespace penpose::portrait {
namespace {

bool is_judged(const std::string& name) {
  return name.starts_with("lip_") || name.starts_with("eyelid_") || name.starts_with("brow_");
}

TEST(SharedHeads, LipsLidsAndBrowsAreWithinThreePercentOrUnsure) {
  if (!tests::has_shared()) GTEST_SKIP() << "no shared data";
  for (const tests::KnownHead& head : tests::known_heads()) {
    const auto whole = intent::measure_whole_model(*head.model.rig);
    std::size_t near = 0;
    for (const FoundCurve& found :
         find_features(*head.model.rig, *head.model.mesh, whole, head.model.front_yaw_degrees)) {
      if (!is_judged(found.curve.name)) continue;
      const double off =
          tests::mean_distance(tests::places_of(found.curve, *whole.rest), head.curves.at(found.curve.name));
      const bool is_near = off < 0.03 * tests::eye_distance(head.curves);
      near += is_near ? 1 : 0;
      EXPECT_TRUE(is_near || found.sureness < k_sure) << head.name << " " << found.curve.name;
    }
    // A head without controls does not tell where its brows are.
    EXPECT_GE(near, head.name == "carry_head.glb" ? 8U : 10U) << head.name;
  }
}

}  // namespace
}  // namespace penpose::portrait
