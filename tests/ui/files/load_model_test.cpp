#include "ui/files/load_model.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace penpose::files {
namespace {

document::Model two_shapes() {
  mesh::MeshSource source;
  source.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  source.triangles = {{0, 1, 2}};
  std::vector<rig::BlendShape> shapes(2);
  shapes[0].parameter.name = "jawOpen";
  shapes[1].parameter.name = "odd=name";
  for (auto& shape : shapes) {
    shape.vertices = {0};
    shape.deltas = {{0, 0, 1}};
  }
  return document::make_model(mesh::TriangleMesh::build(source).value(), rig::BlendShapes::make(shapes, 3).value(),
                              nullptr)
      .value();
}

TEST(LoadModel, SetsParametersByName) {
  auto model = two_shapes();
  EXPECT_TRUE(set_parameter(model, "jawOpen=0.25").ok());
  EXPECT_TRUE(set_parameter(model, "odd=name=1").ok());
  EXPECT_EQ(model.pose, (rig::Pose{0.25, 1}));
}

TEST(LoadModel, RefusesWhatItCannotSetAndSaysWhatWasMeant) {
  auto model = two_shapes();
  EXPECT_EQ(set_parameter(model, "jawopn=0.5").error().remedy, "did you mean jawOpen?");
  EXPECT_EQ(set_parameter(model, "jawOpen=2").error().remedy, "use 0 to 1");
  for (const char* bad : {"jawOpen", "jawOpen=", "jawOpen=x", "=1", "jawOpen=nan"}) {
    EXPECT_FALSE(set_parameter(model, bad).ok()) << bad;
  }
  EXPECT_EQ(model.pose, (rig::Pose{0, 0}));
}

TEST(LoadModel, ReadsAFileAndReportsWhatIsMissing) {
  EXPECT_FALSE(load_model("/nonexistent/model.glb").ok());
  const auto path = std::filesystem::temp_directory_path() / ("penpose_load_" + std::to_string(::getpid()) + ".off");
  std::ofstream(path) << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const auto model = load_model(path.string());
  std::filesystem::remove(path);
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model->mesh->triangle_count(), 1U);
}

TEST(LoadModel, ANameTellsHowCoordinatesAreMeant) {
  const auto folder = std::filesystem::temp_directory_path() / ("penpose-names-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const std::string path = (folder / "lying.obj").string();
  std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 2 4\nf 1 4 3\n";
  for (const io::Orientation meant : {io::Orientation{}, io::Orientation{io::Up::z, false},
                                      io::Orientation{io::Up::y, true}, io::Orientation{io::Up::z, true}}) {
    const std::string text = ModelName{path, meant}.text();
    const ModelName name = model_name(text);
    EXPECT_EQ(name.file, path);
    EXPECT_EQ(name.orientation.up, meant.up);
    EXPECT_EQ(name.orientation.left_handed, meant.left_handed);
    const auto model = load_model(text);
    ASSERT_TRUE(model.ok()) << text;
    const auto& box = model->mesh->rest_box();
    EXPECT_EQ(box.maximum.y, meant.up == io::Up::z ? 3 : 2) << text;
    EXPECT_EQ(box.minimum.x, meant.left_handed ? -1 : 0) << text;
  }
  EXPECT_FALSE(load_model("builtin:head?up=z").ok()) << "it says itself what is up";
  // A file that is really called so is that file.
  std::filesystem::copy_file(path, path + "?up=z");
  const auto model = load_model(path + "?up=z");
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model->mesh->rest_box().maximum.y, 2);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace penpose::files
