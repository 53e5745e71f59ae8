#include <gtest/gtest.h>

#include "core/io/model/write_model.h"
#include "core/io/surface/read_obj.h"
#include "tests/support/models/gltf_sample.h"
#include "tests/support/models/model_samples.h"

namespace penpose::io {
namespace {

TEST(WriteObj, PosedPositionsAndPartsReadBack) {
  const auto model = tests::full_model();
  const auto bytes = write_obj(model).value();
  const auto again = read_obj(bytes);
  ASSERT_TRUE(again.ok()) << again.error().line();
  const auto posed = document::posed_positions(model);
  ASSERT_EQ(again->mesh->vertex_count(), posed.size());
  for (std::size_t v = 0; v < posed.size(); ++v) {
    EXPECT_EQ(glm::vec3(again->mesh->positions()[v]), glm::vec3(posed[v])) << v;
  }
  ASSERT_EQ(again->mesh->parts().size(), 5U);
  EXPECT_EQ(again->mesh->parts()[3].name, "arm");
  EXPECT_EQ(again->mesh->parts()[3].first_vertex, 12U);
  EXPECT_TRUE(
      std::equal(again->mesh->triangles().begin(), again->mesh->triangles().end(), model.mesh->triangles().begin()));
}

TEST(WriteObj, NamesStayOnTheirLine) {
  mesh::MeshSource source;
  tests::add_square(source, "a\nv 1 2 3", 0);
  const auto bytes = write_obj(tests::must_make(std::move(source), {}, {}, {})).value();
  const auto again = read_obj(bytes);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->mesh->vertex_count(), 4U);
  EXPECT_EQ(again->mesh->parts()[0].name, "a v 1 2 3");
}

}  // namespace
}  // namespace penpose::io
