#include "ui/cli/pose/tolerance_option.h"

#include "ui/cli/number_range.h"

namespace penpose::cli {

void add_tolerance_option(const Command& command, io::WriteOptions& options) {
  command
      .add_option("--tolerance", options.bake_tolerance,
                  "How far baking sketched deformers for other programs may move a vertex, share of the model's size")
      .check(number_range(1e-6, 0.1), "0.000001 to 0.1")
      .show_default();
  command.add_flag(
      "--bare", options.bare,
      "Write what penpose knows of the model alone, without textures and all else of the file it came from");
}

}  // namespace penpose::cli
