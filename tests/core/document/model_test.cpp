#include "core/document/model.h"

#include <functional>
#include <gtest/gtest.h>
#include <set>

#include "tests/support/models/articulation_models.h"
#include "tests/support/models/test_rigs.h"

namespace penpose::document {
namespace {

/// One of everything. Without random numbers of a library, so that its hash can be pinned.
Model full_model() {
  mesh::MeshSource source;
  source.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
  source.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}};
  source.parts = {{"skin", 0, 4, 0, 2}, {"teeth", 4, 3, 2, 1}};
  const auto mesh = mesh::TriangleMesh::build(source).value();
  std::vector<rig::BlendShape> shapes(2);
  shapes[0].parameter = {"open", 0, 0, 1};
  shapes[0].vertices = {1, 2};
  shapes[0].deltas = {{0, 0.5, 0}, {0, 0.25, 0}};
  shapes[1].parameter = {"wide", 0.5, -1, 1};
  shapes[1].vertices = {0};
  shapes[1].deltas = {{-2, 0, 0}};
  std::vector<rig::Joint> joints(1);
  joints[0].name = "head";
  joints[0].translation = {0, 0, 3};
  auto skeleton = rig::Skeleton::make(joints, {0, 1, 1, 1, 1, 1, 1, 1}, {{0, 1}}).value();
  Model model = make_model(mesh, rig::BlendShapes::make(shapes, 7).value(), skeleton).value();
  model.curves = {{"lid", {{0, {0.5, 0.5, 0}}, {1, {0, 0, 1}}}}};
  Animation animation{"blink", {}};
  animation.channels.push_back({ChannelTarget::weights, 0, Interpolation::linear, {0, 1}, {0, 0, 1, 1}});
  model.animations = {animation};
  return model;
}

TEST(Model, StartsAtItsRestPose) {
  const Model model = full_model();
  EXPECT_EQ(model.pose, (rig::Pose{0, 0.5, 0, 0, 0}));
  EXPECT_EQ(model.materials.size(), 2U);
  ASSERT_NE(model.rig, nullptr);
  EXPECT_EQ(model.rig->parameters()[2].name, "head.rx");
}

TEST(Model, PosesItsVertices) {
  Model model = full_model();
  model.pose = {1, 0, 0, 0, 0};
  const auto positions = posed_positions(model);
  EXPECT_EQ(positions[1], (geometry::ModelPoint{1, 0.5, 0}));
  EXPECT_EQ(positions[0], (geometry::ModelPoint{0, 0, 3})) << "carried by the joint";
  EXPECT_EQ(positions[4], (geometry::ModelPoint{5, 0, 0}));
}

TEST(Model, TheBoxAtRestDoesNotDependOnThePose) {
  Model model = full_model();
  const auto rest = rest_world_box(model);
  EXPECT_EQ(rest.minimum, (geometry::ModelPoint{-1, 0, 0})) << "rest of wide is 0.5";
  EXPECT_EQ(rest.maximum, (geometry::ModelPoint{6, 1, 3}));
  model.pose = {1, -1, 0, 0, 0};
  EXPECT_EQ(rest_world_box(model).minimum, rest.minimum);
}

TEST(Model, CanBeAMeshAlone) {
  const Model model = make_model(tests::grid_mesh(2, 2), nullptr, nullptr).value();
  EXPECT_TRUE(model.pose.empty());
  EXPECT_EQ(posed_positions(model).size(), 9U);
  EXPECT_EQ(rest_world_box(model).maximum, (geometry::ModelPoint{1, 1, 0}));
}

TEST(Model, RefusesPiecesThatDoNotFit) {
  const auto mesh = tests::grid_mesh(2, 2);
  const auto other = tests::grid_mesh(3, 3);
  EXPECT_FALSE(make_model(mesh, nullptr, tests::chain_skeleton(*other, 2, 0.5)));
  // Morph targets of a larger mesh would move vertices that do not exist.
  EXPECT_FALSE(make_model(mesh, tests::random_shapes(*other, 2, 1), nullptr));
}

TEST(StateHash, IsPinned) {
  // A change of this value breaks every state that somebody wrote down.
  EXPECT_EQ(state_hash(full_model()).hex(), "6104211ac679392f4122fd458c5dea87");
  EXPECT_EQ(state_hash(full_model()), state_hash(full_model()));
}

