#include "tests/judges/rigs/random/random_rigs.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "tests/judges/cases/picture.h"

namespace penpose::judges {
namespace {

constexpr std::uint64_t k_seeds = 40;

TEST(JudgesRandomRigs, AreTheSameBitsFromTheSameSeed) {
  std::set<std::string> hashes;
  for (std::uint64_t seed = 0; seed < k_seeds; ++seed) {
    const Rig rig = random_rig(seed);
    const Rig again = random_rig(seed);
    EXPECT_EQ(document::state_hash(rig.model), document::state_hash(again.model)) << seed;
    ASSERT_EQ(rig.poses.size(), again.poses.size());
    for (std::size_t k = 0; k < rig.poses.size(); ++k) EXPECT_EQ(rig.poses[k].values, again.poses[k].values);
    hashes.insert(document::state_hash(rig.model).hex());
  }
  EXPECT_EQ(hashes.size(), k_seeds);
}

TEST(JudgesRandomRigs, SayNothingThatTheirModelDoesNotHave) {
  for (std::uint64_t seed = 0; seed < k_seeds; ++seed) {
    const Rig rig = random_rig(seed);
    SCOPED_TRACE(rig.name + ": " + rig.kind);
    EXPECT_EQ(rig.name, "random_" + std::to_string(seed));
    const auto parameters = rig.model.rig->parameters();
    EXPECT_GE(parameters.size(), 5U);
    for (const char* name : {"lip_upper", "lip_lower", "brow_L", "brow_R", "eyelid_upper_L", "eyelid_upper_R"}) {
      const FaceLine* line = rig.line(name);
      ASSERT_TRUE(line) << name;
      EXPECT_GE(line->vertices.size(), 3U) << name;
      for (const std::uint32_t v : line->vertices) EXPECT_LT(v, rig.model.mesh->vertex_count());
    }
    EXPECT_GE(rig.poses.size(), 10U);
    for (const KnownPose& pose : rig.poses) {
      std::set<std::string> named;
      for (const auto& [name, value] : pose.values) {
        const auto i = rig::find_parameter(parameters, name);
        ASSERT_TRUE(i) << pose.name << " " << name;
        EXPECT_TRUE(value >= parameters[*i].minimum && value <= parameters[*i].maximum) << pose.name << " " << name;
        EXPECT_TRUE(named.insert(name).second) << pose.name << " " << name;
      }
    }
    for (const Meaning& meaning : rig.meanings) {
      EXPECT_TRUE(rig::find_parameter(parameters, meaning.control) ||
                  rig::find_parameter(parameters, meaning.control + ".rx"))
          << meaning.control;
    }
  }
}

TEST(JudgesRandomRigs, StayFinite) {
  for (std::uint64_t seed = 0; seed < k_seeds; ++seed) {
    const Rig rig = random_rig(seed);
    SCOPED_TRACE(rig.name + ": " + rig.kind);
    for (const double share : {0.0, 1.0}) {
      rig::Pose pose = rig::rest_pose(*rig.model.rig);
      for (std::size_t i = 0; i < pose.size(); ++i) {
        const rig::Parameter& parameter = rig.model.rig->parameters()[i];
        pose[i] = parameter.minimum + share * (parameter.maximum - parameter.minimum);
      }
      const auto places = posed(rig.model, pose);
      EXPECT_TRUE(std::all_of(places.begin(), places.end(), [](const ModelPoint& p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
      }));
    }
  }
}

}  // namespace
}  // namespace penpose::judges
