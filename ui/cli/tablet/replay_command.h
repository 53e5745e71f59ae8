#pragma once

namespace CLI {
class App;
}

namespace penpose::cli {

/// `penpose replay`: a session or a plain trace drawn again, without a display.
void add_replay_command(CLI::App& app, int& status);

}  // namespace penpose::cli
