#include <algorithm>
#include <gtest/gtest.h>
#include <set>

#include "tests/judges/cases/gestures.h"
#include "tests/judges/cases/known_faces.h"
#include "tests/judges/cases/limbs.h"

namespace penpose::judges {
namespace {

TEST(JudgesRigs, AreManyAndAThirdIsHeldOut) {
  std::set<std::string> names;
  std::size_t held_out = 0;
  for (const RigMaker& maker : own_rigs()) {
    names.insert(maker.name);
    held_out += maker.group == Group::held_out ? 1U : 0U;
  }
  EXPECT_EQ(names.size(), own_rigs().size());
  EXPECT_GE(names.size(), 16U);
  EXPECT_GE(3 * held_out, names.size());
}

TEST(JudgesRigs, SayNothingThatTheirModelDoesNotHave) {
  for (const RigMaker& maker : own_rigs()) {
    SCOPED_TRACE(maker.name);
    const Rig rig = maker.make();
    EXPECT_EQ(rig.name, maker.name);
    EXPECT_EQ(rig.group, maker.group);
    const auto parameters = rig.model.rig->parameters();
    for (const FaceLine& line : rig.lines) {
      EXPECT_GE(line.vertices.size(), 2U) << line.name;
      for (const std::uint32_t v : line.vertices) EXPECT_LT(v, rig.model.mesh->vertex_count());
    }
    for (const KnownPose& pose : rig.poses) {
      for (const auto& [name, value] : pose.values) {
        const auto i = rig::find_parameter(parameters, name);
        ASSERT_TRUE(i) << pose.name << " " << name;
        EXPECT_TRUE(value >= parameters[*i].minimum && value <= parameters[*i].maximum) << pose.name << " " << name;
      }
    }
    for (const Meaning& meaning : rig.meanings) {
      EXPECT_TRUE(rig::find_parameter(parameters, meaning.control) ||
                  rig::find_parameter(parameters, meaning.control + ".rx"))
          << meaning.control;
    }
  }
}

TEST(JudgesRigs, AreTheSameBitsWhenMadeAgain) {
  for (const RigMaker& maker : own_rigs())
    EXPECT_EQ(document::state_hash(maker.make().model), document::state_hash(maker.make().model)) << maker.name;
}

TEST(JudgesRigs, AreAskedSomethingEach) {
  for (const RigMaker& maker : own_rigs()) {
    const Rig rig = maker.make();
    if (rig.lines.empty()) {
      EXPECT_GE(limbs(rig, Extent::brief).size(), 8U) << maker.name;
      continue;
    }
    const auto faces = known_faces(rig, Extent::brief);
    EXPECT_GE(faces.size(), 20U) << maker.name;
    EXPECT_TRUE(std::any_of(faces.begin(), faces.end(), [&](const KnownFace& f) {
      return f.truth == rig::rest_pose(*rig.model.rig);
    })) << maker.name;
    EXPECT_GE(gestures(rig, Extent::brief).size(), 15U) << maker.name;
  }
}

TEST(JudgesRigs, HaveOneOfManyControlsAndOneOfFewVertices) {
  std::size_t most_controls = 0;
  std::size_t least_vertices = 100000;
  for (const RigMaker& maker : own_rigs()) {
    const Rig rig = maker.make();
    if (rig.lines.empty()) continue;
    most_controls = std::max(most_controls, rig.model.rig->parameters().size());
    least_vertices = std::min(least_vertices, rig.model.mesh->vertex_count());
  }
  EXPECT_GE(most_controls, 150U);
  EXPECT_LE(least_vertices, 600U);
}

}  // namespace
}  // namespace penpose::judges
