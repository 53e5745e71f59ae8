#include "ui/app/cast/cast.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <map>

#include "tests/support/app_desk.h"
#include "tests/support/app_replay.h"
#include "ui/app/view/draw_frame.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"
#include "ui/files/save_model.h"
#include "ui/files/session_model.h"

namespace penpose::app {
namespace {

/// The head with its controls, and the plain head beside it, which is worked on.
class TwoHeads : public ::testing::Test {
 protected:
  void SetUp() override {
    desk_.begin();
    ASSERT_TRUE(files().add("builtin:head").ok());
    desk_.frames();
  }
  [[nodiscard]] Files& files() { return desk_.app->of<Files>(); }
  [[nodiscard]] Cast& cast() { return desk_.app->of<Cast>(); }
  [[nodiscard]] EditingSession& editing() { return desk_.app->of<EditingSession>(); }
  void work_on(const std::string& name) {
    desk_.click(name + "##character " + name);
    ASSERT_EQ(cast().at(cast().active()).name, name);
  }
  /// Where the middle of a character is seen.
  [[nodiscard]] PxPoint seen(std::size_t character) {
    const document::View& view = desk_.app->of<Canvas>().view();
    const auto camera = geometry::Camera::make(view.camera, view.viewport);
    const auto middle = placed(inverse(cast().at(cast().active()).placement), cast().box(character).center());
    return *camera->project(middle);
  }
  [[nodiscard]] DrawFrame drawn() {
    App& app = *desk_.app;
    FrameMaker frames({app.of<EditingSession>(), app.of<Canvas>(), app.of<CanvasLook>(), app.of<CanvasDrawing>(),
                       app.of<Controls>(), app.of<Preferences>(), app.of<Cast>()});
    return frames.make();
  }

