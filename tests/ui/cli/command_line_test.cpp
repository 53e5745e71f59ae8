#include "ui/cli/parser/command_line.h"

#include "tests/support/command_run.h"
#include "ui/cli/commands.h"

namespace penpose::cli {
namespace {

class CommandLine : public tests::CommandRun {};

TEST_F(CommandLine, AnswersHelpAndVersionOnStandardOutput) {
  EXPECT_EQ(run({"--help"}), k_success);
  EXPECT_NE(out_.find("pose"), std::string::npos);
  EXPECT_EQ(error_, "");
  EXPECT_EQ(run({"--version"}), k_success);
  EXPECT_NE(out_.find('.'), std::string::npos);
  EXPECT_EQ(error_, "");
}

TEST_F(CommandLine, WrongUsageExitsWithTwoAndPrintsNoResult) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"fly"}, {"--fly"}, {"info"}, {"info", "a.obj", "b.obj"}, {"info", "--fly", "a.obj"}}) {
    EXPECT_EQ(run(arguments), k_wrong_usage);
    EXPECT_EQ(out_, "");
    EXPECT_NE(error_, "");
  }
}

TEST_F(CommandLine, WorkThatFailsExitsWithOne) {
  EXPECT_EQ(run({"info", path("missing.obj")}), k_failure);
  EXPECT_EQ(out_, "");
  EXPECT_EQ(error_.rfind("penpose: " + path("missing.obj") + ": ", 0), 0U) << error_;
}

}  // namespace
}  // namespace penpose::cli
