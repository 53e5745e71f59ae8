#pragma once

#include "ui/files/window_request.h"

namespace CLI {
class App;
}

namespace penpose::cli {

/// The one table of all that can be given: fills an app with the subcommands, with the options of the window where the
/// program has one, and with the examples at the end of each help. Parsing runs the subcommand, which stores its exit
/// status; `status` and `request` outlive the app.
void add_program_options(CLI::App& app, int& status, files::WindowRequest& request, bool has_window);

}  // namespace penpose::cli
