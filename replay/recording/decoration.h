#pragma once

#include <string>
#include <string_view>

#include "replay/trace/trace_reader.h"

namespace penpose::replay {

/// A line of text without what terminals, mails and pages put around it: escape sequences (ECMA-48) and other control
/// characters, text that a carriage return takes back, a byte order mark, indentation and marks of quoting (">").
[[nodiscard]] std::string undecorated(std::string_view line);

/// A file's text with every line undecorated.
[[nodiscard]] ReadBytes without_decoration(ReadBytes read);

}  // namespace penpose::replay
