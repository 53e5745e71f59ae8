#include "core/io/gltf/read/internal/gltf_deformers.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/base/byte_writer.h"
#include "core/io/model/read_model.h"
#include "core/io/model/write_model.h"
#include "tests/support/models/articulation_models.h"

namespace penpose::io {
namespace {

/// The eye with a blend shape and two sketched deformers.
document::Model rigged_eye() {
  const tests::Eye eye = tests::make_eye();
  mesh::MeshSource source;
  source.positions.assign(eye.canvas->positions().begin(), eye.canvas->positions().end());
  source.triangles.assign(eye.canvas->mesh().triangles().begin(), eye.canvas->mesh().triangles().end());
  source.parts.assign(eye.canvas->mesh().parts().begin(), eye.canvas->mesh().parts().end());
  const auto mesh = mesh::TriangleMesh::build(std::move(source)).value();
  rig::BlendShape wide;
  wide.parameter = {"wide", 0, 0, 1};
  wide.vertices = {3, 4};
  wide.deltas = {{0, 0.1F, 0}, {0, 0.2F, 0}};
  auto model =
      document::make_model(mesh, rig::BlendShapes::make({wide}, mesh->vertex_count()).value(), nullptr).value();
  const auto canvas = document::make_canvas(model).value();
  articulation::Sketch plain = eye.blink();
  plain.name = "blink_straight";
  plain.surface = std::monostate{};
  const auto deformers = articulation::SketchedDeformers::build(std::vector{eye.blink(), plain}, *canvas).value();
  model = document::with_deformers(std::move(model), deformers).value();
  model.pose = {0.25, 0.5, 0.125};
  return model;
}

base::Result<document::Model> reread(const document::Model& model) {
  const auto bytes = write_glb(model).value();
  return read_model(bytes, "model.glb");
}

TEST(GltfDeformers, GoOnWorkingAfterAFileHasBeenClosed) {
  const document::Model model = rigged_eye();
  const auto back = reread(model);
  ASSERT_TRUE(back.ok()) << back.error().line();
  EXPECT_TRUE(back->notes.empty());
  ASSERT_TRUE(back->deformers);
  EXPECT_EQ(back->deformers->sketches(), model.deformers->sketches());
  EXPECT_EQ(back->shapes->shapes().size(), 1U);
  EXPECT_EQ(document::state_hash(*back), document::state_hash(model));
  EXPECT_EQ(document::posed_positions(*back), document::posed_positions(model));
}

TEST(GltfDeformers, AreMorphTargetsToOtherPrograms) {
  const document::Model model = rigged_eye();
  auto bytes = write_glb(model).value();
  // Another program does not know the extras.
  std::string text(bytes.begin(), bytes.end());
  for (std::size_t at = 0; (at = text.find("\"penpose\":{", at)) != std::string::npos; ++at) text[at + 1] = 'x';
  const auto other = read_model(base::as_bytes(text), "model.glb");
  ASSERT_TRUE(other.ok()) << other.error().line();
  EXPECT_FALSE(other->deformers);
  ASSERT_GE(other->shapes->shapes().size(), 3U);  // and what baking adds
  const auto parameter = rig::find_parameter(other->rig->parameters(), "blink_L");
  ASSERT_TRUE(parameter.has_value());
  rig::Pose pose = rig::rest_pose(*other->rig);
  pose[*parameter] = 1.0;
  std::vector<geometry::ModelPoint> as_morph(other->mesh->vertex_count());
  other->rig->evaluate(pose, as_morph);
  document::Model closed = model;
  closed.pose = {0, 1, 0};
  const auto as_deformer = document::posed_positions(closed);
  for (std::size_t v = 0; v < as_morph.size(); ++v) EXPECT_LT(geometry::distance(as_morph[v], as_deformer[v]), 1e-6);
}

TEST(GltfDeformers, StayBlendShapesWhenTheModelHasChangedUnderThem) {
  const document::Model model = rigged_eye();
  // The same mesh, twice as large, with the extras of the small one: what a program does that scales a model.
  auto bytes = write_glb(model).value();
  document::Model large = model;
  mesh::MeshSource source;
  for (const auto& p : model.mesh->positions()) source.positions.push_back(p * 1.02);
  source.triangles.assign(model.mesh->triangles().begin(), model.mesh->triangles().end());
  source.parts.assign(model.mesh->parts().begin(), model.mesh->parts().end());
  large.mesh = mesh::TriangleMesh::build(std::move(source)).value();
  const auto back = reread(large);
  ASSERT_TRUE(back.ok()) << back.error().line();
  EXPECT_FALSE(back->deformers);
  ASSERT_GE(back->shapes->shapes().size(), 3U);
  ASSERT_EQ(back->notes.size(), 2U);
  EXPECT_NE(back->notes[0].find("blink_L"), std::string::npos);
  EXPECT_TRUE(std::equal(model.pose.begin(), model.pose.end(), back->pose.begin()));
}

TEST(GltfDeformers, AreAnimatedWithTheBlendShapes) {
  document::Model model = rigged_eye();
  document::Channel channel;
  channel.times_s = {0, 1};
  channel.values = {0, 0, 0.5, 1, 0.25, 0.75};
  model.animations.push_back({"wink", {channel}});
  const auto back = reread(model);
  ASSERT_TRUE(back.ok()) << back.error().line();
  ASSERT_EQ(back->animations.size(), 1U);
  EXPECT_EQ(back->animations[0].channels[0].values, channel.values);
}

}  // namespace
}  // namespace penpose::io
