#include "ui/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string_view>
#include <unistd.h>

#include "ui/cli/commands.h"
#include "ui/cli/files.h"
#include "ui/cli/own_tablets.h"
#include "ui/cli/standard_streams.h"

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

int run_unguarded(int argc, const char* const* argv, const OpenWindow& open_window) {
  CLI::App app{"Poses and rigs 3D characters by drawing. Without a subcommand it opens its window.", "penpose"};
  app.require_subcommand(open_window ? 0 : 1, 1);
  app.set_version_flag("--version", PENPOSE_VERSION);
  int status = k_success;
  for (const auto& add : all_commands()) add(app, status);
  forbid_empty_names(app);
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return "penpose: " + base::Error{error.what(), "", "--help lists what can be given"}.line() + "\n";
  });
  WindowRequest request;
  if (open_window) {
    app.add_option("MODEL", request.model, "Model, project or session to open; the built-in head by default")
        ->check(CLI::Validator(check_model, ""));
    app.add_option("--session", request.session,
                   "Where to record the session; a file that is there is not written over");
    app.add_option(k_tablets_option, request.tablets, k_tablets_help);
    app.add_flag("--fullscreen", request.fullscreen, "Use the whole screen");
    // For tests and measurements.
    app.add_option("--replay", request.replay)->group("");
    app.add_flag("--timings", request.timings)->group("");
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? k_success : k_wrong_usage;
  }
  if (!open_window || !app.get_subcommands().empty()) return status;
  request.program = std::string("penpose-") + PENPOSE_VERSION;
  if (const auto opened = open_window(request); !opened) return report(opened.error());
  return k_success;
}

/// Says why with no memory of its own.
int out_of_memory() {
  constexpr std::string_view k_line =
      "penpose: the memory does not suffice; give the program more of it (ulimit -v), or a smaller file\n";
  static_cast<void>(!::write(STDERR_FILENO, k_line.data(), k_line.size()));
  return k_failure;
}

[[noreturn]] void end_out_of_memory() { ::_exit(out_of_memory()); }

}  // namespace

void end_where_memory_ends() { std::set_new_handler(end_out_of_memory); }

int run(int argc, const char* const* argv, const OpenWindow& open_window) {
  int status = k_failure;
  try {
    status = run_unguarded(argc, argv, open_window);
    if (const auto printed = finish_output(); !printed && status == k_success) status = report(printed.error());
  } catch (const std::bad_alloc&) {
    return out_of_memory();
  } catch (const std::length_error&) {
    return out_of_memory();
  } catch (const std::exception& problem) {
    return report({std::string("something went wrong that should not (") + problem.what() + ")", "",
                   "report it with the file that shows it"});
  }
  return status;
}

}  // namespace penpose::cli
