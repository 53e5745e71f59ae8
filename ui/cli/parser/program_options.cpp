#include "ui/cli/parser/program_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "core/base/result.h"
#include "core/base/version.h"
#include "ui/cli/commands.h"
#include "ui/cli/draw_option.h"
#include "ui/cli/live_option.h"
#include "ui/cli/orientation_option.h"
#include "ui/cli/parser/command.h"
#include "ui/cli/screen_options.h"
#include "ui/cli/tablet/tablet_options.h"

namespace penpose::cli {
namespace {

/// A word that is neither a subcommand nor a file is a mistake in the call, not a file that is missing.
std::string check_model(const std::string& path) {
  std::error_code code;
  if (path.starts_with("builtin:") || std::filesystem::exists(path, code)) return {};
  const bool looks_like_file = path.find('.') != std::string::npos || path.find('/') != std::string::npos;
  return looks_like_file ? "there is no file " + path
                         : "there is neither a subcommand nor a file " + path + "; --help lists the subcommands";
}

/// What is written to has a name: found out before the work, not after it.
void forbid_empty_names(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands({})) {
    for (CLI::Option* option : command->get_options()) {
      const bool is_output = option->check_name("-o") || option->check_name("--output") || option->check_name("OUT") ||
                             option->check_name("--png") || option->check_name("--session") ||
                             option->check_name("--rules-folder");
      if (!is_output) continue;
      option->check(
          CLI::Validator([](std::string& name) { return name.empty() ? std::string("the name is empty") : ""; }, ""));
    }
  }
}

void end_with_examples(CLI::App& app, std::string_view name) {
  const auto examples = examples_of(name);
  if (examples.empty()) return;
  std::size_t widest = 0;
  for (const Example& example : examples) widest = std::max(widest, example.call.size());
  std::string text = "Examples:";
  for (const Example& example : examples) {
    text += "\n  " + std::string(example.call) + std::string(widest - example.call.size() + 2, ' ') + "# " +
            std::string(example.does);
  }
  app.footer(text);
}

void add_window_options(const Command& command, files::WindowRequest& request) {
  command.add_option("MODEL", request.model, "Model, project or session to open; the built-in head by default")
      .check(check_model);
  add_orientation_options(command, request.orientation);
  command.add_option("--session", request.session,
                     "Where to record the session; a file that is there is not written over");
  add_tablet_options(command, request.own);
  add_live_option(command, request.live);
  command.add_flag("--fullscreen", request.fullscreen, "Fill the whole screen");
  add_draw_option(command, request.draw);
  add_screen_options(command, request);
  // For tests and measurements.
  command.add_option("--replay", request.replay).hidden();
  command.add_flag("--timings", request.timings).hidden();
}

}  // namespace

void add_program_options(CLI::App& app, int& status, files::WindowRequest& request, bool has_window) {
  app.description(std::string("Poses and rigs 3D characters by drawing.") +
                  (has_window ? " Without a subcommand it opens its window." : ""));
  app.require_subcommand(has_window ? 0 : 1, 1);
  app.set_version_flag("--version", std::string(base::k_version));
  for (const Subcommand& command : subcommands()) command.add(app, status);
  forbid_empty_names(app);
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return "penpose: " + base::Error{error.what(), "", "--help lists what can be given"}.line() + "\n";
  });
  for (CLI::App* command : app.get_subcommands({})) end_with_examples(*command, command->get_name());
  end_with_examples(app, "");
  if (has_window) add_window_options(Command(app), request);
}

}  // namespace penpose::cli
