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
};

}  // namespace penpose::tests
