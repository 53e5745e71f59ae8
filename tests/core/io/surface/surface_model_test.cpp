#include "core/io/surface/surface_model.h"

#include <gtest/gtest.h>

#include "tests/support/models/model_samples.h"

namespace penpose::io {
namespace {

TEST(SurfaceModel, HasNoRigAndKeepsNotes) {
  mesh::MeshSource source;
  tests::add_square(source, "a", 0);
  source.triangles.push_back({0, 0, 1});
  source.parts[0].triangle_count = 3;
  source.normals.assign(4, glm::vec3(0));
  const auto model = surface_model(std::move(source), {"colours were left out"});
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_TRUE(model->rig->parameters().empty());
  EXPECT_TRUE(model->mesh->file_normals().empty());
  EXPECT_EQ(model->materials.size(), 1U);
  EXPECT_EQ(model->notes,
            (std::vector<std::string>{"colours were left out", "1 triangles without area were left out"}));
}

TEST(SurfaceModel, RefusesPointsAlone) {
  mesh::MeshSource source;
  source.positions = {{0, 0, 0}};
  EXPECT_FALSE(surface_model(std::move(source), {}).ok());
}

}  // namespace
}  // namespace penpose::io
