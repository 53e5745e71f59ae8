#include "core/io/gltf/read/internal/gltf_animations.h"

#include <gtest/gtest.h>
#include <limits>

#include "core/base/edition.h"
#include "core/document/time/animation_sampling.h"
#include "tests/support/models/gltf_sample.h"

namespace penpose::io {
namespace {

/// The morph sample with an animation of one sampler.
tests::GltfSample animated(const std::vector<float>& times, const std::vector<float>& values, const char* type,
                           std::size_t components, const char* path, const char* interpolation = "LINEAR") {
  tests::GltfSample sample = tests::morph_sample();
  const auto input = sample.add_accessor(times, "SCALAR", 1, 5126);
  const auto output = sample.add_accessor(values, type, components, 5126);
  sample.add("animations", {{"name", "move"},
                            {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}},
                            {"samplers", {{{"input", input}, {"output", output}, {"interpolation", interpolation}}}}});
  return sample;
}

TEST(GltfAnimations, WeightsOfShapes) {
  const auto model = animated({0, 1}, {0, 1}, "SCALAR", 1, "weights").read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  ASSERT_EQ(model->animations.size(), 1U);
  const auto& channel = model->animations[0].channels[0];
  EXPECT_EQ(channel.target, document::ChannelTarget::weights);
  EXPECT_EQ(channel.times_s, (std::vector<double>{0, 1}));
  EXPECT_EQ(channel.values, (std::vector<double>{0, 1}));
}

TEST(GltfAnimations, WeightsOfSeveralMeshesJoin) {
  tests::GltfSample sample = animated({0, 1}, {0, 1}, "SCALAR", 1, "weights");
  nlohmann::json second = sample.json["meshes"][0];
  second["name"] = "second";
  second["extras"]["targetNames"] = {"other"};
  second["weights"] = {0.5};
  sample.add("meshes", second);
  sample.add("nodes", {{"mesh", 1}});
  sample.json["scenes"][0]["nodes"] = {0, 1};
  auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->animations[0].channels[0].values, (std::vector<double>{0, 0.5, 1, 0.5}));
  sample.json["animations"][0]["channels"].push_back({{"sampler", 0}, {"target", {{"node", 1}, {"path", "weights"}}}});
  model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  ASSERT_EQ(model->animations[0].channels.size(), 1U);
  EXPECT_EQ(model->animations[0].channels[0].values, (std::vector<double>{0, 0, 1, 1}));
}

TEST(GltfAnimations, ForeignWeightsOutsideZeroToOneAreKept) {
  auto model = animated({0, 1, 2}, {-0.5, 3, 0}, "SCALAR", 1, "weights").read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->rig->parameters()[0].minimum, -0.5);
  EXPECT_EQ(model->rig->parameters()[0].maximum, 3);
  const auto moment = document::model_at(*model, document::sample(*model, model->animations[0], 0.5)).value();
  EXPECT_EQ(moment.pose[0], 1.25);
  // A cubic spline between keys of 0..1 swings beyond them: 0, 12 per second up, 1, 12 per second up.
  model = animated({0, 1}, {0, 0, 12, 12, 1, 0}, "SCALAR", 1, "weights", "CUBICSPLINE").read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  double lowest = 0;
  double highest = 1;
  for (int i = 0; i <= 10000; ++i) {
    const double value = document::sample(*model, model->animations[0], i * 1e-4).weights[0];
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  EXPECT_GT(highest, 1.01);
  EXPECT_NEAR(model->rig->parameters()[0].minimum, lowest, 1e-6);
  EXPECT_NEAR(model->rig->parameters()[0].maximum, highest, 1e-6);
  // Wild numbers stay finite; where nothing is animated the range is 0..1.
  model = animated({0, 1}, {-3e38F, 3e38F}, "SCALAR", 1, "weights").read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_LE(model->rig->parameters()[0].maximum, 1e9);
  EXPECT_EQ(tests::morph_sample().read()->rig->parameters()[0].maximum, 1);
}

