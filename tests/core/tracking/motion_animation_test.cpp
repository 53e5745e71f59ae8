#include "core/tracking/motion_animation.h"

#include <gtest/gtest.h>

#include "core/document/humanoid_rest.h"
#include "core/document/time/animation_sampling.h"
#include "core/geometry/rotation.h"
#include "core/io/gltf/write/write_vrma.h"
#include "core/io/tracks/track_formats.h"
#include "core/tracking/animate.h"
#include "tests/support/models/figure_sample.h"

namespace penpose::tracking {
namespace {

using document::HumanBone;

constexpr std::array k_bones{HumanBone::hips, HumanBone::spine, HumanBone::head, HumanBone::left_upper_arm};

glm::dmat3 turn_of(const glm::dmat4& matrix) {
  glm::dmat3 turn(matrix);
  for (int c = 0; c < 3; ++c) turn[c] = geometry::normalized(turn[c]);
  return turn;
}

/// How far a bone has turned from rest in the world, and where it is.
struct Seen {
  glm::dmat3 turn{1};
  geometry::ModelPoint place{0};
};

Seen seen(const document::Model& model, const document::Humanoid& humanoid, HumanBone bone, double time_s) {
  const auto moment = document::sample(model, model.animations.front(), time_s);
  const auto joints = model.skeleton->joints();
  std::vector<glm::dmat4> now;
  std::vector<glm::dmat4> rest;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const auto& at = moment.joints[j];
    now.push_back(geometry::compose(at.translation, at.rotation, at.scale));
    rest.push_back(geometry::compose(joints[j].translation, joints[j].rest_rotation, joints[j].scale));
    if (joints[j].parent < 0) continue;
    now.back() = now[static_cast<std::size_t>(joints[j].parent)] * now.back();
    rest.back() = rest[static_cast<std::size_t>(joints[j].parent)] * rest.back();
  }
  const std::size_t joint = *humanoid.joint(bone);
  return {turn_of(now[joint]) * glm::transpose(turn_of(rest[joint])), geometry::ModelPoint(now[joint][3])};
}

void expect_same(const glm::dmat3& a, const glm::dmat3& b, const std::string& what) {
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) EXPECT_NEAR(a[c][r], b[c][r], 2e-6) << what;
  }
}

document::Model animated(tests::GltfSample avatar, tests::GltfSample motion, document::Humanoid& humanoid) {
  document::Model model = avatar.read().value();
  humanoid = model.humanoid;
  auto played = animate_motion(model, io::read_vrma(motion.glb()).value());
  EXPECT_TRUE(played) << played.error().line();
  model.animations = {std::move(played->animation)};
  return model;
}

TEST(MotionAnimation, EveryFigureTurnsAlikeWhateverItsNodesDoAtRest) {
  document::Humanoid plain;
  document::Humanoid turned;
  const auto motion = tests::motion_sample(tests::turned_bones());
  const auto a = animated(tests::avatar_sample(tests::upright_bones()), motion, plain);
  const auto b = animated(tests::avatar_sample(tests::turned_bones()), motion, turned);
  for (const double time : {0.0, 0.4, 1.0}) {
    for (const HumanBone bone : k_bones) {
      expect_same(seen(a, plain, bone, time).turn, seen(b, turned, bone, time).turn,
                  std::string(document::name_of(bone)) + " at " + std::to_string(time));
    }
    // The same file as a figure of half its height: hips 1.5 above ground, not 3.
    const auto low = seen(a, plain, HumanBone::hips, time).place;
    const auto high = seen(b, turned, HumanBone::hips, time).place;
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(low[axis] * 2, high[axis], 1e-5);
  }
  EXPECT_GT(std::abs(seen(a, plain, HumanBone::head, 1).turn[0][0] - 1), 0.1) << "it moves at all";
}

