#include "core/io/fbx/write/write_fbx.h"

#include <gtest/gtest.h>
#include <string_view>
#include <vector>

#include "core/document/look.h"
#include "core/document/time/animation_sampling.h"
#include "core/io/fbx/read_fbx.h"
#include "core/io/model/model_formats.h"

namespace penpose::io {
namespace {

/// Two parts on a chain of two joints, the lower one turned at rest, with a shape across both parts.
document::Model figure() {
  mesh::MeshSource source;
  for (int i = 0; i < 6; ++i)
    source.positions.emplace_back(0.1 * i, i % 2 == 0 ? 1.0 : 1.5 + 0.1 * i, i % 3 == 0 ? 0.3 : -0.1);
  source.triangles = {{0, 1, 2}, {3, 4, 5}};
  source.parts = {{"face", 0, 3, 0, 1}, {"teeth", 3, 3, 1, 1}};
  const auto mesh = mesh::TriangleMesh::build(std::move(source)).value();
  rig::Joint hips;
  hips.name = "hips";
  hips.translation = {0, 1, 0};
  hips.inverse_bind = glm::dmat4(1);
  hips.inverse_bind[3] = {0, -1, 0, 1};
  rig::Joint head = hips;
  head.name = "head";
  head.parent = 0;
  head.translation = {0, 0.5, 0};
  head.rest_rotation = {0.8, 0, 0.6, 0};
  head.scale = {1, 1, 2};
  head.inverse_bind[3] = {0, -1.5, 0, 1};
  auto skeleton =
      rig::Skeleton::make({hips, head}, {0, 1, 2, 4, 5, 5, 6}, {{0, 1}, {1, 1}, {0, 0.25}, {1, 0.75}, {1, 1}, {0, 1}})
          .value();
  rig::BlendShape shape;
  shape.parameter = {"smile", 0, 0, 1};
  shape.vertices = {1, 4};
  shape.deltas = {{0.1F, 0, 0}, {0, 0.2F, 0.1F}};
  auto model = document::make_model(mesh, rig::BlendShapes::make({shape}, 6).value(), skeleton).value();
  model.materials = {{"skin", {0.9, 0.5, 0.25, 1.0}}, {"enamel", {1, 1, 1, 1}}};
  document::Animation take{"nod", {}};
  take.channels.push_back({document::ChannelTarget::weights, 0, document::Interpolation::linear, {0, 1}, {0, 1}});
  take.channels.push_back({document::ChannelTarget::rotation,
                           1,
                           document::Interpolation::linear,
                           {0, 1, 2},
                           {0, 0, 0, 1, 0.6, 0, 0, 0.8, 0, 0.28, 0, 0.96}});
  take.channels.push_back(
      {document::ChannelTarget::translation, 0, document::Interpolation::step, {0, 1}, {0, 1, 0, 1, 1, 0}});
  model.animations = {take};
  return model;
}

void expect_same(const document::Model& a, const document::Model& b, double within) {
  const auto one = document::posed_positions(a);
  const auto two = document::posed_positions(b);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t v = 0; v < one.size(); ++v) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(one[v][i], two[v][i], within) << v;
  }
}

document::Model through_a_file(const document::Model& model) {
  WriteReport report;
  const auto bytes = write_fbx(model, {}, report).value();
  EXPECT_EQ(format_of_content(bytes)->name, "FBX");
  auto read = read_fbx(bytes, {});
  EXPECT_TRUE(read.ok()) << read.error().line();
  return std::move(read).value();
}

TEST(WriteFbx, WhatIsWrittenReadsBackAtSeveralPoses) {
  auto model = figure();
  expect_same(through_a_file(model), model, 1e-6);
  model.pose = {0.7, 0.2, -0.4, 0.1, -0.3, 0.5, 0.9};
  ASSERT_EQ(model.pose.size(), model.rig->parameters().size());
  const auto back = through_a_file(model);
  expect_same(back, model, 1e-6);
  ASSERT_EQ(back.mesh->parts().size(), 2U);
  EXPECT_EQ(back.mesh->parts()[1].name, "teeth");
  EXPECT_EQ(back.mesh->triangle_count(), 2U);
  EXPECT_EQ(back.materials.at(0).name, "skin");
  EXPECT_EQ(back.materials[0].base_color[1], 0.5);
  EXPECT_EQ(back.shapes->shapes()[0].parameter.name, "smile");
  EXPECT_EQ(back.skeleton->joints()[1].name, "head");
}

TEST(WriteFbx, AnimationsPlayTheSame) {
  const auto model = figure();
  const auto back = through_a_file(model);
  ASSERT_EQ(back.animations.size(), 1U);
  EXPECT_EQ(back.animations[0].name, "nod");
  for (const double time_s : {0.0, 0.25, 0.5, 0.9, 1.0, 1.4, 2.0}) {
    const auto was = document::model_at(model, document::sample(model, model.animations[0], time_s)).value();
    const auto is = document::model_at(back, document::sample(back, back.animations[0], time_s)).value();
    expect_same(is, was, 2e-5);
  }
}

TEST(WriteFbx, PicturesLieBesideTheFileThatNamesThem) {
  auto model = figure();
  document::Look look;
  document::Image image;
  image.mime_type = "image/jpeg";
  image.bytes =
      document::KeptBytes(std::make_shared<const std::vector<std::uint8_t>>(std::vector<std::uint8_t>{1, 2, 3}));
  look.images = {image};
  look.surfaces.resize(2);
  look.surfaces[1].name = "painted";
  look.surfaces[1].texture = document::TextureUse{};
  look.surface_of = {1, 0};
  look.coordinates[0].assign(6, {0.25F, 0.75F});
  model.look = std::make_shared<const document::Look>(look);
  WriteOptions options;
  options.stem = "face";
  WriteReport report;
  const auto bytes = write_fbx(model, options, report).value();
  ASSERT_EQ(report.files.size(), 1U);
  EXPECT_EQ(report.files.at("face_0.jpg"), (std::vector<std::uint8_t>{1, 2, 3}));
  const std::string_view text = base::as_text(bytes);
  EXPECT_NE(text.find("RelativeFilename"), std::string_view::npos);
  EXPECT_NE(text.find("face_0.jpg"), std::string_view::npos);
  const auto back = read_fbx(bytes, {}).value();
  EXPECT_EQ(back.materials.at(0).name, "painted");
}

TEST(WriteFbx, KeysFarApartTakeLittle) {
  auto model = figure();
  model.animations[0].channels[1].times_s = {0, 1e6, 2e6};
  WriteReport report;
  EXPECT_LT(write_fbx(model, {}, report).value().size(), 100'000U);
  ASSERT_EQ(report.notes.size(), 1U);
  EXPECT_NE(report.notes[0].find("far apart"), std::string::npos);
}

TEST(WriteFbx, TheNameOfTheFileAsksForIt) {
  const auto format = format_to_write("face.fbx");
  ASSERT_TRUE(format.ok());
  EXPECT_EQ((*format)->name, "FBX");
}

TEST(WriteFbx, TwiceTheSameModelIsTheSameFile) {
  WriteReport report;
  EXPECT_EQ(write_fbx(figure(), {}, report).value(), write_fbx(figure(), {}, report).value());
}

}  // namespace
}  // namespace penpose::io
