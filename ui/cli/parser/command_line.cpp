#include "ui/cli/parser/command_line.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string_view>
#include <unistd.h>

#include "core/base/version.h"
#include "ui/cli/commands.h"
#include "ui/cli/parser/program_options.h"
#include "ui/files/files.h"
#include "ui/files/process/standard_streams.h"

namespace penpose::cli {
namespace {

int run_unguarded(int argc, const char* const* argv, const files::OpenWindow& open_window) {
  CLI::App app{"", "penpose"};
  int status = k_success;
  files::WindowRequest request;
  add_program_options(app, status, request, static_cast<bool>(open_window));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? k_success : k_wrong_usage;
  }
  if (!open_window || !app.get_subcommands().empty()) return status;
  request.program = "penpose-" + std::string(base::k_version);
  if (const auto opened = open_window(request); !opened) return files::report(opened.error());
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

int run(int argc, const char* const* argv, const files::OpenWindow& open_window) {
  int status = k_failure;
  try {
    status = run_unguarded(argc, argv, open_window);
    if (const auto printed = files::finish_output(); !printed && status == k_success)
      status = files::report(printed.error());
  } catch (const std::bad_alloc&) {
    return out_of_memory();
  } catch (const std::length_error&) {
    return out_of_memory();
  } catch (const std::exception& problem) {
    return files::report({std::string("something went wrong that should not (") + problem.what() + ")", "",
                          "report it with the file that shows it"});
  }
  return status;
}

}  // namespace penpose::cli
