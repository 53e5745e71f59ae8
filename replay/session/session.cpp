#include "replay/session/session.h"

#include <utility>

namespace penpose::replay {

Session::Session(document::Document document, const decode::TabletTable* own)
    : editor_(std::move(document)), pens_(own), hands_(own) {
  pens_.set_view(editor_.view());
}

void Session::connect(int device, const decode::DeviceIdentity& identity) {
  const decode::DeviceIdentity decoded = receivers_.connect(device, identity);
  identities_[device] = identity;
  pens_.connect(device, decoded);
  hands_.connect(device, decoded);
}

const decode::DeviceIdentity* Session::identity_of(int device) const {
  if (const decode::DeviceIdentity* shown = receivers_.shown(device)) return shown;
  const auto found = identities_.find(device);
  return found == identities_.end() ? nullptr : &found->second;
}

/// What was held on the tablet before is let go, its stroke ends, and the next one's reports follow.
void Session::hear(std::span<const decode::WacomReceivers::Change> changes, std::int64_t time_us) {
  if (changes.empty()) return;
  const std::vector<HandMoment> charge(hand_moments_.begin(), hand_moments_.end());
  heard_moments_.clear();
  for (const auto& [device, identity] : changes) {
    if (!decode::is_receiver_monitor(identity)) {
      pens_.disconnect(device, time_us);
      const auto let_go = hands_.disconnect(device, time_us);
      heard_moments_.insert(heard_moments_.end(), let_go.begin(), let_go.end());
      pens_.connect(device, identity);
      hands_.connect(device, identity);
    }
    heard_moments_.push_back({HandMoment::Kind::tablet, device, {}});
  }
  heard_moments_.insert(heard_moments_.end(), charge.begin(), charge.end());
  hand_moments_ = heard_moments_;
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
  hear(receivers_.report(device, bytes), time_us);
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
  } else if (const auto* seen = std::get_if<LightsSeen>(&line)) {
    hands_.set_lights(seen->device, seen->lights);
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
