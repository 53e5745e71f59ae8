#pragma once

namespace CLI {
class App;
}

namespace penpose::cli {

/// `penpose decode TRACE [--pad | --touch] [--csv | --json] [--protocol NAME]`.
void add_decode_command(CLI::App& app, int& status);

}  // namespace penpose::cli