TEST(StateHash, ChangesWithEverythingThatIsState) {
  std::set<std::string> seen{state_hash(full_model()).hex()};
  const auto differs = [&](const char* what, const std::function<void(Model&)>& change) {
    Model model = full_model();
    change(model);
    EXPECT_TRUE(seen.insert(state_hash(model).hex()).second) << what;
  };
  differs("pose", [](Model& m) { m.pose[0] = 0.5; });
  differs("pose of a joint", [](Model& m) { m.pose[4] = 0.5; });
  differs("curve's name", [](Model& m) { m.curves[0].name = "lip"; });
  differs("curve's point", [](Model& m) { m.curves[0].points[0].triangle = 1; });
  differs("curve's place", [](Model& m) { m.curves[0].points[0].barycentric = {0.25, 0.75, 0}; });
  differs("no curve", [](Model& m) { m.curves.clear(); });
  differs("animation's name", [](Model& m) { m.animations[0].name = "wink"; });
  differs("key's time", [](Model& m) { m.animations[0].channels[0].times_s[1] = 2; });
  differs("key's value", [](Model& m) { m.animations[0].channels[0].values[3] = 0.5; });
  differs("interpolation", [](Model& m) { m.animations[0].channels[0].interpolation = Interpolation::step; });
  differs("channel's joint", [](Model& m) { m.animations[0].channels[0].joint = 1; });
  differs("no animation", [](Model& m) { m.animations.clear(); });
  differs("no skeleton", [](Model& m) { m = make_model(m.mesh, m.shapes, nullptr).value(); });
  differs("no shapes", [](Model& m) { m = make_model(m.mesh, nullptr, m.skeleton).value(); });
  differs("delta", [](Model& m) {
    std::vector<rig::BlendShape> shapes(m.shapes->shapes().begin(), m.shapes->shapes().end());
    shapes[1].deltas[0].z = 1;
    m = make_model(m.mesh, rig::BlendShapes::make(shapes, 7).value(), m.skeleton).value();
  });
  differs("range", [](Model& m) {
    std::vector<rig::BlendShape> shapes(m.shapes->shapes().begin(), m.shapes->shapes().end());
    shapes[1].parameter.maximum = 2;
    m = make_model(m.mesh, rig::BlendShapes::make(shapes, 7).value(), m.skeleton).value();
  });
}

TEST(StateHash, DoesNotHearOfNotesAndMinusZero) {
  Model model = full_model();
  model.notes.emplace_back("a reader left something out");
  model.pose[0] = -0.0;
  EXPECT_EQ(state_hash(model), state_hash(full_model()));
}

Model trunk_model() {
  const tests::Trunk trunk = tests::make_trunk();
  mesh::MeshSource source;
  source.positions.assign(trunk.canvas->positions().begin(), trunk.canvas->positions().end());
  source.triangles.assign(trunk.canvas->mesh().triangles().begin(), trunk.canvas->mesh().triangles().end());
  const auto mesh = mesh::TriangleMesh::build(std::move(source)).value();
  rig::BlendShape shape;
  shape.parameter = {"swell", 0, 0, 1};
  shape.vertices = {0};
  shape.deltas = {{0, 1, 0}};
  return make_model(mesh, rig::BlendShapes::make({shape}, mesh->vertex_count()).value(), nullptr).value();
}

articulation::SketchedDeformers::Shared deformers_of(const Model& model, const std::vector<std::string>& names) {
  std::vector<articulation::Sketch> sketches;
  for (const std::string& name : names) {
    sketches.push_back(tests::make_trunk().curl());
    sketches.back().name = name;
  }
  return articulation::SketchedDeformers::build(sketches, *make_canvas(model).value()).value();
}

TEST(ModelDeformers, DeformersCanBeChangedAndThePoseStays) {
  Model model = trunk_model();
  model.pose = {0.5};
  model.curves.push_back({"line", {}});
  const auto plain = state_hash(model);
  model = with_deformers(model, deformers_of(model, {"curl", "lift"})).value();
  ASSERT_EQ(model.pose.size(), 3U);
  EXPECT_EQ(weight_count(model), 3U);
  EXPECT_EQ(model.pose, (rig::Pose{0.5, 0, 0}));
  EXPECT_EQ(model.curves.size(), 1U);
  EXPECT_FALSE(state_hash(model) == plain);
  model.pose[2] = 0.75;
  model = with_deformers(model, deformers_of(model, {"lift"})).value();
  EXPECT_EQ(model.pose, (rig::Pose{0.5, 0.75}));
  model = with_deformers(model, nullptr).value();
  EXPECT_EQ(state_hash(model), plain);
}

TEST(ModelDeformers, AnimationsKeepTheirControlsByName) {
  Model model = trunk_model();
  Channel channel;
  channel.times_s = {0, 1};
  channel.values = {0.1, 0.2};
  model.animations.push_back({"breath", {channel}});
  model = with_deformers(model, deformers_of(model, {"curl", "lift"})).value();
  EXPECT_EQ(model.animations[0].channels[0].values, (std::vector<double>{0.1, 0, 0, 0.2, 0, 0}));
  model.animations[0].channels[0].values = {0.1, 0.3, 0.5, 0.2, 0.4, 0.6};
  model = with_deformers(model, deformers_of(model, {"lift", "new"})).value();
  EXPECT_EQ(model.animations[0].channels[0].values, (std::vector<double>{0.1, 0.5, 0, 0.2, 0.6, 0}));
}

TEST(ModelDeformers, ADeformerMayNotTakeTheNameOfABlendShape) {
  const Model model = trunk_model();
  EXPECT_FALSE(with_deformers(model, deformers_of(model, {"swell"})).ok());
}

}  // namespace
}  // namespace penpose::document
