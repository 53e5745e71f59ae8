#pragma once

#include <string>

#include "core/base/result.h"
#include "core/document/document.h"
#include "core/drawing/tool.h"

namespace penpose::app {

/// An error in an animator's words: what is wrong and what to do about it, without the place in a file or a command.
[[nodiscard]] std::string said(const base::Error& error);

/// How what `said_of_stroke` says begins.
inline constexpr const char* k_nothing_changed = "Nothing changed: ";

/// Why a stroke changed nothing, and what to draw: of the tool in hand and the document before the stroke.
[[nodiscard]] std::string said_of_stroke(const base::Error& error, const drawing::Tool& tool,
                                         const document::Document& before);

}  // namespace penpose::app
