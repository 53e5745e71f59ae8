#include "ui/files/open_file.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <thread>

#include "tests/support/command_run.h"
#include "ui/files/files.h"

namespace penpose::files {
namespace {

class OpenFile : public tests::CommandRun {
 protected:
  [[nodiscard]] std::string text_beside(const std::string& name) const {
    const auto bytes = read_beside(folder_.string(), name);
    return bytes ? std::string(base::as_text(*bytes)) : "error: " + bytes.error().what;
  }
};

TEST_F(OpenFile, DevicesAndSocketsAreNoFiles) {
  for (const char* device : {"/dev/zero", "/dev/null", "/dev/full"}) {
    EXPECT_EQ(open_input(device).error().what, "is a device and no file") << device;
    EXPECT_EQ(open_plain(device).error().what, "is a device and no file") << device;
  }
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::snprintf(address.sun_path, sizeof address.sun_path, "%s", path("socket").c_str());
  ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_FALSE(open_input(path("socket")));
  ::close(socket);
}

// A pipe that nobody writes to would be waited for, for ever.
TEST_F(OpenFile, APipeIsReadWhereTheUserNamesItAndNowhereElse) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(open_plain(path("pipe")).error().what, "is a pipe");
  EXPECT_EQ(text_beside("pipe"), "error: is a pipe");
  std::thread writer([&] { static_cast<void>(write_file(path("pipe"), base::as_bytes("through"))); });
  const auto bytes = read_file(path("pipe"));
  writer.join();
  ASSERT_TRUE(bytes);
  EXPECT_EQ(base::as_text(*bytes), "through");
}

TEST_F(OpenFile, AFileNamesFilesOfItsOwnFolderAndBelow) {
  std::filesystem::create_directories(path("textures/old"));
  save("a.bin", std::string("beside"));
  save("textures/old/b.bin", std::string("below"));
  EXPECT_EQ(text_beside("a.bin"), "beside");
  EXPECT_EQ(text_beside("textures/old/b.bin"), "below");
  EXPECT_EQ(text_beside("textures/../a.bin"), "beside");
  const std::string outside = "error: lies outside the folder of the file that names it";
  EXPECT_EQ(text_beside("../" + folder_.filename().string() + "/a.bin"), outside);
  EXPECT_EQ(text_beside(path("a.bin")), outside) << "absolute, though it lies there";
  EXPECT_EQ(text_beside(""), outside);
  EXPECT_EQ(text_beside(std::string("a.bin\0x", 7)), outside);
  EXPECT_NE(text_beside("c.bin").find("cannot be opened"), std::string::npos);
  EXPECT_EQ(text_beside("textures"), "error: is a folder");
}

TEST_F(OpenFile, NoLinkLeadsOutOfTheFolder) {
  std::filesystem::create_directories(path("inner"));
  save("secret", std::string("secret"));
  save("inner/mine", std::string("mine"));
  std::filesystem::create_symlink("../secret", path("inner/up"));
  std::filesystem::create_symlink(path("secret"), path("inner/absolute"));
  std::filesystem::create_symlink("..", path("inner/folder"));
  std::filesystem::create_symlink("/dev/zero", path("inner/device"));
  std::filesystem::create_symlink("mine", path("inner/own"));
  std::filesystem::create_symlink("loop", path("inner/loop"));
  for (const char* name : {"up", "absolute", "folder/secret", "device", "loop"}) {
    EXPECT_FALSE(read_beside(path("inner"), name)) << name;
  }
  EXPECT_EQ(base::as_text(read_beside(path("inner"), "own").value()), "mine") << "one that stays inside is followed";
}

TEST_F(OpenFile, NoMoreIsReadThanTheCallerTakes) {
  save("ten", std::string("0123456789"));
  EXPECT_TRUE(read_file(path("ten"), 10));
  EXPECT_NE(read_file(path("ten"), 9).error().what.find("is larger than"), std::string::npos);
  EXPECT_FALSE(read_beside(folder_.string(), "ten", 9));
  // A file that says that it is huge is refused before memory is taken for it.
  save("hole", std::string("x"));
  std::filesystem::resize_file(path("hole"), std::uintmax_t{1} << 40);
  EXPECT_FALSE(read_file(path("hole")));
  // Of a pipe it is not known beforehand.
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  std::thread writer([&] { static_cast<void>(write_file(path("pipe"), base::as_bytes(std::string(5000, 'x')))); });
  EXPECT_FALSE(read_file(path("pipe"), 4999));
  writer.join();
}

// What lies in /proc says that it is empty.
TEST_F(OpenFile, AFileThatSaysNoSizeIsReadToItsEnd) {
  const auto bytes = read_file("/proc/self/status");
  ASSERT_TRUE(bytes);
  EXPECT_GT(bytes->size(), 100U);
}

// --- what the commands do with files that name others ---

TEST_F(OpenFile, AModelThatNamesADeviceOrALinkIsRefusedAtOnce) {
  const std::string gltf = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":"data.bin"}]})";
  save("face.gltf", gltf);
  std::filesystem::create_symlink("/dev/zero", path("data.bin"));
  EXPECT_EQ(run({"info", path("face.gltf")}), 1);
  EXPECT_NE(error_.find("/buffers/0/uri"), std::string::npos) << error_;
  std::filesystem::remove(path("data.bin"));
  ASSERT_EQ(::mkfifo(path("data.bin").c_str(), 0600), 0);
  EXPECT_EQ(run({"info", path("face.gltf")}), 1);
  EXPECT_NE(error_.find("is a pipe"), std::string::npos) << error_;
}

TEST_F(OpenFile, LabelsNamePicturesBesideThemAlone) {
  for (const char* image : {"/dev/zero", "../x.png", "link.png"}) {
    std::filesystem::remove(path("link.png"));
    std::filesystem::create_symlink("/dev/zero", path("link.png"));
    save("labels.json", R"({"frames":[{"image":")" + std::string(image) + R"(","curves":{"a":[[0,0],[9,9]]}},)" +
                            R"({"image":"b.png","curves":{"a":[[0,0],[9,9]]}}]})");
    save("b.png", std::string("no picture"));
    EXPECT_EQ(run({"track", path("b.png"), "--labels", path("labels.json"), "-o", path("t.json")}), 1);
    EXPECT_NE(error_.find("lies outside the folder"), std::string::npos) << error_;
  }
}

TEST_F(OpenFile, EveryReaderRefusesADevice) {
  const std::vector<std::vector<std::string>> commands = {
      {"info", "/dev/zero"},
      {"decode", "/dev/zero"},
      {"replay", "/dev/zero"},
      {"pose", "builtin:head", "--cases", "/dev/zero"},
      {"articulate", "builtin:head", "--sketch", "/dev/zero", "-o", path("x.glb")},
      {"animate", "builtin:demo", "--track", "/dev/zero", "-o", path("x.glb")},
      {"render", "builtin:head", "--camera", "/dev/zero", "-o", path("x.png")},
      {"decode", path("none"), "--tablets", "/dev/zero"},
      {"convert", "builtin:head", "--shapes", "/dev/zero", path("x.glb")},
      {"track", "/dev/zero", "--labels", "/dev/zero", "-o", path("x.json")}};
  for (const auto& command : commands) {
    EXPECT_EQ(run(command), 1) << command[0];
    EXPECT_NE(error_.find("is a device"), std::string::npos) << command[0] << ": " << error_;
    EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1) << error_;
  }
}

TEST_F(OpenFile, ASessionNamesAPlainFileAsItsModel) {
  ASSERT_EQ(::mkfifo(path("pipe.glb").c_str(), 0600), 0);
  for (const std::string& model : {std::string("/dev/zero"), path("pipe.glb")}) {
    save("a.session", session_on(model));
    EXPECT_EQ(run({"replay", path("a.session")}), 1) << model;
    EXPECT_NE(error_.find("there is no model"), std::string::npos) << error_;
  }
}

}  // namespace
}  // namespace penpose::files
