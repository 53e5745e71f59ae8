#include "replay/session.h"

#include <utility>

namespace penpose::replay {

Session::Session(document::Document document, const decode::TabletTable* own)
    : editor_(std::move(document)), pens_(own), hands_(own) {
  pens_.set_view(editor_.view());
}

void Session::draw_completed() {
  for (const DrawnStroke& stroke : pens_.take_strokes()) {
    ++strokes_;
    if (on_stroke_end_) on_stroke_end_();
    if (!stroke.on_canvas || editor_.tool().kind == drawing::ToolKind::none) continue;
    steps_.push_back({true, editor_.draw(stroke.samples, stroke.view, stroke.eraser)});
  }
}

std::span<const PenMoment> Session::report(int device, std::int64_t time_us, base::Bytes bytes) {
  steps_.clear();
  const auto moments = pens_.report(device, time_us, bytes);
  if (!moments.empty()) hands_.pen(device, moments.back().kind != decode::PenEventKind::away, time_us);
  hand_moments_ = hands_.report(device, time_us, bytes);
  draw_completed();
  return moments;
}

base::Status Session::apply(const SessionLine& line, std::int64_t time_us) {
  steps_.clear();
  hand_moments_ = {};
  base::Status status{base::Done{}};
  if (const auto* view = std::get_if<ViewChanged>(&line)) {
    status = editor_.set_view(view->view);
    if (status) pens_.set_view(view->view);
  } else if (const auto* tool = std::get_if<ToolChosen>(&line)) {
    editor_.set_tool(tool->tool);
  } else if (const auto* tablet = std::get_if<TabletSet>(&line)) {
    status = pens_.set_tablet(tablet->device, tablet->setting);
  } else if (const auto* gone = std::get_if<TabletGone>(&line)) {
    pens_.disconnect(gone->device, time_us);
    hand_moments_ = hands_.disconnect(gone->device, time_us);
    draw_completed();
  } else if (const auto* place = std::get_if<PenPlace>(&line)) {
    pens_.set_on_canvas(place->on_canvas);
  } else if (const auto* performed = std::get_if<Performed>(&line)) {
    status = editor_.perform(performed->command);
    steps_.push_back({false, status});
  } else if (std::holds_alternative<Undone>(line)) {
    status = editor_.undo();
    steps_.push_back({false, status});
  } else if (std::holds_alternative<Redone>(line)) {
    status = editor_.redo();
    steps_.push_back({false, status});
  }
  return status;
}

}  // namespace penpose::replay
