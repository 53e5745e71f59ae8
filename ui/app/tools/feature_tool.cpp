#include "ui/app/panels/panel_state.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/tools/tool.h"

// Feature: a line along a feature of the face as it is, which says where that feature is.

namespace penpose::app {
namespace {

/// A line along nothing that is known, or along several features: a menu asks which it is.
void ask_which(ToolHand& hand, const ToolStroke& stroke) {
  if (stroke.changed || stroke.tapped) return;
  hand.panels.feature_menu = FeatureMenu{{}, {}, hand.editing.editor().view(), stroke.line, stroke.line.back()};
}

}  // namespace

WindowTool feature_tool() {
  WindowTool tool;
  tool.kind = drawing::ToolKind::feature;
  tool.button = {"tool_feature", "Feature", "Show where the features of the face are, and draw along one that is wrong",
                 "M4 9L10 5L20 7M4 16L9 12.5L15 12.5L20 16L15 18.5L9 18.5Z", plain_key('v')};
  tool.hint = [](const ToolSight&) -> std::string {
    return "Draw along a feature that is in the wrong place, or touch its name";
  };
  tool.to_draw = [](const ToolSight&) -> std::string { return "draw along a feature of the face, such as a brow"; };
  tool.line = [](const ToolSight&) { return render::CurveKind::reference; };
  tool.ended = ask_which;
  return tool;
}

}  // namespace penpose::app
