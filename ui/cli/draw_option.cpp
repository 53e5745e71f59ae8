#include "ui/cli/draw_option.h"

#include <vector>

namespace penpose::cli {

void add_draw_option(const Command& command, std::string& way) {
  command
      .add_option("--draw", way,
                  "how pictures are drawn: gl (OpenGL 3.1 or ES 3.0), es (OpenGL ES 2.0 or OpenGL 2.1), cpu (the "
                  "processor, the same bits on every machine); default: the first that starts")
      .one_of({"gl", "es", "cpu"});
}

}  // namespace penpose::cli
