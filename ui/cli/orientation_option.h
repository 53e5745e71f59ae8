#pragma once

#include "core/io/surface/orientation.h"

namespace CLI {
class App;
}

namespace penpose::cli {

/// Adds "--up y|z" and "--left-handed" to a command that reads surfaces.
void add_orientation_options(CLI::App& command, io::Orientation& orientation);

}  // namespace penpose::cli
