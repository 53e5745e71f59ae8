#include "ui/app/session/session_input.h"

#include <algorithm>
#include <optional>

#include "ui/app/session/editing_session.h"

namespace penpose::app {

using replay::PenMoment;

std::vector<PenMoment> SessionInput::pen(const replay::VirtualPenState& state) {
  return report(0, replay::virtual_pen_report(state, editing_.editor().view().viewport));
}

void SessionInput::connect(int device, const decode::DeviceIdentity& identity) {
  const document::Document before = editing_.document();
  editing_.live_->connect(device, identity);
  editing_.after_steps(before);
}

void SessionInput::disconnect(int device) { editing_.act(replay::TabletGone{device}); }

void SessionInput::set_tablet(int device, const replay::TabletSetting& setting) {
  editing_.act(replay::TabletSet{device, setting});
}

void SessionInput::see_lights(int device, const decode::Lights& lights) {
  editing_.act(replay::LightsSeen{device, lights});
}

void SessionInput::place_pen(bool on_canvas) {
  if (editing_.session().pens().on_canvas() != on_canvas) editing_.act(replay::PenPlace{on_canvas});
}

std::vector<PenMoment> SessionInput::report(int device, base::Bytes bytes) {
  return report_at(device, editing_.clock_(), bytes);
}

std::vector<PenMoment> SessionInput::report_at(int device, std::int64_t received_us, base::Bytes bytes) {
  EditingSession& editing = editing_;
  const std::int64_t time_us = std::max<std::int64_t>(0, received_us - editing.began_us_);
  const document::Document before = editing.document();
  const document::History& history = editing.editor().history();
  const std::size_t count = history.undo_count();
  // What the report may end.
  std::optional<replay::DrawnStroke> drawn;
  if (editing.pen_is_drawing()) drawn = *editing.session().pens().current();
  const auto moments = editing.live_->report(device, time_us, bytes);
  std::vector<PenMoment> out(moments.begin(), moments.end());
  if (history.undo_count() > count) editing.steps_.performed(count, false);
  editing.after_steps(before);
  if (drawn && !editing.pen_is_drawing()) editing.tell_of_cut(before, *drawn);
  // The stroke has ended: what is shown is the document again.
  if (!editing.pen_is_drawing()) editing.shown_.end_stroke();
  if (history.undo_count() > count) editing.follow_habits(before, true);
  return out;
}

}  // namespace penpose::app
