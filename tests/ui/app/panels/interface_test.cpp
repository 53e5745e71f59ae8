#include "ui/app/interface.h"

#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

namespace penpose::app {
namespace {

void expect_large_enough(const Desk& desk, double dpi) {
  const double least = 9 / 25.4 * dpi;
  ASSERT_GT(desk.interface->targets().size(), 10U);
  for (const auto& [label, area] : desk.interface->targets()) {
    EXPECT_GE(area.height() + 0.5, least) << label;
    EXPECT_GE(area.width() + 0.5, least) << label;
  }
}

TEST(Interface, WhatAPenHasToHitIsAtLeastNineMillimetresOnAnyDisplay) {
  Desk desk("targets");
  desk.begin();
  for (const double dpi : {96.0, 160.0, 220.0}) {
    desk.app->of<Pointer>().resized({static_cast<int>(1280 * dpi / 96), static_cast<int>(800 * dpi / 96)}, dpi);
    desk.frames();
    expect_large_enough(desk, dpi);
    for (const Dialog dialog :
         {Dialog::open, Dialog::save, Dialog::steps, Dialog::tablet, Dialog::sessions, Dialog::unsaved, Dialog::number,
          Dialog::key_name, Dialog::radial, Dialog::recent, Dialog::export_as, Dialog::recover}) {
      desk.show(dialog);
      expect_large_enough(desk, dpi);
      desk.app->of<Dialogs>().show(Dialog::none);
    }
    desk.app->of<PanelState>().radial = PxPoint{600, 400};
    desk.frames();
    expect_large_enough(desk, dpi);
    desk.app->of<PanelState>().radial.reset();
  }
}

TEST(Interface, EverythingThatHasAKeyIsReachedWithoutAKeyboard) {
  Desk desk("reach");
  desk.begin();
  for (const char* label :
       {"Pose", "Redraw", "Hold", "Pin",  "Erase",        "Select", "Rig",    "Clear", "Rest pose",  "Menu", "Undo",
        "Redo", "Front",  "3/4",  "Side", "Whole figure", "Wire",   "Panels", "Key",   "Delete key", "Play", "Onion"}) {
    EXPECT_NE(desk.interface->find(label), nullptr) << label;
  }
  const std::vector<std::pair<std::string, std::vector<const char*>>> sections{
      {"File", {"Open", "Save", "Save as", "Export", "Recent", "Sessions", "Quit"}},
      {"View", {"Light colours", "Full screen", "Larger", "Smaller"}},
      {"Tablet", {"Tablet", "Tablet keys"}},
      {"Help", {"Help", "Shortcuts"}}};
  desk.click("Menu");
  for (const auto& [section, labels] : sections) {
    desk.click(section + "##section");
    for (const char* label : labels) EXPECT_NE(desk.interface->find(label), nullptr) << label;
  }
}

TEST(Interface, PanelsHideAndComeBackWithoutAKeyboard) {
  Desk desk("hide");
  desk.begin();
  desk.click("Panels");
  EXPECT_EQ(desk.interface->find("Pose"), nullptr);
  desk.click("Panels");
  EXPECT_NE(desk.interface->find("Pose"), nullptr);
}

TEST(Interface, TheSearchShowsWhatItFinds) {
  Desk desk("search");
  desk.begin();
  desk.click("##search");
  EXPECT_TRUE(desk.interface->wants_keys());
  desk.interface->text("JAW");
  desk.frames();
  EXPECT_EQ(desk.app->of<PanelState>().own.of<ParameterList>().filter, "JAW");
  EXPECT_NE(desk.interface->find("slider jaw"), nullptr);
  EXPECT_EQ(desk.interface->find("slider cheek_L"), nullptr);
}

TEST(Interface, WhoHasNoKeyboardTypesOnTheScreen) {
  Desk desk("screen-keys");
  desk.begin();
  EXPECT_EQ(desk.interface->find("key j"), nullptr);
  desk.click("##search");
  for (const char* key : {"key j", "key a", "key x", "key Back", "key w"}) {
    desk.click(key);
    EXPECT_TRUE(desk.interface->wants_keys()) << "the field keeps what is typed";
  }
  EXPECT_EQ(desk.app->of<PanelState>().own.of<ParameterList>().filter, "jaw");
  EXPECT_TRUE(desk.document().curves.empty()) << "keys never draw";
  desk.click("key Done");
  EXPECT_FALSE(desk.interface->wants_keys());
  EXPECT_EQ(desk.interface->find("key j"), nullptr);
  // A real key says that there is a keyboard.
  desk.app->of<PanelState>().has_keyboard = true;
  desk.click("##search");
  EXPECT_EQ(desk.interface->find("key j"), nullptr);
}

TEST(Interface, TheMenuAroundThePenStaysOnTheCanvas) {
  Desk desk("radial-place");
  desk.begin();
  const Area free = desk.app->of<Canvas>().free_area();
  for (const PxPoint at : {PxPoint{free.left, free.top}, PxPoint{free.right, free.bottom}}) {
    desk.app->of<PanelState>().radial = at;
    desk.frames();
    for (const auto& [label, area] : desk.interface->targets()) {
      if (label.find("##radial") == std::string::npos) continue;
      EXPECT_TRUE(free.holds({area.left, area.top}) && free.holds({area.right - 1, area.bottom - 1})) << label;
    }
    EXPECT_NE(desk.interface->find("Undo##radial"), nullptr);
  }
}

TEST(Interface, TheMenuOfFilesEndsWithQuit) {
  Desk desk("menu-order");
  desk.begin();
  desk.open_menu("File");
  const double quit = desk.interface->find("Quit")->top;
  for (const char* label : {"Open", "Recent", "Save", "Save as", "Export"}) {
    EXPECT_LT(desk.interface->find(label)->top, quit) << label;
  }
}

TEST(Interface, AMenuLongerThanTheWindowScrollsToItsEnd) {
  Desk desk("menu-small");
  desk.begin();
  desk.app->of<Pointer>().resized({640, 400}, 96);
  desk.frames();
  desk.click("Menu");
  ASSERT_NE(desk.interface->find("Save"), nullptr);
  desk.app->of<Pointer>().moved(desk.interface->find("Save")->middle());
  desk.frames();
  for (int i = 0; i < 12; ++i) {
    desk.app->of<Pointer>().wheel(-1);
    desk.frames(2);
  }
  ASSERT_NE(desk.interface->find("Quit"), nullptr);
  EXPECT_LE(desk.interface->find("Quit")->bottom, 400);
}

TEST(Interface, ACopyIsExportedAndAFileOpenedAgainWithThePenAlone) {
  Desk desk("export");
  desk.begin();
  ASSERT_TRUE(desk.app->of<Files>().save(desk.path("mine.glb")).ok());
  pose_mouth(desk);
  desk.click("Menu");
  desk.click("Export");
  desk.click("This pose alone (.obj)");
  desk.click("Export##now");
  EXPECT_TRUE(std::filesystem::exists(desk.path("mine-export.obj")));
  EXPECT_EQ(desk.app->of<Files>().project(), desk.path("mine.glb")) << "the work stays where it is saved";
  EXPECT_TRUE(desk.app->of<EditingSession>().unsaved());
  desk.click("Menu");
  desk.click("Recent");
  desk.click("mine.glb##recent " + desk.path("mine.glb"));
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::unsaved) << "what is not saved is asked about";
  desk.click("Open without saving");
  EXPECT_TRUE(desk.document().curves.empty());
  EXPECT_EQ(desk.app->of<Files>().project(), desk.path("mine.glb"));
}

TEST(Interface, TheMenuAroundThePenOffersWhatWasChosenForIt) {
  Desk desk("radial");
  desk.begin();
  desk.app->of<Dialogs>().show(Dialog::radial);
  desk.frames();
  desk.click("Redo##place1");
  desk.click("Draw##choose");
  desk.click("Done");
  EXPECT_EQ(desk.app->of<Preferences>().settings().radial[1], Action::tool_draw);
  EXPECT_EQ(load_settings(desk.path("config")).radial[1], Action::tool_draw) << "it is kept";
}

TEST(Interface, AGroupOfParametersIsFoldedLockedAndReset) {
  Desk desk("groups", "builtin:demo");
  desk.begin();
  // With few parameters there are no groups; sketched controls of one first word make one.
  while (desk.document().model->rig->parameters().size() <= 16) {
    const auto& last = desk.document().model->deformers->deformers().back()->sketch();
    ASSERT_TRUE(desk.app->of<EditingSession>().perform(document::MirrorDeformer{last.name}) ||
                desk.app->of<EditingSession>().perform(document::MirrorDeformer{"jaw"}));
  }
  desk.frames();
  desk.app->of<Controls>().set_parameter(4, desk.document().model->rig->parameters()[4].maximum);
  ASSERT_EQ(desk.document().model->rig->parameters()[4].name.substr(0, 5), "brow_");
  desk.frames();
  const auto group = [&] {
    for (const auto& [label, area] : desk.interface->targets()) {
      if (label.ends_with("##group Brows")) return label;
    }
    return std::string("no group Brows");
  };
  desk.hover(group());
  desk.click("##lock group Brows");
  EXPECT_EQ(desk.document().locked.size(), 4U);
  desk.click("\u21ba##reset group Brows");
  EXPECT_DOUBLE_EQ(desk.document().pose[4], 0);
  ASSERT_NE(desk.interface->find("slider brow_inner_L"), nullptr);
  desk.click(group());
  EXPECT_EQ(desk.interface->find("slider brow_inner_L"), nullptr);
}

TEST(Interface, ThePenIsTriedInTheTabletsSettings) {
  Desk desk("try");
  desk.begin();
  desk.app->of<Dialogs>().show(Dialog::tablet);
  desk.frames();
  const Area area = *desk.interface->find("try");
  desk.app->of<TabletEvents>().arrived(1, replay::virtual_pen_identity());
  const auto viewport = desk.app->of<EditingSession>().editor().view().viewport;
  for (int i = 0; i < 20; ++i) {
    desk.now_us += 4000;
    const PxPoint at{area.left + 10 + 4 * i, area.middle().y};
    desk.app->of<TabletEvents>().report(
        1, desk.now_us, replay::virtual_pen_report({at, 0.05 * i, true, i > 0, false, false}, viewport));
    desk.frames(1);
  }
  ASSERT_GT(desk.app->of<Dialogs>().state<PenTrial>().line.size(), 15U);
  EXPECT_TRUE(area.holds(desk.app->of<Dialogs>().state<PenTrial>().line.back())) << "the line is under the pen";
  EXPECT_GT(desk.app->of<Dialogs>().state<PenTrial>().pressure.back(), 0.5);
  EXPECT_TRUE(desk.document().curves.empty());
}

}  // namespace
}  // namespace penpose::app
