#include "core/io/gltf/write/baked_deformer.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/document/time/animation_building.h"
#include "core/document/time/animation_sampling.h"
#include "core/io/gltf/write/deformer_sample.h"
#include "core/io/model/read_model.h"
#include "core/io/model/write_model.h"
#include "tests/support/models/sketched_models.h"

namespace penpose::io {
namespace {

using tests::curling_trunk;

std::vector<std::uint8_t> without_extras(std::vector<std::uint8_t> bytes) {
  const std::string_view key = "\"penpose\":{";
  for (auto at = bytes.begin(); (at = std::search(at, bytes.end(), key.begin(), key.end())) != bytes.end(); ++at)
    at[1] = 'x';
  return bytes;
}

TEST(BakedDeformer, IsTheDeformerAtEveryAmount) {
  const auto model = curling_trunk();
  const auto& deformer = *model.deformers->deformers()[0];
  const double tolerance = 1e-3 * document::rest_world_box(model).diagonal();
  const auto baked = bake_deformer(deformer, tolerance);
  EXPECT_GE(baked.targets.size(), 1U);
  EXPECT_LE(baked.targets.size(), 6U);
  EXPECT_LE(baked.error, tolerance);
  const auto sample = sample_deformer(deformer);
  for (double amount = 0.013; amount < 1; amount += 0.11) {
    const std::vector<geometry::ModelVector> moves = deformer.displacements(amount);
    for (std::size_t i = 0; i < moves.size(); ++i) {
      auto shown = geometry::ModelVector(sample.deltas[i]) * amount;
      for (std::size_t k = 0; k < baked.targets.size(); ++k) {
        shown += geometry::ModelVector(baked.targets[k].deltas[i]) * baked.weight(k, amount);
      }
      EXPECT_LE(geometry::distance(moves[i], shown), 1.3 * tolerance);
    }
  }
  EXPECT_TRUE(bake_deformer(deformer, 1e9).targets.empty());
  EXPECT_GT(bake_deformer(deformer, tolerance / 20).targets.size(), baked.targets.size());
}

TEST(BakedDeformer, AFilePlaysTheSameWithoutItsExtras) {
  auto model = curling_trunk();
  std::vector<double> times;
  std::vector<rig::Pose> poses;
  for (int f = 0; f <= 30; ++f) {
    times.push_back(f / 30.0);
    poses.push_back({f / 30.0});
  }
  model.animations = {document::make_animation(model, "curl", times, poses)};
  model.pose = {0.4};
  WriteReport report;
  const auto bytes = write_glb(model, {1e-3}, &report).value();
  EXPECT_EQ(report.targets, 1 + report.baked);
  EXPECT_GT(report.baked, 0U);
  EXPECT_LE(report.bake_error, 1e-3);
  const auto own = read_model(bytes, "curl.glb").value();
  EXPECT_EQ(document::state_hash(own), document::state_hash(model));
  const auto plain = read_model(without_extras(bytes), "curl.glb").value();
  ASSERT_FALSE(plain.deformers);
  ASSERT_EQ(plain.shapes->shapes().size(), report.targets);
  const double size = document::rest_world_box(model).diagonal();
  const auto compare = [&](const document::Model& a, const document::Model& b) {
    const auto pa = document::posed_positions(a);
    const auto pb = document::posed_positions(b);
    double most = 0;
    for (std::size_t v = 0; v < pa.size(); ++v) most = std::max(most, geometry::distance(pa[v], pb[v]));
    return most / size;
  };
  EXPECT_LT(compare(own, plain), 1.1e-3);
  for (const double time : {0.0, 0.21, 0.5, 0.777, 1.0}) {
    const auto wanted = document::model_at(own, document::sample(own, own.animations[0], time)).value();
    // Plain weights may lie outside 0..1, where other programs do not clamp them either.
    const auto weights = document::sample(plain, plain.animations[0], time).weights;
    auto shown = plain;
    shown.pose = weights;
    EXPECT_LT(compare(wanted, shown), 1.2e-3) << time;
  }
}

TEST(BakedDeformer, AFilePlaysTheSameBetweenKeysThatLieFarApart) {
  for (const auto interpolation : {document::Interpolation::linear, document::Interpolation::cubic_spline}) {
    auto model = curling_trunk();
    const bool cubic = interpolation == document::Interpolation::cubic_spline;
    document::Channel channel;
    channel.interpolation = interpolation;
    channel.times_s = {0, 2, 3};
    channel.values = cubic ? std::vector<double>{0, 0, 0.5, 0, 1, 0, -1, 0.25, 0} : std::vector<double>{0, 1, 0.25};
    model.animations = {{"curl", {channel}}};
    WriteReport report;
    const auto bytes = write_glb(model, {1e-3}, &report).value();
    EXPECT_LE(report.bake_error, 1e-3);
    const auto own = read_model(bytes, "curl.glb").value();
    EXPECT_EQ(document::state_hash(own), document::state_hash(model));
    const auto plain = read_model(without_extras(bytes), "curl.glb").value();
    ASSERT_FALSE(plain.deformers);
    EXPECT_GT(plain.animations[0].channels[0].times_s.size(), 3U);
    EXPECT_LT(plain.animations[0].channels[0].times_s.size(), 100U);
    const double size = document::rest_world_box(model).diagonal();
    double most = 0;
    for (int k = 0; k <= 200; ++k) {
      const double time = 0.015 * k;
      const auto wanted = document::model_at(own, document::sample(own, own.animations[0], time)).value();
      auto shown = plain;
      shown.pose = document::sample(plain, plain.animations[0], time).weights;
      const auto a = document::posed_positions(wanted);
      const auto b = document::posed_positions(shown);
      for (std::size_t v = 0; v < a.size(); ++v) most = std::max(most, geometry::distance(a[v], b[v]) / size);
    }
    // What is said to be reached is what is seen.
    EXPECT_LE(most, 1.1 * report.bake_error);
    EXPECT_GT(most, 0.2 * report.bake_error);
  }
}

TEST(BakedDeformer, NonsenseAboutAddedKeysIsPassedOver) {
  auto model = curling_trunk();
  model.animations = {{"curl", {{document::ChannelTarget::weights, 0, {}, {0, 1}, {0, 1}}}}};
  model.animations[0].channels[0].interpolation = document::Interpolation::linear;
  const auto bytes = write_glb(model).value();
  std::string text(bytes.begin(), bytes.end());
  const std::string key = "\"added\":[";
  const auto at = text.find(key);
  ASSERT_NE(at, std::string::npos);
  const auto end = text.find(']', at);
  for (const std::string nonsense : {"0", "-1", "99999", "1.5", "null", "\"1\"", "[1"}) {
    auto wrong = text;
    std::string list = nonsense;
    list.resize(end - at - key.size(), ' ');
    wrong.replace(at + key.size(), list.size(), list);
    const auto read = read_model(base::as_bytes(wrong), "curl.glb");
    if (!read) continue;  // no JSON any more
    EXPECT_GE(read->animations[0].channels[0].times_s.size(), 2U);
    EXPECT_EQ(read->animations[0].channels[0].times_s.back(), 1);
  }
}

}  // namespace
}  // namespace penpose::io