TEST(GltfAnimations, OwnRangesStay) {
  tests::GltfSample sample = animated({0, 1}, {-0.5, 3}, "SCALAR", 1, "weights");
  const auto name = sample.read()->rig->parameters()[0].name;
  sample.json["extras"]["penpose"] = {{"edition", base::k_edition},
                                      {"shapes", {{{"name", name}, {"rest", 0}, {"minimum", 0}, {"maximum", 2}}}}};
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->rig->parameters()[0].minimum, 0);
  EXPECT_EQ(model->rig->parameters()[0].maximum, 2);
}

TEST(GltfAnimations, AnAnimatedNodeCarriesItsMesh) {
  const auto model = animated({0, 1}, {0, 0, 0, 5, 0, 0}, "VEC3", 3, "translation", "STEP").read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  ASSERT_TRUE(model->skeleton);
  const auto& channel = model->animations[0].channels[0];
  EXPECT_EQ(channel.interpolation, document::Interpolation::step);
  EXPECT_EQ(channel.joint, 0U);
  EXPECT_EQ(model->skeleton->influences_of(0).size(), 1U);
}

TEST(GltfAnimations, ChannelsThatCannotBeReadAreLeftOutWithANote) {
  const auto left_out = [](tests::GltfSample sample) {
    const auto model = sample.read();
    if (!model) return model.error().line();
    EXPECT_TRUE(model->animations.empty());
    return model->notes.empty() ? "(no note)" : model->notes.front();
  };
  const auto names = [&](tests::GltfSample sample, const char* place) {
    return left_out(std::move(sample)).find(std::string("left out: ") + place + ":") != std::string::npos;
  };
  EXPECT_TRUE(names(animated({-2, -1}, {0, 1}, "SCALAR", 1, "weights"), "/accessors/3"));
  EXPECT_TRUE(names(animated({0, 1}, {0, 1, 2}, "SCALAR", 1, "weights"), "/accessors/4/count"));
  EXPECT_TRUE(names(animated({0, 1}, {0, 1}, "SCALAR", 1, "weights", "CUBICSPLINE"), "/accessors/4/count"));
  EXPECT_TRUE(names(animated({0, 1}, {0, 1}, "SCALAR", 1, "weights", "BEZIER"), "/animations/0/channels/0"));
  EXPECT_TRUE(names(animated({0, 1}, {0, 1}, "SCALAR", 1, "colour"), "/animations/0/channels/0"));
  EXPECT_TRUE(names(animated({0, 1}, {0, 1}, "SCALAR", 1, "rotation"), "/accessors/4/type"));
  EXPECT_TRUE(
      names(animated({0, 1}, {0, std::numeric_limits<float>::infinity()}, "SCALAR", 1, "weights"), "/accessors/4"));
}

TEST(GltfAnimations, KeysThatAreNeverReachedAreLeftOutWithANote) {
  const auto keys = [](const std::vector<float>& times, const std::vector<float>& values) {
    const auto model = animated(times, values, "SCALAR", 1, "weights").read();
    if (!model || model->notes.size() != 1 || model->animations.size() != 1) return std::vector<double>();
    auto all = model->animations[0].channels[0].times_s;
    const auto& of = model->animations[0].channels[0].values;
    all.insert(all.end(), of.begin(), of.end());
    return all;
  };
  EXPECT_EQ(keys({0, 0, 1}, {0.25F, 0.5F, 1}), (std::vector<double>{0, 1, 0.25, 1}));
  EXPECT_EQ(keys({0, 1, 0.5F, 2}, {0, 1, 0.75F, 0.5F}), (std::vector<double>{0, 1, 2, 0, 1, 0.5}));
  EXPECT_EQ(keys({-1, 0}, {1, 0.5F}), (std::vector<double>{0, 0.5}));
}

TEST(GltfAnimations, NodesThatCarryNothingAreNoted) {
  tests::GltfSample sample = animated({0, 1}, {0, 0, 0, 5, 0, 0}, "VEC3", 3, "scale");
  sample.add("nodes", {{"name", "light"}});
  sample.json["animations"][0]["channels"][0]["target"]["node"] = 1;
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_TRUE(model->animations.empty());
  EXPECT_EQ(model->notes.size(), 1U);
}

}  // namespace
}  // namespace penpose::io
