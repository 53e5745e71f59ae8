#pragma once

#include "core/io/model/write_model.h"

namespace CLI {
class App;
}

namespace penpose::cli {

/// Adds --tolerance, how exactly sketched deformers are baked, and --bare, which drops the file that a model was read
/// from, to a command that writes models. `options` outlives the
/// parsing.
void add_tolerance_option(CLI::App& command, io::WriteOptions& options);

}  // namespace penpose::cli
