#include "core/io/model/write_model.h"

#include <gtest/gtest.h>

#include "core/io/model/model_formats.h"
#include "tests/support/models/gltf_sample.h"

namespace penpose::io {
namespace {

TEST(WriteModel, TheExtensionChoosesTheFormat) {
  const auto model = tests::square_sample().read().value();
  EXPECT_EQ(format_of_content(write_model(model, "x.glb").value())->extension, ".glb");
  EXPECT_EQ(format_of_content(write_model(model, "x.OBJ").value())->extension, ".obj");
  for (const char* name : {"x.ply", "x", "x.png"}) {
    const auto bytes = write_model(model, name);
    ASSERT_FALSE(bytes.ok());
    EXPECT_FALSE(bytes.error().remedy.empty());
  }
}

}  // namespace
}  // namespace penpose::io
