#pragma once

#include <span>
#include <string>

#include "ui/cli/parser/command_table.h"

namespace penpose::pages {

/// The page of the program or of one subcommand in man(7)'s language. `version` as `penpose 0.2.0`, `date` as
/// 2026-01-31.
[[nodiscard]] std::string man_page(std::span<const cli::CommandRow> table, const cli::CommandRow& command,
                                   const std::string& version, const std::string& date);

/// "penpose.1", "penpose-render.1".
[[nodiscard]] std::string man_page_name(const cli::CommandRow& command);

}  // namespace penpose::pages
