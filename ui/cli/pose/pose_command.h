#pragma once

namespace CLI {
class App;
}

namespace penpose::cli {

/// `penpose pose MODEL --cases CASES.json ...`: solves posing cases.
void add_pose_command(CLI::App& app, int& status);

}  // namespace penpose::cli
