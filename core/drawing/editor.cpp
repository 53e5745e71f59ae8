#include "core/drawing/editor.h"

#include <utility>

namespace penpose::drawing {

Editor::Editor(document::Document document) : history_(std::move(document)), view_(opening_view(history_.document())) {}

base::Status Editor::set_view(const document::View& view) {
  if (const auto camera = geometry::Camera::make(view.camera, view.viewport); !camera) return camera.error();
  view_ = view;
  return base::Done{};
}

base::Status Editor::perform(const document::Command& command) { return history_.perform(command, work_); }

base::Status Editor::draw(const curve::Stroke& stroke, const document::View& view, bool eraser) {
  const bool line_wanted = !eraser && tool_.kind != ToolKind::pin && tool_.kind != ToolKind::erase;
  if (line_wanted && is_tap(stroke, view.viewport)) return base::Error{"a tap draws nothing", "line", "draw a line"};
  const auto command = command_of(document(), tool_, view, stroke, eraser);
  if (!command) return command.error();
  return perform(*command);
}

document::View opening_view(const document::Document& document) {
  const geometry::Camera camera = geometry::frame_box(rest_world_box(*document.model), {}, 0);
  return {camera.pose(), camera.viewport()};
}

}  // namespace penpose::drawing
