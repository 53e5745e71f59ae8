#pragma once

#include <CLI/CLI.hpp>
#include <memory>

#include "ui/cli/commands.h"

namespace penpose::cli {

/// A subcommand that runs with what its options say; `add_options` adds them to the parser.
template <typename Options>
Subcommand subcommand(std::string_view name, files::Rights rights, std::string does,
                      void (*add_options)(CLI::App&, Options&), int (*run)(const Options&), Example first,
                      Example second, std::vector<ValueRow> values = {}) {
  const auto add = [=](CLI::App& app, int& status) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(std::string(name), does);
    add_options(*command, *options);
    command->callback([=, &status] { status = run(*options); });
  };
  return {name, rights, add, {first, second}, std::move(values)};
}

}  // namespace penpose::cli
