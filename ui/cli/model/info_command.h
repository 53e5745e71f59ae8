#pragma once

namespace CLI {
class App;
}

namespace penpose::cli {

/// `penpose info MODEL [--json]`: what is in a model.
void add_info_command(CLI::App& app, int& status);

}  // namespace penpose::cli
