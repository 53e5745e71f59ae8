#include "core/io/gltf/read/internal/gltf_nodes.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/geometry/rotation.h"
#include "tests/support/models/gltf_sample.h"

namespace penpose::io {
namespace {

base::Result<NodeTransform> transform_of(const nlohmann::json& node) {
  tests::GltfSample sample = tests::square_sample();
  sample.json["nodes"][0].update(node);
  const auto bytes = sample.glb();
  const auto document = open_gltf(bytes, {});
  if (!document) return document.error();
  return node_transform(*document, 0);
}

TEST(GltfNodes, MatrixIsTakenApartAndComesBack) {
  const auto before = geometry::compose({1, 2, 3}, glm::normalize(glm::dquat(0.3, -0.5, 0.2, 0.7)), {-2, 0.5, 3});
  nlohmann::json numbers = nlohmann::json::array();
  for (int i = 0; i < 16; ++i) numbers.push_back(before[i / 4][i % 4]);
  const auto transform = transform_of({{"matrix", numbers}});
  ASSERT_TRUE(transform.ok()) << transform.error().line();
  const auto after = geometry::compose(transform->translation, transform->rotation, transform->scale);
  for (int i = 0; i < 16; ++i) EXPECT_NEAR(after[i / 4][i % 4], before[i / 4][i % 4], 1e-12);
}

TEST(GltfNodes, FlatMatricesKeepTheirAxes) {
  for (const nlohmann::json& numbers : {nlohmann::json{0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1},
                                        nlohmann::json{0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 1},
                                        nlohmann::json{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 5, 0, 0, 1}}) {
    const auto transform = transform_of({{"matrix", numbers}});
    ASSERT_TRUE(transform.ok()) << transform.error().line();
    const auto after = geometry::compose(transform->translation, transform->rotation, transform->scale);
    for (int i = 0; i < 16; ++i)
      EXPECT_NEAR(after[i / 4][i % 4], numbers[static_cast<std::size_t>(i)].get<double>(), 1e-12);
  }
}

TEST(GltfNodes, WhatIsNoTransformIsRefused) {
  EXPECT_EQ(transform_of({{"matrix", {1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}).error().place,
            "/nodes/0/matrix");
  EXPECT_EQ(transform_of({{"translation", {1e300, 0, 0}}}).error().place, "/nodes/0");
}

TEST(GltfNodes, AMatrixThatShearsIsTheNearestTransform) {
  // Half a turn about z by 90 degrees, sheared along x by 0.5: the nearest rotation lies half the angle of the shear
  // on.
  const auto transform = transform_of({{"matrix", {1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 3, 4, 5, 1}}});
  ASSERT_TRUE(transform.ok()) << transform.error().line();
  EXPECT_TRUE(transform->sheared);
  EXPECT_EQ(transform->translation, glm::dvec3(3, 4, 5));
  const glm::dmat3 turned = glm::mat3_cast(transform->rotation);
  // Both axes are equally far from those of the file, whose unit directions are (1, 0) and (1, 2) / sqrt(5).
  const double first = glm::dot(turned[0], glm::dvec3(1, 0, 0));
  const double second = glm::dot(turned[1], glm::dvec3(1, 2, 0) / std::sqrt(5.0));
  EXPECT_NEAR(first, second, 1e-12);
  EXPECT_NEAR(glm::dot(turned[0], turned[1]), 0, 1e-12);
  EXPECT_FALSE(transform_of({{"scale", {1, 2, 3}}})->sheared);
  // In one plane, and on one line.
  for (const nlohmann::json& flat : {nlohmann::json{1, 0, 0, 0, 1, 1, 0, 0, 2, 1, 0, 0, 0, 0, 0, 1},
                                     nlohmann::json{1, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 1}}) {
    const auto one = transform_of({{"matrix", flat}});
    ASSERT_TRUE(one.ok()) << one.error().line();
    EXPECT_NEAR(glm::dot(one->rotation, one->rotation), 1, 1e-12);
  }
  tests::GltfSample sample = tests::square_sample();
  sample.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 3, 4, 5, 1};
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  ASSERT_EQ(model->notes.size(), 1U);
  EXPECT_NE(model->notes[0].find("shear"), std::string::npos);
}

TEST(GltfNodes, TracesOfSinglePrecisionAndRotationsOfNothingAreNoFaults) {
  const auto matrix = transform_of({{"matrix", {1, 0, 0, 1e-8, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 7, 0.9999999}}});
  ASSERT_TRUE(matrix.ok()) << matrix.error().line();
  EXPECT_EQ(matrix->translation, glm::dvec3(0, 0, 7));
  const auto rotation = transform_of({{"rotation", {0, 0, 0, 0}}});
  ASSERT_TRUE(rotation.ok()) << rotation.error().line();
  EXPECT_EQ(rotation->rotation, glm::dquat(1, 0, 0, 0));
}

TEST(GltfNodes, TreeAndScene) {
  tests::GltfSample sample = tests::skin_sample();
  sample.add("nodes", {{"name", "outside"}});
  const auto bytes = sample.glb();
  const auto document = open_gltf(bytes, {});
  ASSERT_TRUE(document.ok());
  const NodeTree tree = make_node_tree(*document);
  EXPECT_EQ(tree.parent, (std::vector<std::int32_t>{-1, -1, 1, -1}));
  EXPECT_EQ(tree.in_scene, (std::vector<bool>{true, true, true, false}));
}

/// The normal of the first triangle as the model is shown at rest.
geometry::ModelVector shown_normal(const document::Model& model) {
  std::vector<geometry::ModelPoint> places(model.rig->vertex_count());
  model.rig->evaluate(rig::rest_pose(*model.rig), places);
  const auto& [a, b, c] = model.mesh->triangles()[0];
  return glm::cross(places[b] - places[a], places[c] - places[a]);
}

TEST(GltfNodes, AMirroredPartIsShownFromItsOutside) {
  // The square under a node above its own, which a mirrored one may stand above again.
  for (const auto& [outer, inner, mirrored] :
       {std::tuple(-1, 1, true), std::tuple(1, -1, true), std::tuple(-1, -1, false)}) {
    tests::GltfSample sample = tests::square_sample();
    sample.json["nodes"][0]["scale"] = {inner, 1, 1};
    sample.add("nodes", {{"name", "above"}, {"scale", {outer, 1, 1}}, {"children", {0}}});
    sample.json["scenes"][0]["nodes"] = {1};
    const auto model = sample.read();
    ASSERT_TRUE(model.ok()) << model.error().line();
    EXPECT_GT(shown_normal(*model).z, 0) << outer << inner;
    EXPECT_EQ(model->mesh->triangles()[0] == (mesh::Triangle{0, 2, 1}), mirrored);
    // Written anew the triangles are as they were in the file.
    document::Model bare = *model;
    bare.source = nullptr;
    const auto again = read_gltf(write_glb(bare).value());
    ASSERT_TRUE(again.ok()) << again.error().line();
    EXPECT_EQ(again->mesh->triangles()[0], model->mesh->triangles()[0]);
    EXPECT_GT(shown_normal(*again).z, 0);
  }
}

}  // namespace
}  // namespace penpose::io
