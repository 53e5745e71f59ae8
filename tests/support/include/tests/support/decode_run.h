#pragma once

#include "tests/support/command_run.h"

namespace penpose::tests {

/// Runs `penpose decode` on the text of a trace.
class DecodeRun : public CommandRun {
 protected:
  Outcome decode(const std::string& trace, std::vector<std::string> arguments = {}) {
    save("trace.hid", trace);
    arguments.insert(arguments.begin(), {"decode", path("trace.hid")});
    return run_program(arguments);
  }
  /// What it writes where it succeeds.
  std::string decoded(const std::string& trace, const std::vector<std::string>& arguments) {
    const Outcome outcome = decode(trace, arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    return outcome.out;
  }
};

}  // namespace penpose::tests
