#include "ui/app/controls/known_words.h"

#include <gtest/gtest.h>

#include "tests/support/app_desk.h"
#include "tests/support/shared_data.h"
#include "ui/app/dialogs/found_command.h"

// What controls do, in words, in the window.

namespace penpose::app {
namespace {

std::string face() { return (tests::shared_dir() / "meshes" / "ict_face_narrow.glb").string(); }

/// Rests the pointer on something until its tooltip is there.
std::string tip_on(Desk& desk, const std::string& label) {
  const Area* area = desk.interface->find(label);
  EXPECT_NE(area, nullptr) << label;
  if (area == nullptr) return {};
  desk.app->of<Pointer>().moved(area->middle());
  desk.frames(60);
  return desk.interface->tip();
}

TEST(KnownWords, APairIsCalledOnceWhereBothDoTheSame) {
  const document::ControlWords left{{"smile", document::FaceSide::left}};
  const document::ControlWords right{{"smile", document::FaceSide::right}};
  EXPECT_EQ(words_of_pair(left, right), "smile");
  EXPECT_EQ(words_of_pair({{"jaw left"}}, {{"jaw right"}}), "jaw left / jaw right");
}

TEST(KnownWords, StandInTheRowsAndTheNameOfTheFileInTheTooltip) {
  Desk desk("words-rows");
  desk.begin();
  ASSERT_NE(desk.interface->find("words brow inner"), nullptr) << "a pair is called once";
  EXPECT_NE(tip_on(desk, "slider brow_inner_L").find("\nbrow_inner_L"), std::string::npos);
  desk.app->of<Pointer>().moved({600, 300});
  desk.frames();
  EXPECT_EQ(desk.interface->tip(), "") << "the canvas has none";
}

TEST(SharedKnownWords, RowsAreFoundByWordsAndByNames) {
  if (!tests::has_shared()) GTEST_SKIP() << "no shared data";
  Desk desk("words-search", face());
  desk.begin();
  auto& list = desk.app->of<PanelState>().own.of<ParameterList>();
  for (const char* filter : {"smile", "mouthSmile_L", "SMILE, left"}) {
    list.filter = filter;
    desk.frames();
    EXPECT_NE(desk.interface->find("slider mouthSmile_L"), nullptr) << filter;
    EXPECT_EQ(desk.interface->find("slider jawOpen"), nullptr) << filter;
  }
  EXPECT_NE(desk.interface->find("words smile"), nullptr);
  EXPECT_EQ(tip_on(desk, "slider mouthSmile_L"), "smile, left\nmouthSmile_L");
}

TEST(SharedKnownWords, AreWhatIsSaidOfWhatMovedAndWhatSearchFinds) {
  if (!tests::has_shared()) GTEST_SKIP() << "no shared data";
  Desk desk("words-found", face());
  desk.begin();
  auto& editing = desk.app->of<EditingSession>();
  EXPECT_EQ(editing.words_of("mouthFrown_R"), "mouth corner down, right");
  EXPECT_EQ(editing.words_of("no such control"), "no such control");
  const Settings& settings = desk.app->of<Preferences>().settings();
  const SearchedIn in{desk.document(), settings.keys, 24, settings.recent, editing.words()};
  for (const char* text : {"mouth corner down, right", "mouthfrown_r"}) {
    const auto found = find_commands(in, text);
    ASSERT_FALSE(found.empty()) << text;
    EXPECT_EQ(found.front().text, "mouth corner down, right");
    EXPECT_EQ(found.front().control, "mouthFrown_R");
  }
}

TEST(SharedKnownWords, ShapesWhoseNamesSayNothingAreGroupedByWhatTheyMove) {
  if (!tests::has_shared()) GTEST_SKIP() << "no shared data";
  Desk desk("words-groups", face());
  desk.begin();
  const auto& targets = desk.interface->targets();
  const auto has = [&](const std::string& part) {
    return std::any_of(targets.begin(), targets.end(),
                       [&](const auto& one) { return one.first.find(part) != std::string::npos; });
  };
  EXPECT_TRUE(has("group Brows"));
  document::Model model = *desk.document().model;
  std::vector<rig::BlendShape> shapes(model.shapes->shapes().begin(), model.shapes->shapes().end());
  for (std::size_t i = 0; i < shapes.size(); ++i) shapes[i].parameter.name = "shape_" + std::to_string(i);
  const auto made = rig::BlendShapes::make(std::move(shapes), model.mesh->vertex_count()).value();
  auto renamed = document::make_model(model.mesh, made, model.skeleton).value();
  desk.app->of<EditingSession>().open(document::make_document(std::move(renamed)), nullptr, "");
  desk.frames();
  EXPECT_TRUE(has("group Brows"));
  EXPECT_TRUE(has("words brow down"));
}

}  // namespace
}  // namespace penpose::app
