#pragma once

#include "ui/cli/commands.h"

namespace penpose::cli {

/// `penpose render MODEL ... -o OUT.png`: a picture of a model.
void add_render_command(CLI::App& app, int& status);

}  // namespace penpose::cli
