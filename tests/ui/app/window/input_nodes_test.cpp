#include "ui/app/window/input_nodes.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace penpose::app {
namespace {

class InputNodesOf : public ::testing::Test {
 protected:
  InputNodesOf() { std::filesystem::create_directories(folder_); }
  ~InputNodesOf() override { std::filesystem::remove_all(folder_); }
  void plug_in(const std::string& name) const { std::ofstream(folder_ / name) << ' '; }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("penpose-inputs-" + std::to_string(::getpid()));
};

TEST_F(InputNodesOf, TellsOfADeviceThatCameOnce) {
  plug_in("event0");
  InputNodes nodes(folder_.string());
  EXPECT_FALSE(nodes.has_new());
  plug_in("event1");
  EXPECT_TRUE(nodes.has_new());
  EXPECT_FALSE(nodes.has_new());
}

TEST_F(InputNodesOf, TellsNothingOfOneThatLeft) {
  plug_in("event0");
  InputNodes nodes(folder_.string());
  std::filesystem::remove(folder_ / "event0");
  EXPECT_FALSE(nodes.has_new());
}

TEST_F(InputNodesOf, TellsOfOneThatIsPluggedInAgainUnseen) {
  plug_in("event0");
  InputNodes nodes(folder_.string());
  std::filesystem::remove(folder_ / "event0");
  ::usleep(20'000);
  plug_in("event0");
  EXPECT_TRUE(nodes.has_new());
}

TEST_F(InputNodesOf, IgnoresJoystickAndMouseNodes) {
  InputNodes nodes(folder_.string());
  plug_in("mouse0");
  plug_in("js0");
  EXPECT_FALSE(nodes.has_new());
}

TEST_F(InputNodesOf, NoFolderIsNoDevice) {
  InputNodes nodes((folder_ / "none").string());
  EXPECT_FALSE(nodes.has_new());
}

}  // namespace
}  // namespace penpose::app
