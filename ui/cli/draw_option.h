#pragma once

#include <CLI/App.hpp>
#include <optional>

#include "ui/render/renderer.h"

namespace penpose::cli {

/// `--draw gl|es|cpu`: how pictures are drawn; without it the first way that starts.
void add_draw_option(CLI::App& command, std::optional<render::DrawWay>& way);

}  // namespace penpose::cli
