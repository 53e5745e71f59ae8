#include <gtest/gtest.h>

#include "tests/support/models/gltf_sample.h"

namespace penpose::io {
namespace {

TEST(GltfExpressions, OfBothVersionsAreBlendShapes) {
  for (const bool first : {true, false}) {
    auto sample = tests::morph_sample();
    if (first) {
      sample.json["extensions"]["VRM"]["blendShapeMaster"]["blendShapeGroups"] = {
          {{"name", "Joy"}, {"presetName", "joy"}, {"binds", {{{"mesh", 0}, {"index", 0}, {"weight", 50}}}}},
          {{"name", "Nothing"}, {"binds", {{{"mesh", 7}, {"index", 0}, {"weight", 50}}, {{"mesh", 0}, {"index", 9}}}}}};
    } else {
      sample.json["extensions"]["VRMC_vrm"]["expressions"] = {
          {"preset", {{"Joy", {{"morphTargetBinds", {{{"node", 0}, {"index", 0}, {"weight", 0.5}}}}}}}},
          {"custom", {{"lift", {{"morphTargetBinds", {{{"node", 0}, {"index", 0}}}}}}, {"odd", 3}}}};
    }
    sample.json["extensionsUsed"] = {first ? "VRM" : "VRMC_vrm"};
    const auto model = sample.read();
    ASSERT_TRUE(model.ok()) << model.error().line();
    ASSERT_EQ(model->shapes->shapes().size(), 2U);
    const auto& joy = model->shapes->shapes()[1];
    EXPECT_EQ(joy.parameter.name, "Joy");
    ASSERT_EQ(joy.vertices, (std::vector<std::uint32_t>{2}));
    EXPECT_FLOAT_EQ(joy.deltas[0].z, 0.25F);
    EXPECT_EQ(model->pose, (rig::Pose{0.25, 0}));
    EXPECT_EQ(model->notes.size(), first ? 3U : 1U);  // "lift" is a target's name already; "Nothing" has bad binds
  }
}

TEST(GltfExpressions, BindsThatNameNothingAreNoted) {
  auto sample = tests::morph_sample();
  sample.json["extensions"]["VRMC_vrm"]["expressions"]["preset"] = {
      {"happy",
       {{"morphTargetBinds",
         {{{"node", 77}, {"index", 0}}, {{"node", 0}, {"index", 9}}, {{"index", 0}}, {{"node", 0}, {"index", 0}}}}}},
      {"sad", {{"morphTargetBinds", {{{"node", 0}, {"index", 1}}}}}},
      {"neutral", {{"morphTargetBinds", nlohmann::json::array()}}}};
  sample.json["extensionsUsed"] = {"VRMC_vrm"};
  const auto model = sample.read().value();
  ASSERT_EQ(model.shapes->shapes().size(), 2U);
  EXPECT_EQ(model.shapes->shapes()[1].parameter.name, "happy");
  EXPECT_EQ(model.notes, (std::vector<std::string>{
                             "expression happy: bind 0 is left out: node 77 is not there or shows nothing",
                             "expression happy: bind 1 is left out: node 0 has no morph target 9",
                             "expression happy: bind 2 is left out: it names no node",
                             "expression sad: bind 0 is left out: node 0 has no morph target 1",
                             "expression sad is left out: it moves no vertex",
                         }));
}

}  // namespace
}  // namespace penpose::io
