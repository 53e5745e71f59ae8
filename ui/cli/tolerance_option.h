#pragma once

#include "core/model_io/write_model.h"

namespace CLI {
class App;
}

namespace penpose::cli {

/// Adds --tolerance, how exactly sketched deformers are baked, to a command that writes models. `options` outlives the
/// parsing.
void add_tolerance_option(CLI::App& command, model_io::GlbOptions& options);

}  // namespace penpose::cli
