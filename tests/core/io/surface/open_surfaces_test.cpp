#include <gtest/gtest.h>

#include "core/io/model/read_model.h"
#include "core/io/model/write_model.h"

namespace penpose::io {
namespace {

struct Surface {
  const char* name;
  std::string text;
};

// A square with a fin on its diagonal, and the first of its triangles again, the other way round.
std::vector<Surface> surfaces() {
  const std::string places = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 1\n";
  const std::string faces = "3 0 1 2\n3 0 2 3\n3 0 2 4\n3 0 2 1\n";
  std::string stl = "solid x\n";
  const char* const at[] = {"0 0 0", "1 0 0", "1 1 0", "0 1 0", "0.5 0.5 1"};
  for (const auto& t : {std::array{0, 1, 2}, std::array{0, 2, 3}, std::array{0, 2, 4}, std::array{0, 2, 1}}) {
    stl += "facet normal 0 0 1\nouter loop\n";
    for (const int v : t) stl += "vertex " + std::string(at[v]) + "\n";
    stl += "endloop\nendfacet\n";
  }
  return {{"fin.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\nf 1 2 3\nf 1 3 4\nf 1 3 5\nf 1 3 2\n"},
          {"fin.off", "OFF\n5 4 0\n" + places + faces},
          {"fin.ply",
           "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
           "element face 4\nproperty list uchar int vertex_indices\nend_header\n" +
               places + faces},
          {"fin.stl", stl + "endsolid x\n"}};
}

TEST(OpenSurfaces, NoFormatRefusesAThirdTriangleAtAnEdge) {
  for (const Surface& surface : surfaces()) {
    const auto model = read_model(base::as_bytes(surface.text), surface.name);
    ASSERT_TRUE(model.ok()) << surface.name << ": " << model.error().line();
    EXPECT_EQ(model->mesh->triangle_count(), 4U) << surface.name;
    if (std::string_view(surface.name) != "fin.stl") {
      EXPECT_EQ(model->mesh->vertex_count(), 5U) << surface.name;
      ASSERT_EQ(model->notes.size(), 1U) << surface.name;
      EXPECT_NE(model->notes[0].find("2 triangles"), std::string::npos) << model->notes[0];
    }
    const auto again = read_model(write_glb(*model).value(), "x.glb");
    ASSERT_TRUE(again.ok()) << again.error().line();
    EXPECT_EQ(document::state_hash(*again), document::state_hash(*model)) << surface.name;
  }
}

}  // namespace
}  // namespace penpose::io