TEST(MotionAnimation, AnAvatarOfVrm0LooksTheOtherWay) {
  auto old = tests::avatar_sample(tests::upright_bones());
  const auto bones = old.json["extensions"]["VRMC_vrm"]["humanoid"]["humanBones"];
  nlohmann::json listed = nlohmann::json::array();
  for (const auto& [name, bone] : bones.items()) listed.push_back({{"bone", name}, {"node", bone["node"]}});
  old.json["extensions"] = {{"VRM", {{"humanoid", {{"humanBones", listed}}}}}};
  old.json["extensionsUsed"] = {"VRM"};
  document::Humanoid humanoid;
  document::Humanoid old_humanoid;
  const auto motion = tests::motion_sample(tests::upright_bones());
  const auto a = animated(tests::avatar_sample(tests::upright_bones()), motion, humanoid);
  const auto b = animated(old, motion, old_humanoid);
  EXPECT_EQ(b.front_yaw_degrees, 180);
  // About y the same, about x and z the other way round.
  const glm::dmat3 back{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
  for (const HumanBone bone : k_bones) {
    expect_same(back * seen(a, humanoid, bone, 1).turn * back, seen(b, old_humanoid, bone, 1).turn,
                std::string(document::name_of(bone)));
  }
}

TEST(MotionAnimation, ABoneThatTheModelLacksTurnsThoseBelowIt) {
  auto motion = tests::motion_sample(tests::upright_bones());
  auto& bones = motion.json["extensions"]["VRMC_vrm_animation"]["humanoid"]["humanBones"];
  auto whole = tests::avatar_sample(tests::upright_bones());
  auto lacking = whole;
  // What was the spine is the upper chest of the motion, which one avatar has and the other lacks.
  bones["upperChest"] = bones["spine"];
  bones.erase("spine");
  for (tests::GltfSample* one : {&whole, &lacking}) {
    auto& own = one->json["extensions"]["VRMC_vrm"]["humanoid"]["humanBones"];
    if (one == &whole) own["upperChest"] = own["spine"];
    own.erase("spine");
  }
  document::Humanoid with;
  document::Humanoid without;
  const auto a = animated(whole, motion, with);
  const auto b = animated(lacking, motion, without);
  expect_same(seen(a, with, HumanBone::head, 1).turn, seen(b, without, HumanBone::head, 1).turn, "head");
}

TEST(MotionAnimation, ExpressionsMoveTheirTargets) {
  const auto bytes = tests::avatar_sample(tests::upright_bones()).glb();
  auto read = io::read_track(tests::motion_sample(tests::turned_bones()).glb(), nullptr, {}).value();
  const auto map = io::read_bundled_map(*read.format).value();
  const auto document = document::make_document(io::read_gltf(bytes).value());
  const auto done = animate(document, std::move(read.track), map, {});
  ASSERT_TRUE(done) << done.error().line();
  EXPECT_EQ(done->times_s, (std::vector<double>{0, 1}));
  EXPECT_EQ(done->poses[1][0], 0.5) << "happy is a half of the target";
  EXPECT_TRUE(done->unmatched.empty());
}

TEST(MotionAnimation, AMotionThatMovesNothingOfTheModelIsAnError) {
  const auto played = animate_motion(tests::square_sample().read().value(),
                                     io::read_vrma(tests::motion_sample(tests::upright_bones()).glb()).value());
  ASSERT_FALSE(played);
  EXPECT_NE(played.error().what.find("4 bones"), std::string::npos);
}

TEST(MotionAnimation, WrittenAgainItIsTheSameMotion) {
  document::Humanoid humanoid;
  const auto motion = tests::motion_sample(tests::turned_bones());
  const auto model = animated(tests::avatar_sample(tests::turned_bones()), motion, humanoid);
  const auto written = io::write_vrma(model);
  ASSERT_TRUE(written) << written.error().line();
  EXPECT_TRUE(written->notes.empty()) << written->notes.front();
  const auto read = io::read_vrma(written->bytes);
  ASSERT_TRUE(read) << read.error().line();
  document::Model again = model;
  again.animations = {animate_motion(model, *read).value().animation};
  for (const double time : {0.0, 0.3, 1.0}) {
    for (const HumanBone bone : k_bones) {
      const Seen one = seen(model, humanoid, bone, time);
      const Seen two = seen(again, humanoid, bone, time);
      expect_same(one.turn, two.turn, std::string(document::name_of(bone)));
      for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(one.place[axis], two.place[axis], 1e-5);
    }
    EXPECT_NEAR(document::sample(model, model.animations[0], time).weights[0],
                document::sample(again, again.animations[0], time).weights[0], 1e-6);
  }
}

TEST(MotionAnimation, AFaceWithoutExpressionsIsWrittenByItsControls) {
  auto model = tests::morph_sample().read().value();
  model.pose[0] = 0.75;
  const auto written = io::write_vrma(model);
  ASSERT_TRUE(written) << written.error().line();
  const auto read = io::read_vrma(written->bytes).value();
  ASSERT_EQ(read.expressions.size(), 1U);
  EXPECT_EQ(read.expressions[0].name, "lift");
  EXPECT_EQ(read.expressions[0].weights.values, std::vector<double>{0.75});
  model.pose[0] = 0;
  EXPECT_NE(io::write_vrma(model).error().what.find("neither"), std::string::npos);
}

TEST(MotionAnimation, AShapeThatNothingDrivesStaysAsTheFileHasIt) {
  const auto avatar = tests::avatar_sample(tests::upright_bones()).glb();
  const auto document = document::make_document(io::read_gltf(avatar).value());
  ASSERT_EQ(document.pose[0], 0.25);
  const auto still = [&](base::Bytes bytes) {
    auto read = io::read_track(bytes, nullptr, {}).value();
    const auto map = io::read_bundled_map(*read.format).value();
    AnimateOptions options;
    options.apply_head = true;
    const auto done = animate(document, std::move(read.track), map, options);
    ASSERT_TRUE(done) << done.error().line();
    EXPECT_EQ(done->document.pose[0], 0.25);
    for (const rig::Pose& pose : done->poses) EXPECT_EQ(pose[0], 0.25);
  };
  still(base::as_bytes(std::string_view("Timecode,BlendShapeCount,HeadYaw\n0:0:0:0,1,0\n0:0:0:1,1,0.2\n")));
  tests::GltfSample motion = tests::motion_sample(tests::turned_bones());
  motion.json["extensions"]["VRMC_vrm_animation"]["expressions"]["preset"].clear();
  still(motion.glb());
}

TEST(MotionAnimation, JointsThatNothingTurnsKeepTheirPose) {
  constexpr std::string_view take = "Timecode,BlendShapeCount,Joy\n0:0:0:0,1,0.5\n0:0:0:1,1,1\n";
  auto document = document::make_document(tests::avatar_sample(tests::upright_bones()).read().value());
  const std::size_t arm = document.pose.size() - 1;
  document.pose[arm] = 0.5;
  auto read = io::read_track(base::as_bytes(take), nullptr, {}).value();
  const auto map = io::read_bundled_map(*read.format).value();
  const auto done = animate(document, std::move(read.track), map);
  ASSERT_TRUE(done) << done.error().line();
  EXPECT_EQ(done->document.pose[arm], 0.5);
  EXPECT_EQ(done->document.model->pose[arm], 0.5);
}

TEST(MotionAnimation, ColumnsOfATrackThatNameExpressionsDriveTheirTargets) {
  constexpr std::string_view take = "Timecode,BlendShapeCount,Joy,TongueOut\n0:0:0:0,2,0.5,0\n0:0:0:1,2,1,0\n";
  const auto document = document::make_document(tests::avatar_sample(tests::upright_bones()).read().value());
  auto read = io::read_track(base::as_bytes(take), nullptr, {}).value();
  const auto map = io::read_bundled_map(*read.format).value();
  const auto done = animate(document, std::move(read.track), map);
  ASSERT_TRUE(done) << done.error().line();
  EXPECT_EQ(done->poses[0][0], 0.25) << "Joy is what VRM 0.x calls happy";
  EXPECT_EQ(done->poses[1][0], 0.5);
  EXPECT_EQ(done->unmatched, std::vector<std::string>{"TongueOut"});
}

}  // namespace
}  // namespace penpose::tracking
