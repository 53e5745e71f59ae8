#pragma once

namespace CLI {
class App;
}

namespace penpose::cli {

/// `penpose demo [-o DIR] [--json]`: the whole method on the built-in head, from the bundled strokes.
void add_demo_command(CLI::App& app, int& status);

}  // namespace penpose::cli
