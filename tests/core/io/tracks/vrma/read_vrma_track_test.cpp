#include <gtest/gtest.h>

#include "core/io/tracks/track_formats.h"
#include "tests/support/models/figure_sample.h"

namespace penpose::io {
namespace {

TEST(ReadVrma, IsKnownByItsBytesAndNamesBonesAndExpressions) {
  const auto bytes = tests::motion_sample(tests::turned_bones()).glb();
  const auto read = read_track(bytes, nullptr, {});
  ASSERT_TRUE(read) << read.error().line();
  EXPECT_EQ(read->format->name, "vrma");
  const auto& motion = std::get<MotionTrack>(read->track);
  ASSERT_EQ(motion.bones.size(), 4U);
  EXPECT_EQ(motion.bones[3].bone, document::HumanBone::left_upper_arm);
  // At rest the normalised rotation of every bone is none, whatever its node's own is.
  for (const BoneMotion& one : motion.bones) {
    EXPECT_NEAR(std::abs(one.rotations.values[3]), 1, 1e-6) << document::name_of(one.bone);
  }
  ASSERT_EQ(motion.expressions.size(), 1U);
  EXPECT_EQ(motion.expressions[0].name, "happy");
  EXPECT_EQ(motion.expressions[0].weights.values, (std::vector<double>{0, 1}));
  EXPECT_NEAR(motion.hips_height, 3, 1e-6) << "2 in an armature that is half as large again";
}

TEST(ReadVrma, FaultsAreNamed) {
  auto sample = tests::motion_sample(tests::upright_bones());
  sample.json["extensions"]["VRMC_vrm_animation"]["specVersion"] = "2.0";
  EXPECT_NE(read_vrma(sample.glb()).error().what.find("2.0"), std::string::npos);
  sample = tests::motion_sample(tests::upright_bones());
  sample.json.erase("animations");
  EXPECT_EQ(read_vrma(sample.glb()).error().place, "/animations");
  sample = tests::motion_sample(tests::upright_bones());
  sample.json["extensions"].erase("VRMC_vrm_animation");
  EXPECT_EQ(read_vrma(sample.glb()).error().place, "/extensions");
  EXPECT_FALSE(read_vrma(tests::morph_sample().glb()));
}

TEST(ReadVrma, AsAModelItIsCalledWhatItIs) {
  auto sample = tests::motion_sample(tests::upright_bones());
  EXPECT_NE(sample.error().what.find("VRM animation"), std::string::npos) << sample.error().line();
}

}  // namespace
}  // namespace penpose::io
