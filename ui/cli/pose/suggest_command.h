#pragma once

namespace CLI {
class App;
}

namespace penpose::cli {

/// `penpose suggest MODEL`: the rest of a pose from poses that are keyed, or how well these foretell each other.
void add_suggest_command(CLI::App& app, int& status);

}  // namespace penpose::cli
