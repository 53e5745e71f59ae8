#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "core/base/result.h"
#include "core/base/state_hash.h"
#include "core/document/commands/command.h"
#include "core/document/document_hash.h"
#include "core/drawing/tool.h"
#include "firmware_io/decode/described/light_report.h"
#include "replay/session/pen_input.h"

namespace penpose::replay {

// What a session's trace says beyond the pen, in comment lines "# penpose WHAT ...". Texts, numbers, views and commands
// are written as core/document/commands/command_text.h says.

/// "session edition=NUMBER program=NAME": the first of them. Another edition (core/base/edition.h) is refused.
struct SessionBegins {
  std::string program;
  friend bool operator==(const SessionBegins&, const SessionBegins&) = default;
};
/// "model HASH path=PATH": what is drawn on, by its state hash; the path is a hint.
struct ModelNamed {
  base::Hash128 hash;
  std::string path;
  friend bool operator==(const ModelNamed&, const ModelNamed&) = default;
};
/// "view VIEW": the camera, or the size of the picture, changed.
struct ViewChanged {
  document::View view;
  friend bool operator==(const ViewChanged&, const ViewChanged&) = default;
};
/// "tool kind=KIND ...".
struct ToolChosen {
  drawing::Tool tool;
  friend bool operator==(const ToolChosen&, const ToolChosen&) = default;
};
/// "tablet DEVICE keep_aspect=1 ...": the mapping of a tablet.
struct TabletSet {
  int device = 0;
  TabletSetting setting;
  friend bool operator==(const TabletSet&, const TabletSet&) = default;
};
/// "gone DEVICE": a tablet was unplugged.
struct TabletGone {
  int device = 0;
  friend bool operator==(const TabletGone&, const TabletGone&) = default;
};
/// "lights DEVICE left=1 right=0": which lights are on beside the rings of a tablet, where its reports do not tell.
struct LightsSeen {
  int device = 0;
  decode::Lights lights{};
  friend bool operator==(const LightsSeen&, const LightsSeen&) = default;
};
/// "canvas" or "panel": where strokes that begin from now on belong to.
struct PenPlace {
  bool on_canvas = true;
  friend bool operator==(const PenPlace&, const PenPlace&) = default;
};
/// "do COMMAND".
struct Performed {
  document::Command command;
  friend bool operator==(const Performed&, const Performed&) = default;
};
/// "undo" and "redo".
struct Undone {
  friend bool operator==(const Undone&, const Undone&) = default;
};
struct Redone {
  friend bool operator==(const Redone&, const Redone&) = default;
};
/// "state HASH model=XXXXXXXX ...": the document after the stroke or the line before.
struct StateReached {
  document::DocumentState state;
  friend bool operator==(const StateReached&, const StateReached&) = default;
};

using SessionLine = std::variant<SessionBegins, ModelNamed, ViewChanged, ToolChosen, TabletSet, TabletGone, LightsSeen,
                                 PenPlace, Performed, Undone, Redone, StateReached>;

/// The text of a comment line, without its "# ".
[[nodiscard]] std::string to_text(const SessionLine& line);
/// Reads a comment line of a trace ("# penpose ..."). Nothing for any other comment. Errors: another edition, a
/// line that is not known or has another form.
[[nodiscard]] base::Result<std::optional<SessionLine>> parse_session_line(std::string_view comment);

/// By what a session was recorded, of whatever edition.
struct SessionOrigin {
  std::uint32_t edition = 0;
  std::string program;
};
/// What the first comment line of a session says; nothing for any other comment, and where no edition is said.
[[nodiscard]] std::optional<SessionOrigin> session_origin(std::string_view comment);

}  // namespace penpose::replay
