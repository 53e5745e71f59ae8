#include "ui/app/dialogs/file_browser.h"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <thread>

#include "tests/support/app_desk.h"
#include "ui/files/load_model.h"
#include "ui/files/save_model.h"

// Dialogs of files by pen and by keyboard.

namespace penpose::app {
namespace {

constexpr int k_down = 81;
constexpr int k_tab = 43;

FileBrowser& browser(Desk& desk) { return desk.app->of<Dialogs>().state<FileBrowser>(); }
std::string folder_of(Desk& desk) { return desk.app->of<Dialogs>().state<FileChoice>().folder; }
std::string opened(Desk& desk) { return std::filesystem::path(desk.app->of<Files>().path()).filename().string(); }

void put_model(const Desk& desk, const std::string& name) {
  const auto model = files::load_model("builtin:demo");
  ASSERT_TRUE(model.ok() && files::save_model(*model, desk.path(name), files::SaveNotes::quiet).ok());
}
void open_dialog(Desk& desk) {
  desk.begin();
  desk.app->of<PanelState>().has_keyboard = true;
  desk.press('o', true);
  ASSERT_EQ(desk.app->of<Dialogs>().open(), Dialog::open);
}

TEST(FileBrowser, FoldersAreWalkedAndAModelIsOpenedByThePenAlone) {
  Desk desk("browse-pen");
  std::filesystem::create_directories(desk.folder / "heads");
  put_model(desk, "heads/a.glb");
  open_dialog(desk);
  EXPECT_EQ(desk.interface->find("a.glb"), nullptr);
  desk.click("heads/");
  EXPECT_EQ(folder_of(desk), desk.path("heads"));
  desk.click("Up##files");
  EXPECT_EQ(folder_of(desk), desk.folder.string());
  desk.click("heads/");
  desk.click("a.glb");
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
  EXPECT_EQ(opened(desk), "a.glb");
}

TEST(FileBrowser, ItIsWalkedByTheKeyboardAlone) {
  Desk desk("browse-keys");
  std::filesystem::create_directories(desk.folder / "heads");
  put_model(desk, "heads/first.glb");
  put_model(desk, "heads/second.glb");
  open_dialog(desk);
  desk.type("he");
  desk.hit(k_tab);
  EXPECT_EQ(browser(desk).text, "heads/") << "Tab completes it";
  ASSERT_EQ(browser(desk).entries.size(), 2U) << "and what is in there is seen";
  desk.hit_return();
  EXPECT_EQ(folder_of(desk), desk.path("heads"));
  desk.hit_backspace();
  EXPECT_EQ(folder_of(desk), desk.folder.string()) << "nothing is typed: the folder above";
  desk.type("heads/");
  desk.hit(k_down, k_key_down);
  desk.hit(k_down, k_key_down);
  desk.hit_return();
  EXPECT_EQ(opened(desk), "second.glb");
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
}

TEST(FileBrowser, AWholePathIsTyped) {
  Desk desk("browse-path");
  put_model(desk, "typed.glb");
  open_dialog(desk);
  desk.app->of<Dialogs>().state<FileChoice>().folder = "/";
  browser(desk).text = desk.path("typed.glb");
  desk.frames();
  desk.hit_return();
  EXPECT_EQ(opened(desk), "typed.glb");
}

TEST(FileBrowser, AFolderIsMadeWithItsMistakesSaidInPlaceAndTakenBack) {
  Desk desk("browse-new");
  open_dialog(desk);
  desk.click("New folder##files");
  desk.click("##new folder");
  desk.type("a/b");
  desk.click("Make##new folder");
  EXPECT_NE(browser(desk).new_error.find("\"a/b\" is no name for a folder"), std::string::npos);
  browser(desk).new_name = "shots";
  desk.frames();
  desk.hit_return();
  EXPECT_EQ(folder_of(desk), desk.path("shots"));
  EXPECT_TRUE(std::filesystem::is_directory(desk.path("shots")));
  desk.click("Take it back##new folder");
  EXPECT_FALSE(std::filesystem::exists(desk.path("shots")));
  EXPECT_EQ(folder_of(desk), desk.folder.string());
  desk.click("New folder##files");
  desk.hit_escape();
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::open) << "Escape leaves the name first";
}

TEST(FileBrowser, OrderAndHiddenFilesAreKeptAndKindsAreChosen) {
  Desk desk("browse-view");
  put_model(desk, "a.glb");
  std::ofstream(desk.path("b.session")) << "x";
  std::ofstream(desk.path(".c.glb")) << "x";
  open_dialog(desk);
  EXPECT_NE(desk.interface->find("b.session"), nullptr);
  EXPECT_EQ(desk.interface->find(".c.glb"), nullptr);
  desk.click("All that opens##kind");
  EXPECT_EQ(desk.interface->find("b.session"), nullptr) << "models alone";
  desk.click("Models##kind");
  EXPECT_EQ(desk.interface->find("a.glb"), nullptr) << "sessions alone";
  desk.click("Sessions##kind");
  desk.click("Hidden##files");
  EXPECT_NE(desk.interface->find(".c.glb"), nullptr);
  desk.click("By name##sort");
  const Settings kept = load_settings(desk.path("config"));
  EXPECT_EQ(kept.file_sort, FileSort::date);
  EXPECT_TRUE(kept.hidden_files);
}

TEST(FileBrowser, AModelGetsAPicture) {
  Desk desk("browse-pictures");
  put_model(desk, "a.glb");
  open_dialog(desk);
  const int before = desk.interface->font_revision();
  EXPECT_GE(desk.interface->next_frame_ms(), 0) << "it is looked for";
  for (int i = 0; i < 3000 && desk.interface->next_frame_ms() >= 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    desk.frames(1);
  }
  desk.frames();
  EXPECT_GT(desk.interface->font_revision(), before) << "it was drawn beside the letters";
  EXPECT_EQ(desk.interface->next_frame_ms(), -1) << "nothing goes on once it is there";
}

TEST(FileBrowser, ANameMayBeAPathAndArrowsChooseOne) {
  Desk desk("browse-save");
  std::filesystem::create_directories(desk.folder / "out");
  desk.begin();
  desk.press('s', true, true);
  desk.app->of<Dialogs>().state<FileChoice>().name = "out/mine.glb";
  desk.frames();
  desk.click("Save##now");
  EXPECT_TRUE(std::filesystem::exists(desk.path("out/mine.glb")));
  // The arrows go to a folder, Return into it, and only then the name is saved.
  desk.app->of<PanelState>().has_keyboard = true;
  desk.app->of<Dialogs>().state<FileChoice>().folder = desk.folder.string();
  desk.press('s', true, true);
  const auto& entries = browser(desk).entries;
  const auto out = std::find_if(entries.begin(), entries.end(), [](const FileEntry& one) { return one.name == "out"; });
  ASSERT_NE(out, entries.end());
  for (auto i = out - entries.begin(); i >= 0; --i) desk.hit(k_down, k_key_down);
  desk.hit_return();
  EXPECT_EQ(folder_of(desk), desk.path("out"));
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::save);
}

