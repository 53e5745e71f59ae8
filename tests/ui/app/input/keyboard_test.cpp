#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

// What a keyboard does while a dialog, a menu or a text field is there.

namespace penpose::app {
namespace {

void open_number(Desk& desk) {
  desk.app->of<PanelState>().own.of<ParameterList>().filter = "jaw";
  desk.frames();
  desk.touch_row("name jaw");
  desk.click("Type a value##type jaw");
}

double jaw_of(const Desk& desk) {
  return desk.document().pose[*rig::find_parameter(desk.document().model->rig->parameters(), "jaw")];
}

TEST(Keyboard, ANumberIsTypedWithoutTouchingTheField) {
  Desk desk("type-number");
  desk.begin();
  open_number(desk);
  desk.type("0.54");
  desk.hit_backspace();
  EXPECT_EQ(desk.app->of<Dialogs>().state<NumberEntry>().text, "0.5") << "not even the first digit is lost";
  EXPECT_EQ(desk.interface->find("key q"), nullptr) << "no keys on the screen for whoever has a keyboard";
  desk.hit_return();
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
  EXPECT_DOUBLE_EQ(jaw_of(desk), 0.5);
  open_number(desk);
  desk.type("-");
  desk.hit_return();
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::number) << "what is no number is told";
  desk.hit_escape();
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
  EXPECT_DOUBLE_EQ(jaw_of(desk), 0.5);
}

TEST(Keyboard, TheNumberPadAndTheKeysMix) {
  Desk desk("mix");
  desk.begin();
  open_number(desk);
  desk.click("0##pad");
  desk.click(".##pad");
  desk.type("2");
  desk.click("5##pad");
  EXPECT_EQ(desk.app->of<Dialogs>().state<NumberEntry>().text, "0.25");
  desk.type("1");
  EXPECT_EQ(desk.app->of<Dialogs>().state<NumberEntry>().text, "0.251");
  desk.hit_return();
  EXPECT_DOUBLE_EQ(jaw_of(desk), 0.251);
}

TEST(Keyboard, ReturnTakesAKeysNameAndEscapeForgetsIt) {
  Desk desk("type-name");
  desk.begin();
  desk.hit(12, 'i');
  desk.click("More##more of time");
  desk.click("Name##key");
  desk.frames(2);
  EXPECT_TRUE(desk.interface->wants_keys()) << "the field has the keyboard when it opens";
  desk.type("smile");
  desk.hit_return();
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
  ASSERT_EQ(desk.document().timeline->keys.size(), 1U);
  EXPECT_EQ(desk.document().timeline->keys.front().name, "smile");
  desk.click("More##more of time");
  desk.click("Name##key");
  desk.type("grin");
  desk.hit_escape();
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
  EXPECT_EQ(desk.document().timeline->keys.front().name, "smile");
  EXPECT_EQ(desk.app->of<EditingSession>().editor().tool().kind, drawing::ToolKind::pose) << "letters chose no tool";
}

TEST(Keyboard, EscapeClosesEveryDialogAndReturnDoesWhatItIsFor) {
  Desk desk("dialogs");
  desk.begin();
  for (const Dialog dialog :
       {Dialog::open, Dialog::recent, Dialog::save, Dialog::export_as, Dialog::steps, Dialog::tablet, Dialog::sessions,
        Dialog::unsaved, Dialog::number, Dialog::key_name, Dialog::radial, Dialog::recover}) {
    desk.show(dialog);
    desk.hit_escape();
    EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none) << dialog.name;
  }
  for (const Dialog dialog : {Dialog::steps, Dialog::tablet, Dialog::sessions, Dialog::radial}) {
    desk.app->of<Dialogs>().show(dialog);
    desk.frames();
    desk.hit_return();
    EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none) << dialog.name;
  }
  desk.hit(22, 's', true);
  desk.type("mine");
  desk.hit_return();
  EXPECT_TRUE(std::filesystem::exists(desk.path("mine.glb"))) << "the ending of the name that is offered stays";
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
}

TEST(Keyboard, ReturnSavesFirstAndThenWhatWasAskedForIsDone) {
  Desk desk("save-first");
  desk.begin();
  pose_mouth(desk);
  desk.hit(20, 'q', true);
  ASSERT_EQ(desk.app->of<Dialogs>().open(), Dialog::unsaved);
  desk.hit_return();
  ASSERT_EQ(desk.app->of<Dialogs>().open(), Dialog::save);
  EXPECT_FALSE(desk.app->of<Leaving>().wants_quit());
  desk.hit_return();
  EXPECT_TRUE(std::filesystem::exists(desk.path("head.glb")));
  EXPECT_TRUE(desk.app->of<Leaving>().wants_quit());
}

