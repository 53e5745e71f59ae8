#pragma once

#include <memory>

#include "ui/cli/commands.h"
#include "ui/cli/parser/command.h"

namespace penpose::cli {

/// A subcommand that runs with what its options say; `add_options` adds them to the parser.
template <typename Options>
Subcommand subcommand(std::string_view name, files::Rights rights, std::string does,
                      void (*add_options)(const Command&, Options&), int (*run)(const Options&), Example first,
                      Example second, std::vector<ValueRow> values = {}) {
  const auto add = [=](CLI::App& app, int& status) {
    const auto options = std::make_shared<Options>();
    add_options(add_subcommand(
                    app, name, does, [=] { return run(*options); }, status),
                *options);
  };
  return {name, rights, add, {first, second}, std::move(values)};
}

}  // namespace penpose::cli
