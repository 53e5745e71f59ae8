#pragma once

#include <span>
#include <string_view>

namespace penpose::cli {

/// A call as one would type it, for the end of --help and of a man page. Tests run every one of them.
struct Example {
  std::string_view call;
  std::string_view does;
};

/// The examples of a subcommand, or of the program itself for an empty name; none for a name that is unknown.
[[nodiscard]] std::span<const Example> examples_of(std::string_view command);

}  // namespace penpose::cli
