#include "tests/support/command_run.h"

namespace penpose::cli {
namespace {

class RecordCommand : public tests::CommandRun {};

TEST_F(RecordCommand, ADeviceThatIsNotThereIsNamedAndNoFileIsMade) {
  EXPECT_EQ(run({"record", "-o", path("a.hid"), "--device", "/dev/hidraw9999"}), 1);
  EXPECT_EQ(error_, "penpose: /dev/hidraw9999: no such device is plugged in; `penpose devices` lists them\n");
  EXPECT_EQ(out_, "");
  EXPECT_EQ(files(), 0u);
}

TEST_F(RecordCommand, WrongUsageIsRefused) {
  EXPECT_EQ(run({"record"}), 2);
  EXPECT_EQ(run({"record", "-o", path("a.hid"), "--seconds", "-3"}), 2);
  EXPECT_EQ(run({"record", "-o", path("a.hid"), "--seconds", "soon"}), 2);
}

}  // namespace
}  // namespace penpose::cli
