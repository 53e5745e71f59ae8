#pragma once

namespace CLI {
class App;
}

namespace penpose::cli {

/// `penpose devices`: the tablets that are plugged in, those that the program knows, and the permission to open them.
void add_devices_command(CLI::App& app, int& status);

}  // namespace penpose::cli
