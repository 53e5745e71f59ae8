#include "ui/cli/draw_option.h"

#include <CLI/CLI.hpp>
#include <vector>

namespace penpose::cli {

void add_draw_option(CLI::App& command, std::string& way) {
  command
      .add_option("--draw", way,
                  "how pictures are drawn: gl (OpenGL 3.1 or ES 3.0), es (OpenGL ES 2.0 or OpenGL 2.1), cpu (the "
                  "processor, the same bits on every machine); default: the first that starts")
      ->check(CLI::IsMember(std::vector<std::string>{"gl", "es", "cpu"}));
}

}  // namespace penpose::cli
