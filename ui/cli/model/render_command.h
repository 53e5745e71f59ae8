#pragma once

#include <cstddef>
#include <string>

#include "ui/cli/commands.h"

namespace penpose::cli {

/// `penpose render MODEL ... -o OUT.png`: a picture of a model.
/// The file of picture `number` (from 1) of a sequence, as Blender names it: the number with leading zeros, four digits
/// or as many as `pattern` has # at its end, before the extension .png.
[[nodiscard]] std::string frame_name(const std::string& pattern, std::size_t number);

void add_render_command(CLI::App& app, int& status);

}  // namespace penpose::cli
