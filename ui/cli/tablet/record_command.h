#pragma once

namespace CLI {
class App;
}

namespace penpose::cli {

/// `penpose record`: writes what tablets send into a trace.
void add_record_command(CLI::App& app, int& status);

}  // namespace penpose::cli
