#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/commands/command.h"
#include "core/drawing/tool.h"
#include "ui/app/key_stroke.h"
#include "ui/app/playback/arcs.h"
#include "ui/render/scene.h"

namespace penpose::app {

class Controls;
class EditingSession;
struct PanelState;

/// What a tool looks at to say what comes next.
struct ToolSight {
  const document::Document& document;
  const drawing::Tool& tool;
  bool performs = false;  ///< time runs while the pen holds a target
};

/// What a tool may change besides drawing.
struct ToolHand {
  EditingSession& editing;
  Controls& controls;
  PanelState& panels;
};

/// A finished line of the pen, px of the view.
struct ToolLine {
  const document::Document& document;
  const document::View& view;
  const std::vector<geometry::PxPoint>& points;
  const std::vector<double>& shares;  ///< when the pen was at each point, 0..1 of the line's time
  std::span<const ShownArc> arcs;     ///< that are seen
  bool paced = false;                 ///< the pen's own pace counts
  int rate = 24;                      ///< frames a second
  double within_px = 12;              ///< of something is on it
};

/// A stroke of the tool that has ended.
struct ToolStroke {
  const std::vector<geometry::PxPoint>& line;  ///< px of the view, never empty
  bool changed = false;                        ///< it changed the document
  bool tapped = false;                         ///< the pen only touched the canvas
};

/// What the canvas shows while a tool draws.
enum class ToolPreview : std::uint8_t {
  pose,    ///< the posed face, which follows targets
  sketch,  ///< the control that is drawn, on the face at rest
};

/// How a tool is chosen: its button, which is an action, too.
struct ToolButton {
  std::string_view action = {};  ///< its name
  std::string_view label = {};
  std::string_view tip = {};
  std::string_view icon = {};  ///< icon.h
  KeyStroke key = {};
  KeyStroke other = {};  ///< a second key
};

/// A tool of the window. Each stands in a file of this folder (NAME_tool.cpp), which says all that there is to it, and
/// in a row of tool_list.cpp.
struct WindowTool {
  /// What a session records while it is in hand. Its strokes mean what core/drawing says; with `none` they mean what
  /// `means` says.
  drawing::ToolKind kind = drawing::ToolKind::none;
  ToolButton button = {};     ///< without a label: none, other parts of the window choose it
  bool stands_apart = false;  ///< in the toolbar
  bool can_be_held = true;    ///< by a key of a tablet, while it is down; never one with `means`

  /// Says what to draw next, in one line.
  std::string (*hint)(const ToolSight& sight) = nullptr;
  /// Says what would have meant something, after a stroke that meant nothing.
  std::string (*to_draw)(const ToolSight& sight) = nullptr;

  ToolPreview preview = ToolPreview::pose;
  /// The look of its line; null: that of what the line means.
  render::CurveKind (*line)(const ToolSight& sight) = nullptr;
  bool shows_arcs = false;    ///< the paths of features over time
  bool shows_ghosts = false;  ///< lines at the neighbouring keys, which are drawn on
  bool erases = false;        ///< its line is broad and pale
  bool selects = false;       ///< curves, targets and controls can be taken in hand
  bool pulls = false;         ///< what is under the pen is pulled, and what the face does is recorded
  bool performs = false;      ///< it goes on with Perform; taking any other tool ends that
  bool places = false;        ///< characters can be moved in the scene

  /// The tool is taken in hand.
  void (*taken)(ToolHand& hand) = nullptr;
  /// Its stroke goes on.
  void (*moved)(ToolHand& hand) = nullptr;
  /// Its stroke has ended, after what it means was done.
  void (*ended)(ToolHand& hand, const ToolStroke& stroke) = nullptr;
  /// The command that a finished line means, where `kind` is none; nothing: it means nothing.
  std::optional<document::Command> (*means)(const ToolLine& line) = nullptr;

  [[nodiscard]] bool draws() const { return kind != drawing::ToolKind::none || means != nullptr; }
};

/// All tools of the window, in the order of the toolbar.
[[nodiscard]] std::span<const WindowTool> window_tools();
/// The first one of a kind. One that the window has no tool for counts as Pose.
[[nodiscard]] const WindowTool& window_tool(drawing::ToolKind kind);

}  // namespace penpose::app
