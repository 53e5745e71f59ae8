#pragma once

#include "core/io/surface/orientation.h"
#include "ui/cli/parser/command.h"

namespace penpose::cli {

/// Adds "--up y|z" and "--left-handed" to a command that reads surfaces.
void add_orientation_options(const Command& command, io::Orientation& orientation);

}  // namespace penpose::cli
