#include "ui/app/tools/tool.h"

// Pose: a line along a feature, then one where it should go.

namespace penpose::app {
namespace {

std::string pose_hint(const ToolSight& sight) {
  if (!document::waiting_reference(sight.document)) return "Draw along a feature of the face: a lip, a brow, an eyelid";
  return sight.performs ? "Draw where this curve goes: time runs while the pen is down"
                        : "Now draw where this curve should go: the face follows the pen";
}

std::string pose_to_draw(const ToolSight& sight) {
  return document::waiting_reference(sight.document) ? "draw a line where the feature should go"
                                                     : "draw along a feature of the face";
}

}  // namespace

WindowTool pose_tool() {
  return {.kind = drawing::ToolKind::pose,
          .button = {"tool_pose", "Pose", "Draw where a feature is, then where it should go",
                     "M3 16L8 11L12 15L21 7M16 6L21 7L20 12", plain_key('b'), plain_key('p')},
          .hint = pose_hint,
          .to_draw = pose_to_draw,
          .performs = true};
}

}  // namespace penpose::app
