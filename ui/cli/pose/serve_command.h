#pragma once

namespace CLI {
class App;
}

namespace penpose::cli {

/// `penpose serve`: a conversation of JSON lines on standard input and output.
void add_serve_command(CLI::App& app, int& status);

}  // namespace penpose::cli
