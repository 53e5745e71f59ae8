#pragma once

#include <CLI/App.hpp>
#include <string>

namespace penpose::cli {

/// `--draw gl|es|cpu`: how pictures are drawn; without it the first way that starts.
void add_draw_option(CLI::App& command, std::string& way);

}  // namespace penpose::cli
