#pragma once

#include <cctype>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

#include "core/base/edition.h"
#include "ui/cli/parser/command_line.h"

namespace penpose::tests {

struct Outcome {
  int status = 0;
  std::string out;
  std::string error;
};

/// Runs the program, in this process, with arguments behind its name.
inline Outcome run_program(const std::vector<std::string>& arguments) {
  std::vector<const char*> argv{"penpose"};
  for (const auto& argument : arguments) argv.push_back(argument.c_str());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Outcome outcome;
  outcome.status = cli::run(static_cast<int>(argv.size()), argv.data());
  outcome.out = testing::internal::GetCapturedStdout();
  outcome.error = testing::internal::GetCapturedStderr();
  return outcome;
}

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
  void save(const std::string& name, std::string_view text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  void save(const std::string& name, std::span<const std::uint8_t> bytes) const {
    save(name, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  }
  /// The beginning of a session that was drawn on a model.
  [[nodiscard]] static std::string session_on(const std::string& model) {
    std::string name;
    for (const char c : model) {
      char code[4] = {c, 0};
      if (std::isalnum(static_cast<unsigned char>(c)) == 0) std::snprintf(code, sizeof code, "%%%02X", c);
      name += code;
    }
    return "# penpose session edition=" + std::to_string(base::k_edition) +
           " program=test\n# penpose model 00000000000000000000000000000000 path=" + name + "\n";
  }
  [[nodiscard]] std::size_t files() const {
    const std::filesystem::directory_iterator all(folder_);
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }
  /// Returns the exit status; what was printed is in out_ and error_.
  int run(const std::vector<std::string>& arguments) {
    const Outcome outcome = run_program(arguments);
    out_ = outcome.out;
    error_ = outcome.error;
    return outcome.status;
  }

  int run(const std::string& command, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), command);
    return run(arguments);
  }

  std::filesystem::path folder_;
  std::string out_;
  std::string error_;
};

}  // namespace penpose::tests
