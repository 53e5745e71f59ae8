#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

// Which key does what, chosen in the preferences.

namespace penpose::app {
namespace {

constexpr int k_any = 20;  // of a key that edits no text

void open_keys(Desk& desk) {
  desk.begin();
  desk.press(',', true);
  desk.click("Keys##tab");
  desk.click("Keys of the keyboard##preferences");
  ASSERT_EQ(desk.app->of<Dialogs>().open().name, "keyboard");
}
KeyMap kept_keys(const Desk& desk) { return load_settings(desk.path("config")).keys; }
void search(Desk& desk, const char* text) {
  desk.app->of<Dialogs>().state<SearchEntry>().text = text;
  desk.frames();
}

TEST(KeyboardDialog, AKeyIsPressedDoesItAndIsShownAndKept) {
  Desk desk("keys-set");
  open_keys(desk);
  search(desk, "wire");
  desk.click("Shift+Z###key 0 wireframe");
  // With what it types, which is for no field.
  desk.interface->key(k_any, {'q', false, false}, true);
  desk.interface->text("q");
  desk.frames();
  desk.interface->key(k_any, {'q', false, false}, true);
  desk.interface->text("q");
  desk.interface->key(k_any, {'q', false, false}, false);
  desk.frames();
  EXPECT_EQ(desk.app->of<Dialogs>().state<SearchEntry>().text, "wire") << "it was no letter of the search";
  EXPECT_EQ(kept_keys(desk).shortcut_of(Action::wireframe), "Q");
  desk.click("Done##keyboard");
  desk.hit(k_any, 'q');
  EXPECT_TRUE(desk.app->of<CanvasLook>().wireframe);
  desk.hit(29, 'z', false, true);
  EXPECT_TRUE(desk.app->of<CanvasLook>().wireframe) << "the old one does nothing";
  EXPECT_EQ(desk.app->of<Actions>().keys().tooltip_of(Action::wireframe), "Show the edges of the mesh (Q)");
}

TEST(KeyboardDialog, AKeyThatIsInUseIsSaidAndTakenOverOnlyWhenAsked) {
  Desk desk("keys-taken");
  open_keys(desk);
  search(desk, "wire");
  desk.click("Shift+Z###key 0 wireframe");
  desk.hit(29, 'z', true);
  EXPECT_FALSE(kept_keys(desk).any_changed()) << "it is Undo's";
  ASSERT_NE(desk.interface->find("Take it for Wire###take over"), nullptr);
  desk.click("Leave it##key");
  EXPECT_FALSE(kept_keys(desk).any_changed());
  desk.click("Shift+Z###key 0 wireframe");
  desk.hit(29, 'z', true);
  desk.click("Take it for Wire###take over");
  EXPECT_EQ(kept_keys(desk).shortcut_of(Action::wireframe), "Ctrl+Z");
  EXPECT_EQ(kept_keys(desk).shortcut_of(Action::undo), "");
  // Undo has its own key again, and that is asked, too.
  search(desk, "take back the last");
  desk.click("###key 0 undo");
  desk.click("Reset##key");
  EXPECT_EQ(kept_keys(desk).shortcut_of(Action::undo), "");
  desk.click("Take it for Undo###take over");
  EXPECT_EQ(kept_keys(desk).shortcut_of(Action::undo), "Ctrl+Z");
  EXPECT_EQ(kept_keys(desk).shortcut_of(Action::wireframe), "");
  search(desk, "");
  desk.click("All as they were##key");
  EXPECT_FALSE(kept_keys(desk).any_changed());
}

TEST(KeyboardDialog, EscapeLeavesItAndDeleteTakesItAway) {
  Desk desk("keys-none");
  open_keys(desk);
  search(desk, "bring back");
  desk.click("Ctrl+Shift+Z###key 0 redo");
  desk.hit_escape();
  EXPECT_EQ(desk.app->of<Dialogs>().open().name, "keyboard") << "the dialog stays";
  EXPECT_FALSE(kept_keys(desk).any_changed());
  desk.click("Ctrl+Y###key 1 redo");
  desk.hit(76, k_key_delete);
  EXPECT_EQ(kept_keys(desk).keys_of(Action::redo)[1].key, 0U);
  EXPECT_EQ(kept_keys(desk).shortcut_of(Action::redo), "Ctrl+Shift+Z");
  desk.hit_escape();
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
  desk.hit(k_any, 'i');
  EXPECT_EQ(desk.document().timeline->keys.size(), 1U) << "keys are the program's again";
}

TEST(KeyboardDialog, NoModifierAloneIsAKeyAndEscapeIsNobodysElse) {
  Desk desk("keys-modifier");
  open_keys(desk);
  search(desk, "wire");
  desk.click("Shift+Z###key 0 wireframe");
  desk.hit(224, 0, true);
  EXPECT_TRUE(desk.app->of<Dialogs>().state<KeyAsked>().waits) << "Ctrl alone";
  desk.hit(k_any, 'w', true, true);
  EXPECT_EQ(kept_keys(desk).shortcut_of(Action::wireframe), "Ctrl+Shift+W");
  search(desk, "cancel the line");
  desk.click("Esc###key 0 cancel");
  EXPECT_FALSE(desk.app->of<Dialogs>().state<KeyAsked>().waits);
}

TEST(KeyboardDialog, ABrokenLineIsToldAtTheStart) {
  const auto folder = Desk::folder_of("keys-broken") / "config";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "settings") << "pose_first=1\nkey=wireframe|Q\nkey=fly|Q\n";
  Desk desk("keys-broken", "builtin:demo", false);
  ASSERT_FALSE(desk.app->of<Notices>().all().empty());
  EXPECT_NE(desk.app->of<Notices>().all().front().text.find("settings: line 3: \"key=fly|Q\""), std::string::npos);
  desk.begin();
  desk.app->of<Actions>().run(Action::theme);
  std::ifstream file(folder / "settings");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(text.find("key=fly|Q\n"), std::string::npos) << "and is not lost";
  EXPECT_EQ(kept_keys(desk).shortcut_of(Action::wireframe), "Q");
}

TEST(KeyboardDialog, ItFitsSmallScreens) {
  Desk desk("keys-small");
  open_keys(desk);
  for (const auto& [width, height] : {std::pair{800, 600}, std::pair{480, 320}}) {
    desk.app->of<Pointer>().resized({width, height}, 96);
    desk.frames();
    desk.expect_within(width, height, {"Done##keyboard", "All as they were##key", "##key search"});
  }
}

}  // namespace
}  // namespace penpose::app
