#include "ui/cli/commands.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>
#include <set>

namespace penpose::cli {
namespace {

TEST(Commands, EachAddsOneSubcommandThatExplainsItself) {
  CLI::App app;
  int status = k_success;
  std::set<std::string> names;
  std::size_t count = 0;
  for (const Subcommand& subcommand : subcommands()) {
    subcommand.add(app, status);
    const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
    ASSERT_EQ(commands.size(), ++count);
    EXPECT_FALSE(commands.back()->get_description().empty());
    EXPECT_NE(commands.back()->help().find("--help"), std::string::npos);
    EXPECT_EQ(commands.back()->get_name(), subcommand.name);
    names.insert(commands.back()->get_name());
  }
  EXPECT_EQ(names.size(), count);
  for (const char* name : {"info", "pose", "render", "convert"}) EXPECT_TRUE(names.contains(name)) << name;
}

}  // namespace
}  // namespace penpose::cli