TEST(Keyboard, EscapeClosesTheMenuAndTheNextStrokeDraws) {
  Desk desk("menu-escape");
  desk.begin();
  desk.click("Rig");
  ASSERT_TRUE(desk.document().pending);
  desk.click("Menu");
  ASSERT_NE(desk.interface->find("Quit"), nullptr);
  desk.hit_escape();
  EXPECT_EQ(desk.interface->find("Quit"), nullptr);
  EXPECT_TRUE(desk.document().pending) << "what is being sketched goes on";
  desk.click("Pose");
  desk.stroke(desk.named_curve(any_curve(desk)));
  EXPECT_EQ(desk.document().curves.size(), 1U);
}

TEST(Keyboard, ReturnRenamesAControl) {
  Desk desk("rename-return");
  desk.begin();
  desk.click("Controls");
  desk.app->of<Controls>().select(desk.document().model->deformers->deformers().front()->sketch().name);
  desk.frames();
  desk.click("##rename");
  desk.type("grin");
  desk.hit_return();
  EXPECT_EQ(desk.document().model->deformers->deformers().front()->sketch().name, "grin");
  EXPECT_EQ(desk.app->of<Controls>().selected(), "grin");
}

TEST(Keyboard, BehindADialogNothingIsPressedAndNoKeyDoesAnything) {
  Desk desk("behind");
  desk.begin();
  const Area key = *desk.interface->find("Key");
  desk.app->of<Dialogs>().show(Dialog::tablet);
  desk.frames();
  desk.app->of<Pointer>().moved(key.middle());
  desk.app->of<Pointer>().button(MouseButton::left, true, key.middle());
  desk.app->of<Pointer>().button(MouseButton::left, false, key.middle());
  desk.frames();
  desk.hit(12, 'i');
  EXPECT_TRUE(desk.document().timeline->keys.empty());
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::tablet);
  desk.click("Done");
  desk.hit(12, 'i');
  EXPECT_EQ(desk.document().timeline->keys.size(), 1U);
}

TEST(Keyboard, WhatIsTypedInTheSlowFrameOfAClickIntoAFieldIsTyped) {
  Desk desk("slow-frame");
  desk.begin();
  const auto tool = desk.app->of<EditingSession>().editor().tool().kind;
  const PxPoint field = desk.interface->find("##search")->middle();
  desk.app->of<Pointer>().moved(field);
  desk.app->of<Pointer>().button(MouseButton::left, true, field);
  desk.app->of<Pointer>().button(MouseButton::left, false, field);
  // No frame has been made since: "e" would be the eraser and "i" a key.
  desk.type("ie");
  EXPECT_EQ(desk.app->of<PanelState>().own.of<ParameterList>().filter, "ie");
  EXPECT_EQ(desk.app->of<EditingSession>().editor().tool().kind, tool);
  EXPECT_TRUE(desk.document().timeline->keys.empty());
}

TEST(Keyboard, KeysInTheSlowFrameOfAClickOnAButtonAreTheProgramsOwn) {
  Desk desk("slow-button");
  desk.begin();
  const PxPoint button = desk.interface->find("Hold")->middle();
  desk.app->of<Pointer>().moved(button);
  desk.app->of<Pointer>().button(MouseButton::left, true, button);
  desk.app->of<Pointer>().button(MouseButton::left, false, button);
  desk.type("i");
  EXPECT_EQ(desk.document().timeline->keys.size(), 1U);
  EXPECT_EQ(desk.app->of<EditingSession>().editor().tool().kind, drawing::ToolKind::constraint);
}

TEST(Keyboard, PlusIsTheSameWhetherItIsTypedWithShiftOrNot) {
  Desk desk("plus");
  desk.begin();
  double& scale = desk.app->of<Preferences>().settings().scale;
  const KeyStroke strokes[] = {{'=', true, false}, {'=', true, true}, {'+', true, false}};
  for (const KeyStroke& stroke : strokes) {
    scale = 1;
    desk.hit(46, stroke.key, stroke.ctrl, stroke.shift);
    EXPECT_DOUBLE_EQ(scale, 1.25) << static_cast<char>(stroke.key) << stroke.shift;
  }
  scale = 1;
  desk.hit(45, '-', true);
  EXPECT_DOUBLE_EQ(scale, 0.75);
}

}  // namespace
}  // namespace penpose::app