  Desk desk_{::testing::UnitTest::GetInstance()->current_test_info()->name()};
};

TEST_F(TwoHeads, TheNewOneStandsBesideTheFirstAndBothAreDrawn) {
  ASSERT_EQ(cast().size(), 2U);
  EXPECT_EQ(cast().active(), 1U);
  EXPECT_EQ(cast().at(0).name, "demo");
  EXPECT_EQ(cast().at(1).name, "head");
  EXPECT_LT(cast().box(0).maximum.x, cast().box(1).minimum.x) << "they do not overlap";
  EXPECT_NEAR(cast().box(0).center().y, cast().box(1).center().y, 0.05 * cast().box(0).diagonal());
  const std::size_t one = desk_.document().model->mesh->vertex_count();
  const std::size_t other = cast().document(0).model->mesh->vertex_count();
  const DrawFrame frame = drawn();
  EXPECT_EQ(frame.positions->size(), one + other);
  ASSERT_TRUE(frame.overlay);
  EXPECT_GT(frame.overlay->front().a, 0) << "the one that is not worked on recedes";
  EXPECT_EQ(frame.overlay->back().a, 0);
  desk_.press('h', false, true);
  EXPECT_EQ(drawn().positions->size(), one) << "the others are hidden";
  desk_.press('h', false, true);
  EXPECT_EQ(drawn().positions->size(), one + other);
}

TEST_F(TwoHeads, EachHasItsPoseItsStepsAndItsSession) {
  const auto plain = editing().state();
  work_on("demo");
  const std::string jaw = desk_.document().model->rig->parameters()[0].name;
  desk_.set(jaw, desk_.document().model->rig->parameters()[0].maximum);
  const auto posed = editing().state();
  const std::string session = desk_.app->of<Recording>().path();
  work_on("head");
  EXPECT_EQ(editing().state(), plain);
  EXPECT_EQ(editing().steps().can_undo(), 0U) << "what was done to the other one is no step of this one";
  EXPECT_NE(desk_.app->of<Recording>().path(), session);
  sketch_chin(desk_);
  EXPECT_GT(editing().steps().can_undo(), 0U);
  const auto sketched = editing().state();
  const std::string other_session = desk_.app->of<Recording>().path();
  work_on("demo");
  EXPECT_EQ(editing().state(), posed);
  desk_.press('z', true);
  EXPECT_NE(editing().state(), posed);
  desk_.press('z', true, true);
  EXPECT_EQ(editing().state(), posed);
  for (const auto& [path, state] : {std::pair(session, posed), std::pair(other_session, sketched)}) {
    const auto played = replayed(path);
    ASSERT_TRUE(played.ok());
    EXPECT_EQ(played->differing, 0U);
    EXPECT_EQ(played->session->editor().state(), state) << path;
  }
}

TEST_F(TwoHeads, ATouchWithSelectWorksOnTheOneThatIsTouchedAndThePictureStays) {
  desk_.click("Select");
  const PxPoint first = seen(0);
  const PxPoint second = seen(1);
  desk_.stroke({first, first});
  EXPECT_EQ(cast().active(), 0U);
  EXPECT_LT(std::hypot(seen(0).x - first.x, seen(0).y - first.y), 1e-6);
  EXPECT_LT(std::hypot(seen(1).x - second.x, seen(1).y - second.y), 1e-6);
  desk_.press(k_key_tab, true);
  EXPECT_EQ(cast().active(), 1U) << "the key for the next one";
}

TEST_F(TwoHeads, PlaceMovesTheOneUnderThePenAndTheFilesAreUnsavedThen) {
  const std::string path = desk_.path("two.glb");
  ASSERT_TRUE(files().save(path).ok());
  EXPECT_FALSE(files().unsaved());
  desk_.app->of<Actions>().run(Action{"tool_place"});
  desk_.frames();
  for (const std::size_t character : {std::size_t{0}, std::size_t{1}}) {
    const PxPoint from = seen(character);
    const PxPoint other = seen(1 - character);
    desk_.stroke({from, from + PxPoint{30, -20}});
    EXPECT_NEAR(seen(character).x, from.x + 30, 2) << character;
    EXPECT_NEAR(seen(character).y, from.y - 20, 2) << character;
    EXPECT_NEAR(seen(1 - character).x, other.x, 1e-6) << character;
  }
  EXPECT_EQ(cast().active(), 1U) << "a drag is no touch";
  EXPECT_TRUE(files().unsaved());
}

TEST_F(TwoHeads, TheOthersPlayAlong) {
  work_on("demo");
  const std::string jaw = desk_.document().model->rig->parameters()[0].name;
  desk_.click("Key");
  desk_.app->of<Playback>().go_to(1);
  desk_.set(jaw, desk_.document().model->rig->parameters()[0].maximum);
  desk_.click("Key");
  work_on("head");
  EXPECT_EQ(desk_.app->of<Playback>().time_s(), 1) << "the timeline is shared";
  EXPECT_EQ(desk_.app->of<Playback>().last_s(), 1);
  const auto at_end = *drawn().positions;
  desk_.app->of<Playback>().scrub(0);
  desk_.frames();
  EXPECT_NE(*drawn().positions, at_end) << "the other one is at its first key";
  EXPECT_EQ(cast().document(0).pose, desk_.app->of<Cast>().document(0).timeline->keys.back().pose)
      << "and its document did not change";
}

TEST_F(TwoHeads, OneProjectKeepsAllAndOpensAsTheyWere) {
  const std::string path = desk_.path("two.glb");
  work_on("demo");
  desk_.set(desk_.document().model->rig->parameters()[0].name, desk_.document().model->rig->parameters()[0].maximum);
  cast().rename(1, "Otto");
  cast().place(1, {{0.4, 0.1, -0.2}, 20, 0.8});
  ASSERT_TRUE(files().save(path).ok());
  EXPECT_FALSE(files().unsaved());
  document::DocumentHasher hasher;
  const auto first = hasher(cast().document(0));
  const auto second = hasher(cast().document(1));
  // Alone each opens by its number, for the program's other commands and for sessions.
  EXPECT_EQ(hasher(*files::load_document(path)), first);
  EXPECT_EQ(hasher(*files::load_document(path + "?character=2")), second);
  EXPECT_FALSE(files::load_document(path + "?character=3").ok());
  ASSERT_TRUE(files().open(path).ok());
  desk_.frames();
  ASSERT_EQ(cast().size(), 2U);
  EXPECT_EQ(cast().active(), 0U);
  EXPECT_EQ(cast().at(1).name, "Otto");
  EXPECT_EQ(cast().at(1).placement, (geometry::Placement{{0.4, 0.1, -0.2}, 20, 0.8}));
  EXPECT_EQ(hasher(cast().document(0)), first);
  EXPECT_EQ(hasher(cast().document(1)), second);
  EXPECT_FALSE(files().unsaved());
  EXPECT_EQ(files().project(), path);
  // Saved over itself, the session that began on it still replays.
  work_on("Otto");
  sketch_chin(desk_);
  const std::string session = desk_.app->of<Recording>().path();
  desk_.press('s', true);
  EXPECT_FALSE(files().unsaved());
  replay::PlayerOptions options;
  options.open = [&](const std::string& named) {
    return files::load_document(files::find_session_model(session, named));
  };
  const auto bytes = files::read_plain_file(session);
  ASSERT_TRUE(bytes.ok());
  const auto played = replay::play_session(replay::read_from(*bytes), options);
  ASSERT_TRUE(played.ok()) << played.error().line();
  EXPECT_EQ(played->differing, 0U);
  EXPECT_EQ(played->session->editor().state(), editing().state());
}

TEST_F(TwoHeads, AProjectOfOneStaysAsItIs) {
  files().remove(1);
  desk_.frames();
  ASSERT_EQ(cast().size(), 1U);
  ASSERT_TRUE(files().save(desk_.path("one.glb")).ok());
  ASSERT_TRUE(files::save_document(desk_.document(), desk_.path("plain.glb"), files::SaveNotes::quiet).ok());
  EXPECT_EQ(*files::read_plain_file(desk_.path("one.glb")), *files::read_plain_file(desk_.path("plain.glb")));
  cast().bring_back();
  EXPECT_EQ(cast().size(), 2U);
  EXPECT_TRUE(files().unsaved());
}

TEST_F(TwoHeads, EachIsExportedIntoAFileOfItsOwn) {
  ASSERT_TRUE(files().export_each(desk_.path("out.glb")).ok());
  for (std::size_t i = 0; i < 2; ++i) {
    const auto one = files::load_model(desk_.path("out-" + cast().at(i).name + ".glb"));
    ASSERT_TRUE(one.ok());
    EXPECT_EQ(one->mesh->vertex_count(), cast().document(i).model->mesh->vertex_count());
  }
  EXPECT_FALSE(files().save(desk_.path("two.vrm")).ok()) << "one file of that form has one character";
}

TEST_F(TwoHeads, APoseIsCopiedToARigWithOtherNames) {
  work_on("demo");
  const std::size_t jaw = desk_.index_of("jaw");
  std::vector<std::string> names;
  for (const auto& parameter : desk_.document().model->rig->parameters()) names.push_back(parameter.name);
  for (std::size_t i = 0; i < names.size(); ++i) desk_.app->of<Controls>().rename(names[i], "c" + std::to_string(i));
  ASSERT_EQ(desk_.document().model->rig->parameters()[jaw].name, "c" + std::to_string(jaw));
  const std::string path = desk_.path("renamed.glb");
  ASSERT_TRUE(files::save_document(desk_.document(), path, files::SaveNotes::quiet).ok());
  while (editing().steps().can_undo() > 0) editing().steps().undo();
  desk_.set("jaw", 0.8);
  desk_.press('c', true);
  ASSERT_TRUE(files().add(path).ok());
  desk_.frames();
  ASSERT_EQ(desk_.document().pose[jaw], 0);
  desk_.press('v', true);
  EXPECT_NEAR(desk_.document().pose[jaw], 0.8, 0.2) << "by what controls do";
  EXPECT_EQ(desk_.document().timeline->keys.size(), 1U);
  desk_.press('z', true);
  EXPECT_EQ(desk_.document().pose[jaw], 0) << "in one step";
}

TEST(Cast, AfterACrashAllComeBackTogether) {
  const std::string name = "cast-crash";
  std::map<std::string, std::string> left;
  document::DocumentState first;
  document::DocumentState second;
  geometry::Placement placement;
  {
    Desk desk(name);
    desk.begin();
    desk.set(desk.document().model->rig->parameters()[0].name, desk.document().model->rig->parameters()[0].maximum);
    first = desk.app->of<EditingSession>().state();
    ASSERT_TRUE(desk.app->of<Files>().add("builtin:head").ok());
    desk.frames();
    sketch_chin(desk);
    second = desk.app->of<EditingSession>().state();
    placement = desk.app->of<Cast>().at(1).placement;
    for (const auto& file : std::filesystem::directory_iterator(desk.path("state/sessions"))) {
      std::ifstream in(file.path(), std::ios::binary);
      left[file.path().string()] = {std::istreambuf_iterator<char>(in), {}};
    }
  }
  for (const auto& [path, bytes] : left) std::ofstream(path, std::ios::binary) << bytes;
  Desk desk(name, "builtin:demo", false);
  ASSERT_EQ(desk.app->of<Dialogs>().open(), Dialog::recover);
  desk.click("Bring it back");
  const Cast& cast = desk.app->of<Cast>();
  ASSERT_EQ(cast.size(), 2U);
  EXPECT_EQ(cast.active(), 1U);
  EXPECT_EQ(desk.app->of<EditingSession>().state(), second);
  EXPECT_EQ(cast.at(1).placement, placement);
  EXPECT_TRUE(desk.app->of<Files>().unsaved());
  EXPECT_NE(desk.app->of<Dialogs>().open(), Dialog::recover) << "they were asked about together";
  desk.app->of<Files>().work_on(0);
  desk.frames();
  EXPECT_EQ(desk.app->of<EditingSession>().state(), first);
}

}  // namespace
}  // namespace penpose::app
