#include "ui/files/save_model.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/support/models/test_rigs.h"
#include "ui/files/load_model.h"

namespace penpose::files {
namespace {

TEST(SaveModel, WritesTheFormatOfTheExtension) {
  const auto folder = std::filesystem::temp_directory_path() / ("penpose_save_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const auto mesh = tests::grid_mesh(3, 3);
  auto model = document::make_model(mesh, tests::random_shapes(*mesh, 2, 1), nullptr).value();
  model.pose[1] = 0.5;

  ASSERT_TRUE(save_model(model, (folder / "a.glb").string()));
  const auto glb = load_model((folder / "a.glb").string());
  ASSERT_TRUE(glb) << glb.error().line();
  EXPECT_EQ(document::state_hash(*glb), document::state_hash(model));

  ASSERT_TRUE(save_model(model, (folder / "a.obj").string()));
  const auto obj = load_model((folder / "a.obj").string());
  ASSERT_TRUE(obj);
  EXPECT_EQ(obj->mesh->vertex_count(), 16U);
  EXPECT_TRUE(obj->pose.empty());

  // Any other extension is refused before a file is touched.
  EXPECT_FALSE(save_model(model, (folder / "a.ply").string()));
  EXPECT_FALSE(save_model(model, (folder / "a").string()));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.ply"));
  EXPECT_FALSE(save_model(model, (folder / "missing" / "a.glb").string()));
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++files;
  EXPECT_EQ(files, 2U);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace penpose::files
