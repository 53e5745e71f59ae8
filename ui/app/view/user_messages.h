#pragma once

#include <string>

#include "core/base/result.h"
#include "core/document/document.h"
#include "core/drawing/tool.h"

namespace penpose::app {

/// Says what is wrong and what to do about it, and leaves out the place in a file or a command.
[[nodiscard]] std::string message_of(const base::Error& error);

/// Every message of `message_of_stroke` about a stroke that did nothing begins with this.
inline constexpr const char* k_nothing_changed = "Nothing changed: ";

/// Says why a stroke changed nothing, and what to draw. `before` is the document before the stroke.
[[nodiscard]] std::string message_of_stroke(const base::Error& error, const drawing::Tool& tool,
                                            const document::Document& before);

}  // namespace penpose::app
