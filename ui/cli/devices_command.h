#pragma once

namespace CLI {
class App;
}

namespace penpose::cli {

/// `penpose devices --known`: the tablets that the program can read.
void add_devices_command(CLI::App& app, int& status);

}  // namespace penpose::cli
