#include "ui/files/own_tablets.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>
#include <vector>

#include "ui/cli/parser/command_line.h"

namespace penpose::files {
namespace {

class OwnTablets : public testing::Test {
 protected:
  OwnTablets() : folder_(std::filesystem::temp_directory_path() / ("penpose_own_" + std::to_string(::getpid()))) {
    std::filesystem::create_directory(folder_);
  }
  ~OwnTablets() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    const auto path = (folder_ / name).string();
    std::ofstream(path) << text;
    return path;
  }

  std::filesystem::path folder_;
};

/// A tablet of vendor and product dead:beef whose reports put y before x, most significant byte first.
constexpr const char* k_tablet = R"({"penpose_tablets": 1,
  "protocols": {"mine": {"rules": [{"gives": "pen", "y": "2 1", "x": "4 3", "pressure": "5", "tip": "0.0"}]}},
  "tablets": [{"vendor": "Mine", "name": "One", "size_mm": [100, 50], "max": [10000, 5000], "max_pressure": 255,
    "identifiers": [{"id": "dead:beef", "protocol": "mine"}]}]})";

TEST_F(OwnTablets, NoFileIsNoTablets) {
  const auto none = read_own_tablets({});
  ASSERT_TRUE(none.ok());
  EXPECT_TRUE(none->tablets().empty());
  EXPECT_FALSE(read_own_tablets({"/nonexistent", ""}).ok());
}

TEST_F(OwnTablets, DecodeReadsATabletThatOnlyTheUserKnows) {
  const auto tablets = write("mine.json", k_tablet);
  const auto trace = write("one.hid",
                           "R: 5 05 0d 09 02 c0\nN: Mine One\nP: test\nI: 3 dead beef\n"
                           "E: 000000.000000 6 01 01 02 03 04 7f\n");
  const std::vector<const char*> arguments{"penpose", "decode", trace.c_str(), "--csv", "--tablets", tablets.c_str()};
  testing::internal::CaptureStdout();
  const int status = cli::run(static_cast<int>(arguments.size()), arguments.data());
  const auto out = testing::internal::GetCapturedStdout();
  EXPECT_EQ(status, 0);
  EXPECT_NE(out.find("# axis x 0 10000 100\n"), std::string::npos) << out;
  EXPECT_NE(out.find("\n0,0,772,258,127,,,,1,pen,1,0,0\n"), std::string::npos) << out;
}

TEST_F(OwnTablets, AFileWithAMistakeIsRefusedBeforeDecoding) {
  const auto tablets = write("broken.json", R"({"penpose_tablets": 1, "tablets": [{"vendor": 3}]})");
  const auto trace = write("one.hid", "E: 000000.000000 1 01\n");
  const std::vector<const char*> arguments{"penpose", "decode", trace.c_str(), "--tablets", tablets.c_str()};
  testing::internal::CaptureStderr();
  const int status = cli::run(static_cast<int>(arguments.size()), arguments.data());
  const auto error = testing::internal::GetCapturedStderr();
  EXPECT_EQ(status, 1);
  EXPECT_EQ(error, "penpose: " + tablets + ": /tablets/0/vendor: is no text; write a text in quotes\n");
}

}  // namespace
}  // namespace penpose::files
