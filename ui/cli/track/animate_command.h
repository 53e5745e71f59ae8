#pragma once

namespace CLI {
class App;
}

namespace penpose::cli {

/// `penpose animate MODEL --track TRACK [--map MAP] -o OUT.glb [--json]`: keyframes from tracked curves.
void add_animate_command(CLI::App& app, int& status);

}  // namespace penpose::cli
