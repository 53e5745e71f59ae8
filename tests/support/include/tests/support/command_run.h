#pragma once

#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <unistd.h>
#include <vector>

#include "ui/cli/command_line.h"

namespace penpose::tests {

/// Runs the program's subcommands in a folder of their own, which is removed again.
class CommandRun : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() / ("penpose_" + std::string(test->test_suite_name()) + "_" +
                                                        test->name() + "_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::string content(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  template <typename Content>
  void save(const std::string& name, const Content& bytes) const {
    std::ofstream file(folder_ / name, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }
  /// The beginning of a session that was drawn on a model.
  [[nodiscard]] static std::string session_on(const std::string& model) {
    std::string name;
    for (const char c : model) {
      char code[4] = {c, 0};
      if (std::isalnum(static_cast<unsigned char>(c)) == 0) std::snprintf(code, sizeof code, "%%%02X", c);
      name += code;
    }
    return "# penpose session 1 program=test\n# penpose model 00000000000000000000000000000000 path=" + name + "\n";
  }
  [[nodiscard]] std::size_t files() const {
    const std::filesystem::directory_iterator all(folder_);
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }
  /// Returns the exit status; what was printed is in out_ and error_.
  int run(const std::vector<std::string>& arguments) {
    std::vector<const char*> argv{"penpose"};
    for (const auto& argument : arguments) argv.push_back(argument.c_str());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int status = cli::run(static_cast<int>(argv.size()), argv.data());
    out_ = testing::internal::GetCapturedStdout();
    error_ = testing::internal::GetCapturedStderr();
    return status;
  }

  std::filesystem::path folder_;
  std::string out_;
  std::string error_;
};

}  // namespace penpose::tests
