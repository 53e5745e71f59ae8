#pragma once

#include "core/io/model/write_model.h"
#include "ui/cli/parser/command.h"

namespace penpose::cli {

/// Adds --tolerance, how exactly sketched deformers are baked, and --bare, which drops the file that a model was read
/// from, to a command that writes models. `options` outlives the
/// parsing.
void add_tolerance_option(const Command& command, io::WriteOptions& options);

}  // namespace penpose::cli
