#include <gtest/gtest.h>

#include "core/io/model/write_model.h"
#include "tests/support/models/gltf_sample.h"

namespace penpose::io {
namespace {

using Values = std::vector<std::pair<std::size_t, double>>;

TEST(GltfExpressions, OfBothVersionsArePosesOfTheirTargets) {
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
    ASSERT_EQ(model->shapes->shapes().size(), 1U) << "no second control for the same target";
    EXPECT_EQ(model->pose, rig::Pose{0.25});
    ASSERT_EQ(model->expressions.size(), first ? 1U : 2U);
    EXPECT_EQ(model->expressions[0].name, "Joy");
    EXPECT_EQ(model->expressions[0].values, (Values{{0, 0.5}}));
    EXPECT_EQ(model->front_yaw_degrees, first ? 180 : 0);
    EXPECT_EQ(model->notes.size(), first ? 3U : 0U);  // "Nothing" and its two binds
  }
}

TEST(GltfExpressions, KeepHowTheyAreShown) {
  auto sample = tests::morph_sample();
  sample.json["extensions"]["VRMC_vrm"]["expressions"]["preset"]["happy"] = {
      {"morphTargetBinds", {{{"node", 0}, {"index", 0}, {"weight", 0.5}}}},
      {"isBinary", true},
      {"overrideMouth", "block"},
      {"overrideBlink", "blend"},
      {"overrideLookAt", "none"}};
  sample.json["extensionsUsed"] = {"VRMC_vrm"};
  const auto model = sample.read().value();
  // In a file that is no avatar they are kept, too.
  auto bare = model;
  bare.source = nullptr;
  const auto again = read_gltf(write_glb(bare).value()).value();
  for (const auto* one : {&model, &again}) {
    ASSERT_EQ(one->expressions.size(), 1U);
    EXPECT_TRUE(one->expressions[0].is_binary);
    EXPECT_EQ(one->expressions[0].mouth, document::ExpressionOverride::block);
    EXPECT_EQ(one->expressions[0].blink, document::ExpressionOverride::blend);
    EXPECT_EQ(one->expressions[0].look, document::ExpressionOverride::none);
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
  ASSERT_EQ(model.expressions.size(), 1U);
  EXPECT_EQ(model.expressions[0].name, "happy");
  EXPECT_EQ(model.notes, (std::vector<std::string>{
                             "expression happy: bind 0 is left out: node 77 is not there or shows nothing",
                             "expression happy: bind 1 is left out: node 0 has no morph target 9",
                             "expression happy: bind 2 is left out: it names no node",
                             "expression sad: bind 0 is left out: node 0 has no morph target 1",
                             "expression sad is left out: it moves nothing",
                         }));
}

TEST(GltfExpressions, OneTargetOfTwoMeshesCountsOnce) {
  // Two meshes with a target of one name are one control; an expression binds it in both.
  auto sample = tests::morph_sample();
  sample.json["meshes"].push_back(sample.json["meshes"][0]);
  sample.add("nodes", {{"name", "twin"}, {"mesh", 1}});
  sample.json["scenes"][0]["nodes"] = {0, 1};
  sample.json["extensions"]["VRM"]["blendShapeMaster"]["blendShapeGroups"] = {
      {{"name", "Blink"},
       {"binds", {{{"mesh", 0}, {"index", 0}, {"weight", 100}}, {{"mesh", 1}, {"index", 0}, {"weight", 100}}}}}};
  const auto model = sample.read().value();
  ASSERT_EQ(model.expressions.size(), 1U);
  EXPECT_EQ(model.expressions[0].values, (Values{{0, 1.0}}));
}

TEST(GltfExpressions, SurviveAFileThatIsNoAvatarAnyMore) {
  auto sample = tests::morph_sample();
  sample.json["extensions"]["VRM"]["blendShapeMaster"]["blendShapeGroups"] = {
      {{"name", "Joy"}, {"binds", {{{"mesh", 0}, {"index", 0}, {"weight", 50}}}}}};
  const auto model = sample.read().value();
  const auto again = read_gltf(write_glb(model).value()).value();
  ASSERT_EQ(again.expressions.size(), 1U);
  EXPECT_EQ(again.expressions[0].name, "Joy");
  EXPECT_EQ(again.expressions[0].values, (Values{{0, 0.5}}));
  EXPECT_EQ(again.front_yaw_degrees, 180);
}

}  // namespace
}  // namespace penpose::io
