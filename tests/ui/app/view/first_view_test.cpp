#include <fstream>
#include <gtest/gtest.h>

#include "core/document/look.h"
#include "tests/support/app_desk.h"
#include "tests/support/models/gltf_sample.h"

namespace penpose::app {
namespace {

/// A figure ten units high in a file of its own: a board with a small square at its top that a morph target moves, and
/// a picture on it.
std::string figure_file(const std::string& name) {
  tests::GltfSample sample;
  sample.add_vec3({-1, 0, 0, 1, 0, 0, 1, 10, 0, -1, 10, 0});
  sample.add_corners({0, 1, 2, 0, 2, 3});
  sample.add_vec3({-0.5F, 9, 0.1F, 0.5F, 9, 0.1F, 0.5F, 10, 0.1F, -0.5F, 10, 0.1F});
  sample.add_vec3({0, 0, 0, 0, 0, 0, 0, 0.2F, 0, 0, 0.2F, 0});
  sample.add_vec3({1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1});
  sample.add("meshes", {{"name", "board"}, {"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}});
  sample.add("meshes",
             {{"name", "face"},
              {"primitives",
               {{{"attributes", {{"POSITION", 2}, {"COLOR_0", 4}}}, {"indices", 1}, {"targets", {{{"POSITION", 3}}}}}}},
              {"extras", {{"targetNames", {"smile"}}}}});
  sample.add("nodes", {{"name", "board"}, {"mesh", 0}});
  sample.add("nodes", {{"name", "face"}, {"mesh", 1}});
  sample.add("scenes", {{"nodes", {0, 1}}});
  const auto folder = Desk::folder_of(name + "_file");
  std::filesystem::create_directories(folder);
  const auto path = (folder / "figure.glb").string();
  const auto bytes = sample.glb();
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
  return path;
}

PxPoint seen(Desk& desk, const geometry::ModelPoint& p) {
  const auto& view = desk.app->of<Canvas>().view();
  return geometry::Camera::make(view.camera, view.viewport)->project(p).value();
}

TEST(FirstView, AWholeFigureIsMetFaceToFaceAndIsAKeyAway) {
  Desk desk("first_view", figure_file("first_view"));
  desk.begin();
  const double face = seen(desk, {0, 9, 0.1}).y - seen(desk, {0, 10, 0.1}).y;
  const double free = desk.app->of<Canvas>().free_area().height();
  EXPECT_GT(face, 0.4 * free);
  desk.press('f');
  const double whole = seen(desk, {0, 0, 0}).y - seen(desk, {0, 10, 0}).y;
  EXPECT_LT(whole, free);
  EXPECT_GT(whole, 0.7 * free);
  desk.press('f', false, true);
  EXPECT_NEAR(seen(desk, {0, 9, 0.1}).y - seen(desk, {0, 10, 0.1}).y, face, 1);
}

TEST(FirstView, ClayIsAKeyAway) {
  Desk desk("clay_key", figure_file("clay_key"));
  desk.begin();
  EXPECT_NE(desk.app->of<Canvas>().surface().appearance().look, nullptr);
  EXPECT_FALSE(desk.app->of<CanvasLook>().clay);
  desk.press('c', false, true);
  EXPECT_TRUE(desk.app->of<CanvasLook>().clay);
}

TEST(FirstView, MatcapAndClayTakeTurns) {
  Desk desk("matcap", figure_file("matcap"));
  desk.begin();
  const CanvasLook& look = desk.app->of<CanvasLook>();
  desk.app->of<Actions>().run(Action{"matcap"});
  EXPECT_TRUE(look.matcap);
  desk.app->of<Actions>().run(Action::clay);
  EXPECT_TRUE(look.clay);
  EXPECT_FALSE(look.matcap);
  desk.app->of<Actions>().run(Action{"textured"});
  EXPECT_FALSE(look.clay || look.matcap);
}

TEST(FirstView, WhatStandsBehindADialogIsStillThereAfterIt) {
  Desk desk("behind_dialog");
  auto& notices = desk.app->of<Notices>();
  desk.app->of<Dialogs>().show(Dialog::steps);
  notices.tell("something");
  desk.now_us += 60'000'000;
  desk.app->advance();
  ASSERT_EQ(notices.all().size(), 1U);
  desk.app->of<Dialogs>().show(Dialog::none);
  desk.now_us += 60'000'000;
  desk.app->advance();
  EXPECT_TRUE(notices.all().empty());
}

TEST(FirstView, NotesOfTheModelListWhatCannotBeDrawn) {
  Desk desk("model_notes");
  auto& undrawn = desk.app->of<UndrawnTextures>();
  document::Model model = *desk.document().model;
  document::Look look;
  look.undrawn = {"skin.ktx2 (KTX2)"};
  model.look = std::make_shared<const document::Look>(look);
  model.notes = {document::undrawn_note(look.undrawn), "3 vertices were left out"};
  undrawn.begin(model);
  EXPECT_EQ(notes_of(model, undrawn),
            (std::vector<std::string>{"this texture cannot be drawn: skin.ktx2 (KTX2)", "3 vertices were left out"}));
}

TEST(FirstView, TexturesThatCannotBeDrawnAreToldInOneNotice) {
  Desk desk("undrawn");
  auto& undrawn = desk.app->of<UndrawnTextures>();
  document::Model model = *desk.document().model;
  document::Look look;
  look.undrawn = {"skin.ktx2 (KTX2)"};
  model.look = std::make_shared<const document::Look>(look);
  const auto told = [&] {
    std::vector<std::string> texts;
    for (const Notice& one : desk.app->of<Notices>().all()) texts.push_back(one.text);
    return texts;
  };
  undrawn.begin(model);
  ASSERT_EQ(told().size(), 1U);
  EXPECT_EQ(told()[0], "1 texture cannot be drawn and is grey: skin.ktx2 (KTX2)");
  undrawn.add(model.look, {"eyes (is damaged)"});
  ASSERT_EQ(told().size(), 1U) << "one notice for both";
  EXPECT_EQ(told()[0], "2 textures cannot be drawn and are grey: skin.ktx2 (KTX2), eyes (is damaged)");
  undrawn.add(std::make_shared<const document::Look>(), {"of another model (gone)"});
  EXPECT_EQ(told().size(), 1U);
  EXPECT_EQ(told()[0].find("another"), std::string::npos);
}

}  // namespace
}  // namespace penpose::app
