#include "ui/files/file_roles.h"

#include "tests/support/command_run.h"

namespace penpose::files {
namespace {

class FileRolesTest : public tests::CommandRun {};

TEST_F(FileRolesTest, AFileIsOneByWhateverNameItGoes) {
  save("a", std::string("x"));
  save("b", std::string("x"));
  std::filesystem::create_hard_link(path("a"), path("hard"));
  std::filesystem::create_symlink("a", path("soft"));
  std::filesystem::create_directory(path("inner"));
  EXPECT_TRUE(same_file(path("a"), path("a")));
  EXPECT_TRUE(same_file(path("a"), path("inner/../a")));
  EXPECT_TRUE(same_file(path("a"), path("hard")));
  EXPECT_TRUE(same_file(path("a"), path("soft")));
  EXPECT_FALSE(same_file(path("a"), path("b")));
  EXPECT_FALSE(same_file(path("a"), path("new")));
  EXPECT_TRUE(same_file(path("new"), path("inner/../new"))) << "neither is there yet";
  EXPECT_FALSE(same_file(path("new"), path("newer")));
  EXPECT_FALSE(same_file("/dev/null", "/dev/null")) << "nothing is lost there";
}

// Each of these lost the model, and said that all was well.
TEST_F(FileRolesTest, NoCommandWritesOverWhatItReads) {
  ASSERT_EQ(run({"convert", "builtin:demo", path("face.glb")}), 0) << error_;
  const std::string before = content("face.glb");
  std::filesystem::create_hard_link(path("face.glb"), path("other.glb"));
  save("cases.json", std::string("{}"));
  const std::string face = path("face.glb");
  const std::vector<std::vector<std::string>> commands = {
      {"render", face, "-o", face},
      {"render", face, "-o", path("other.glb")},
      {"replay", face, "-o", face},
      {"replay", path("s"), "--model", face, "-o", face},
      {"replay", path("s"), "-o", path("x.glb"), "--session", path("x.glb")},
      {"replay", path("s"), "-o", path("x.glb"), "--png", path("inner/../x.glb")},
      {"pose", face, "--cases", path("cases.json"), "-o", face},
      {"pose", face, "--cases", path("cases.json"), "-o", path("cases.json")},
      {"articulate", face, "--sketch", path("cases.json"), "-o", path("other.glb")},
      {"animate", face, "--track", path("cases.json"), "-o", face},
      {"track", path("cases.json"), "--labels", path("cases.json"), "-o", path("cases.json")},
      {"convert", "builtin:demo", "--shapes", face, path("other.glb")}};
  std::filesystem::create_directory(path("inner"));
  for (const auto& command : commands) {
    EXPECT_EQ(run(command), 1) << command[0];
    EXPECT_TRUE(error_.find("is read by this command") != std::string::npos ||
                error_.find("is written twice") != std::string::npos)
        << command[0] << ": " << error_;
    ASSERT_EQ(content("face.glb"), before) << command[0];
  }
  EXPECT_EQ(content("cases.json"), "{}");
  EXPECT_EQ(run({"convert", face, face}), 0) << "which is what converting in place means: " << error_;
}

TEST_F(FileRolesTest, TheModelThatASessionNamesIsNotWrittenOver) {
  ASSERT_EQ(run({"convert", "builtin:head", path("face.glb")}), 0) << error_;
  const std::string before = content("face.glb");
  save("a.session", session_on(path("face.glb")));
  EXPECT_EQ(run({"replay", path("a.session"), "-o", path("face.glb")}), 1);
  EXPECT_NE(error_.find("is what the session was drawn on"), std::string::npos) << error_;
  EXPECT_EQ(content("face.glb"), before);
}

TEST_F(FileRolesTest, AnEmptyNameIsWrongUsage) {
  const std::vector<std::vector<std::string>> commands = {{"render", "builtin:head", "-o", ""},
                                                          {"convert", "builtin:head", ""},
                                                          {"replay", path("s"), "--png", ""},
                                                          {"record", "-o", ""},
                                                          {"devices", "--install-udev-rule", "--rules-folder", ""}};
  for (const auto& command : commands) {
    EXPECT_EQ(run(command), 2) << command[0];
    EXPECT_NE(error_.find("the name is empty"), std::string::npos) << error_;
  }
}

TEST_F(FileRolesTest, ARecordingIsNeverWrittenOverAnother) {
  save("old.hid", std::string("yesterday"));
  EXPECT_EQ(run({"record", "-o", path("old.hid"), "--seconds", "0.01"}), 1);
  EXPECT_EQ(content("old.hid"), "yesterday");
}

}  // namespace
}  // namespace penpose::files
