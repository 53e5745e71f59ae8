#pragma once

#include "ui/cli/commands.h"

namespace penpose::cli {

/// `penpose track PICTURE... --labels LABELS.json -o TRACK.json`: curves of a picture sequence by eigen-points.
void add_track_command(CLI::App& app, int& status);

}  // namespace penpose::cli
