#pragma once

namespace CLI {
class App;
}

namespace penpose::cli {

/// `penpose articulate MODEL --sketch SKETCH.json -o OUT.glb [--json]`: builds deformers from strokes.
void add_articulate_command(CLI::App& app, int& status);

}  // namespace penpose::cli
