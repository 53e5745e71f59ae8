#pragma once

namespace CLI {
class App;
}

namespace penpose::cli {

/// `penpose convert IN OUT`: from any format that is read to one that is written.
void add_convert_command(CLI::App& app, int& status);

}  // namespace penpose::cli
