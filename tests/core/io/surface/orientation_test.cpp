#include "core/io/surface/orientation.h"

#include <gtest/gtest.h>

#include "core/io/model/read_model.h"
#include "tests/support/models/gltf_sample.h"

namespace penpose::io {
namespace {

/// A wedge 3 high along z, with normals.
document::Model wedge() {
  return read_model(
             base::as_bytes("v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nvn 0 -1 0\nf 1//1 2//1 4//1\nf 1 3 2\nf 1 4 3\n"),
             "w.obj")
      .value();
}

geometry::ModelVector facing(const document::Model& model, std::size_t triangle) {
  const auto p = model.mesh->positions();
  const auto& t = model.mesh->triangles()[triangle];
  return glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
}

TEST(Orientation, ZUpStandsAndKeepsItsSides) {
  const document::Model lying = wedge();
  EXPECT_TRUE(looks_as_if_z_were_up(lying));
  const auto standing = oriented(lying, {.up = Up::z});
  ASSERT_TRUE(standing.ok());
  EXPECT_FALSE(looks_as_if_z_were_up(*standing));
  EXPECT_EQ(standing->mesh->positions()[3], geometry::ModelPoint(0, 3, 0));
  EXPECT_EQ(standing->mesh->positions()[2], geometry::ModelPoint(0, 0, -2));
  EXPECT_GT(facing(*standing, 0).z, 0.0) << "what looked to -y looks to the front";
  ASSERT_FALSE(standing->mesh->file_normals().empty());
  EXPECT_EQ(standing->mesh->file_normals()[1], glm::vec3(0, 0, 1));
  EXPECT_EQ(standing->notes.back(), "z is up in the file: it was turned so that y is");
}

TEST(Orientation, ALeftHandedFileIsMirroredAndStillFacesOutwards) {
  const document::Model left = wedge();
  const auto right = oriented(left, {.left_handed = true});
  ASSERT_TRUE(right.ok());
  EXPECT_EQ(right->mesh->positions()[1], geometry::ModelPoint(-1, 0, 0));
  for (std::size_t t = 0; t < 3; ++t) {
    const auto before = facing(left, t);
    EXPECT_EQ(facing(*right, t), geometry::ModelVector(-before.x, before.y, before.z)) << t;
  }
}

TEST(Orientation, FormatsThatSayItThemselvesAreNotOpen) {
  EXPECT_TRUE(has_open_orientation({}, "a.OBJ"));
  EXPECT_TRUE(has_open_orientation(base::as_bytes("v 0 0 0\n"), "a.glb")) << "the content goes first";
  EXPECT_FALSE(has_open_orientation(tests::square_sample().glb(), "a.obj"));
  EXPECT_FALSE(has_open_orientation({}, "a.gltf"));
  EXPECT_FALSE(oriented(tests::morph_sample().read().value(), {.up = Up::z}).ok());
}

}  // namespace
}  // namespace penpose::io
