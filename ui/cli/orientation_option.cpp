#include "ui/cli/orientation_option.h"

#include <string>

namespace penpose::cli {

void add_orientation_options(const Command& command, io::Orientation& orientation) {
  command
      .add_option(
          "--up", [&orientation](const std::string& axis) { orientation.up = axis == "z" ? io::Up::z : io::Up::y; },
          "the axis that points up in an OBJ, PLY, OFF or STL file (y); z turns it")
      .one_of({"y", "z"});
  command.add_flag("--left-handed", orientation.left_handed,
                   "the OBJ, PLY, OFF or STL file is left-handed, so that it shows the wrong side: mirror it");
}

}  // namespace penpose::cli
