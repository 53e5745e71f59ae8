#include "ui/app/browser/places.h"

#include <gtest/gtest.h>

namespace penpose::app {
namespace {

TEST(Places, TheyComeFromTheUsersFoldersTheMountsAndWhatWasOpened) {
  const std::vector<std::string> recent{"/films/heads/a.glb", "/films/heads/b.glb", "/home/u/c.glb", "/data/d.glb"};
  PlaceSources sources;
  sources.home = "/home/u";
  sources.user_folders =
      "# user-dirs\nXDG_DESKTOP_DIR=\"$HOME/Schreibtisch\"\nXDG_DOCUMENTS_DIR=\"/srv/papers\"\nXDG_PICTURES_DIR=oops\n";
  sources.mounts =
      "22 1 8:1 / / rw - ext4 /dev/sda1 rw\n36 22 8:17 / /media/u/My\\040Stick rw - vfat /dev/sdb1 rw\n"
      "37 22 0:5 / /proc rw - proc proc rw\nbroken\n";
  sources.project = "/films/shot/face.penpose.glb";
  sources.recent = recent;
  const auto places = file_places(sources);
  std::vector<std::string> said;
  for (const FilePlace& one : places) said.push_back(one.label + "=" + one.path);
  EXPECT_EQ(said,
            (std::vector<std::string>{"Home=/home/u", "Desktop=/home/u/Schreibtisch", "Documents=/srv/papers",
                                      "Pictures=/home/u/Pictures", "Downloads=/home/u/Downloads", "Project=/films/shot",
                                      "My Stick=/media/u/My Stick", "heads=/films/heads", "data=/data"}));
}

TEST(Places, WithoutAHomeThereAreOthers) {
  PlaceSources sources;
  sources.mounts = "36 22 8:17 / /mnt/disk rw - ext4 /dev/sdb1 rw";
  const auto places = file_places(sources);
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places.front().kind, FilePlace::Kind::volume);
}

}  // namespace
}  // namespace penpose::app
