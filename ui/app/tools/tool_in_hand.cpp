#include "ui/app/tools/tool_in_hand.h"

#include <algorithm>
#include <utility>

namespace penpose::app {

namespace {

/// Whether a line stays where it began: a touch of the canvas.
bool is_touch(const std::vector<PxPoint>& line, geometry::Viewport viewport) {
  curve::Stroke stroke;
  for (const PxPoint& p : line) stroke.push_back({.position = p});
  return drawing::is_tap(stroke, viewport);
}

}  // namespace

const WindowTool& ToolInHand::now() const {
  const drawing::ToolKind kind = parts_.editing.editor().tool().kind;
  return chosen_ != nullptr && chosen_->kind == kind ? *chosen_ : window_tool(kind);
}

void ToolInHand::take(const WindowTool& tool) {
  if (!tool.performs) parts_.playback.while_drawing().performs = false;
  if (tool.pulls && !now().pulls) before_ = &now();
  chosen_ = &tool;
  drawing::Tool drawn;
  drawn.kind = tool.kind;
  parts_.playback.stop();
  parts_.editing.shown().preview(std::nullopt);
  parts_.editing.set_tool(drawn);
  parts_.panels.curve_menu.reset();
  parts_.panels.feature_menu.reset();
  if (tool.kind != drawing::ToolKind::none) parts_.panels.controls_tab = false;
  ToolHand hand{parts_.editing, parts_.controls, parts_.panels};
  if (tool.taken != nullptr) tool.taken(hand);
}

void ToolInHand::perform_or_end() {
  if (parts_.performer.performing()) return;
  bool& performs = parts_.playback.while_drawing().performs;
  const WindowTool& tool = now();
  if (std::exchange(performs, !performs)) {
    if (tool.pulls && before_ != nullptr) take(*before_);
    return;
  }
  // A path of time is redrawn at the pen's pace, and a target is drawn so.
  const bool draws = tool.kind == drawing::ToolKind::pose && document::waiting_reference(parts_.editing.document());
  if (tool.shows_arcs || draws) return;
  const auto tools = window_tools();
  take(*std::find_if(tools.begin(), tools.end(), [](const WindowTool& one) { return one.pulls; }));
}

std::string ToolInHand::hint() const {
  if (parts_.performer.performing()) return "Recording frame by frame: lift the pen to end the take";
  const WindowTool& tool = now();
  if (tool.shows_ghosts) return parts_.ghosts.hint();
  if (tool.hint == nullptr) return {};
  return tool.hint(
      {parts_.editing.document(), parts_.editing.editor().tool(), parts_.playback.while_drawing().performs});
}

void ToolInHand::press(PxPoint at) {
  line_ = {at};
  times_us_ = {parts_.editing.now_us()};
  revision_ = parts_.editing.revision();
  if (now().shows_ghosts) parts_.ghosts.press(at);
}

void ToolInHand::move(PxPoint at) {
  line_.push_back(at);
  times_us_.push_back(parts_.editing.now_us());
  ToolHand hand{parts_.editing, parts_.controls, parts_.panels};
  if (const WindowTool& tool = now(); tool.moved != nullptr) tool.moved(hand);
}

void ToolInHand::release() {
  const auto line = std::exchange(line_, {});
  const WindowTool& tool = now();
  if (tool.ended != nullptr && !line.empty()) {
    ToolHand hand{parts_.editing, parts_.controls, parts_.panels};
    tool.ended(hand,
               {line, parts_.editing.revision() != revision_, is_touch(line, parts_.editing.editor().view().viewport)});
  }
  if (tool.means == nullptr || line.empty()) return;
  if (tool.shows_ghosts) return parts_.ghosts.draw(line);
  const document::Document& document = parts_.editing.document();
  const document::View& view = parts_.editing.editor().view();
  std::vector<double> shares;
  for (const std::int64_t time_us : times_us_) {
    const std::int64_t all_us = std::max<std::int64_t>(1, times_us_.back() - times_us_.front());
    shares.push_back(static_cast<double>(time_us - times_us_.front()) / static_cast<double>(all_us));
  }
  const int rate = parts_.playback.rate();
  const auto arcs =
      tool.shows_arcs ? parts_.arcs.of(document, parts_.editing.features(), view, rate) : std::span<const ShownArc>();
  const bool paced = parts_.playback.while_drawing().performs;
  const auto command = tool.means({document, view, line, shares, arcs, paced, rate, 0.5 * parts_.canvas.target_px()});
  if (command) {
    parts_.editing.perform(*command);
  } else if (tool.shows_arcs && !is_touch(line, view.viewport)) {
    parts_.notices.tell("Nothing changed: begin and end the line on frames of one arc");
  }
}

}  // namespace penpose::app