TEST(FileBrowser, ItFitsSmallScreensWithTargetsForAPen) {
  Desk desk("browse-small");
  put_model(desk, "a.glb");
  desk.begin();
  for (const auto& [width, height] : {std::pair{480, 320}, std::pair{800, 600}, std::pair{1380, 860}}) {
    desk.app->of<Pointer>().resized({width, height}, 96);
    for (const Dialog dialog : {Dialog::open, Dialog::save}) {
      desk.app->of<Dialogs>().show(dialog);
      desk.frames();
      const double unit = desk.app->of<Canvas>().target_px();
      for (const char* label : {"Up##files", dialog == Dialog::open ? "Cancel" : "Save##now"}) {
        const Area* area = desk.interface->find(label);
        ASSERT_NE(area, nullptr) << label << " " << width << " " << dialog.name;
        EXPECT_GE(area->height(), unit - 1) << label;
        EXPECT_LE(area->right, width) << label;
        EXPECT_LE(area->bottom, height) << label << " " << dialog.name;
      }
      desk.hit_escape();
    }
  }
}

TEST(FileBrowser, ArrowsWorkInAWindowThatIsTooSmallForTheList) {
  Desk desk("browse-tiny");
  put_model(desk, "a.glb");
  put_model(desk, "b.glb");
  desk.begin();
  desk.app->of<PanelState>().has_keyboard = true;
  desk.app->of<Pointer>().resized({320, 120}, 200);
  desk.app->of<Dialogs>().show(Dialog::open);
  desk.frames();
  ASSERT_FALSE(browser(desk).entries.empty());
  desk.hit(k_down, k_key_down);
  desk.frames();
  EXPECT_EQ(browser(desk).chosen, std::optional<std::size_t>(0));
}

}  // namespace
}  // namespace penpose::app
