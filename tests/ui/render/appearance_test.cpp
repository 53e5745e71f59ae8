#include "ui/render/appearance.h"

#include <gtest/gtest.h>

#include "core/io/model/read_model.h"
#include "tests/support/models/render_shapes.h"
#include "tests/support/shared_data.h"

namespace penpose::render {
namespace {

TEST(Appearance, KeepsTheFilesMaterials) {
  document::Model model = sphere_model(1);
  model.materials[0].base_color = {0.1, 0.6, 0.2, 1};
  model.materials[0].roughness = 0.3;
  const Appearance look = make_appearance(model);
  const Surface& surface = look.surfaces[look.surface_of_vertex[0]];
  EXPECT_FLOAT_EQ(surface.base_color.g, 0.6F);
  EXPECT_FLOAT_EQ(surface.roughness, 0.3F);
  EXPECT_TRUE(look.gaze.empty());
}

TEST(Appearance, AKindThatIsGivenWins) {
  mesh::MeshSource source;
  add_sphere(source, geometry::ModelPoint{0}, 1);
  add_box(source, {3, 0, 0}, {0.2, 0.2, 0.2});
  const auto model = model_of(source);
  AppearanceOptions options;
  options.kinds = {{1, PartKind::gum}};
  const Appearance look = make_appearance(model, options);
  const Color gum = look.surfaces[look.surface_of_vertex.back()].base_color;
  EXPECT_GT(gum.r, 2 * gum.b);
  EXPECT_NE(look.surface_of_vertex.back(), look.surface_of_vertex.front());
}

/// A head of a box with two balls in it, and what the balls are called.
mesh::MeshSource head_with_balls(const std::string& name) {
  mesh::MeshSource source;
  add_box(source, {0, 0, -4}, {6, 8, 5});
  source.parts.push_back({"Head", 0, static_cast<std::uint32_t>(source.positions.size()), 0,
                          static_cast<std::uint32_t>(source.triangles.size())});
  for (const double side : {-1.0, 1.0}) {
    const auto vertex = static_cast<std::uint32_t>(source.positions.size());
    const auto triangle = static_cast<std::uint32_t>(source.triangles.size());
    add_sphere(source, {side * 2.5, 1, 1}, 1.2, 12);
    source.parts.push_back({name + (side < 0 ? "Left" : "Right"), vertex,
                            static_cast<std::uint32_t>(source.positions.size()) - vertex, triangle,
                            static_cast<std::uint32_t>(source.triangles.size()) - triangle});
  }
  return source;
}

TEST(Appearance, BlankEyeballsGetAnIrisWhereTheyLook) {
  const document::Model model = model_of(head_with_balls("Eye"));
  const Appearance look = make_appearance(model);
  ASSERT_EQ(look.gaze.size(), model.mesh->vertex_count());
  int pupils = 0;
  for (std::size_t v = 8; v < look.gaze.size(); ++v) {
    if (look.gaze[v] >= 0.19F) continue;
    ++pupils;
    EXPECT_GT(model.mesh->positions()[v].z, 2) << "out of the head";
  }
  EXPECT_GE(pupils, 2);
  for (std::size_t v = 0; v < 8; ++v) EXPECT_EQ(look.gaze[v], 1.0F) << "skin";
}

TEST(Appearance, NothingIsPaintedOnEyesThatHaveAPicture) {
  document::Model model = model_of(head_with_balls("Eye"));
  document::Look look;
  look.surfaces.resize(2);
  look.surfaces[1].texture = document::TextureUse{};
  look.images.resize(1);
  look.surface_of.assign(model.mesh->triangle_count(), 1);
  std::fill_n(look.surface_of.begin(), 12, 0);
  model.look = std::make_shared<const document::Look>(look);
  const Appearance made = make_appearance(model);
  ASSERT_FALSE(made.gaze.empty());
  const auto [least, most] = std::minmax_element(made.gaze.begin(), made.gaze.end());
  EXPECT_FLOAT_EQ(*least, 0.7F) << "wet in front, without an iris of ours";
  EXPECT_FLOAT_EQ(*most, 1.0F);
}

TEST(Appearance, BrowsAndLidsAreNoEyeballs) {
  EXPECT_TRUE(names_eyeball("Wolf3D_Eye"));
  for (const char* name : {"EyebrowLeft", "eyelashes", "EyeLid", "eyeGlasses", "Head"})
    EXPECT_FALSE(names_eyeball(name)) << name;
}

TEST(SharedRender, EyesOfTheWholeFaceLookLikeEyes) {
  if (!tests::has_shared()) GTEST_SKIP();
  const auto bytes = tests::read_file(tests::shared_dir() / "meshes" / "ict_face.glb");
  const auto model = io::read_model(bytes, "ict_face.glb").value();
  const Appearance look = make_appearance(model);
  const PosedMesh posed = posed_mesh(model);
  const Scene scene = scene_of(model, posed, look);
  const auto renderer = make_renderer();
  ASSERT_NE(renderer, nullptr);
  const auto camera = frame_points(posed.positions, {800, 800}, {0, 0});
  const Image image = renderer->render(scene, camera).value();
  const auto pixel = [&](const geometry::ModelPoint& p) {
    const auto px = *camera.project(p);
    return image.at(static_cast<int>(px.x), static_cast<int>(px.y));
  };
  for (const double side : {1.0, -1.0}) {
    // The gaze turns a little outward; the pupil's middle lies on it.
    const std::uint8_t* pupil = pixel({side * (3.1165 + 0.22), 3.6, 9.6});
    EXPECT_LT(pupil[0], 70);
    const std::uint8_t* white = pixel({side * (3.1165 - 0.85), 3.5, 9.2});
    EXPECT_GT(white[2], 95);
    EXPECT_LT(white[0] - white[2], 40) << "white, not skin";
    const std::uint8_t* cheek = pixel({side * 4, 0, 9});
    EXPECT_GT(cheek[0] - cheek[2], 20) << "skin";
  }
}

TEST(SharedRender, EveryModelFillsItsPicture) {
  if (!tests::has_shared()) GTEST_SKIP();
  const auto renderer = make_renderer();
  ASSERT_NE(renderer, nullptr);
  for (const char* name :
       {"ict_face.glb", "ict_face_narrow.glb", "elephant.glb", "cesium_man.glb", "animated_morph_cube.glb"}) {
    const auto bytes = tests::read_file(tests::shared_dir() / "meshes" / name);
    const auto model = io::read_model(bytes, name).value();
    const Appearance look = make_appearance(model);
    const PosedMesh posed = posed_mesh(model);
    const Scene scene = scene_of(model, posed, look);
    const auto camera = frame_points(posed.positions, {200, 200});
    const int covered = differing(renderer->render(scene, camera).value(), renderer->render({}, camera).value());
    EXPECT_GT(covered, 200 * 200 / 12) << name;
    EXPECT_LT(covered, 200 * 200 * 7 / 10) << name;
  }
}

}  // namespace
}  // namespace penpose::render
