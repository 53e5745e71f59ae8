#include "ui/app/app.h"

// What tablets do to the app: coming, going and their reports.

namespace penpose::app {
namespace {

using decode::PenEventKind;

/// After the last report of a pen that is near, the desktop's own pointer is ignored so long.
constexpr std::int64_t k_tablet_quiet_us = 250'000;

}  // namespace

bool App::tablet_is_near() const {
  return tablet_near_ && tablet_seen_us_ >= 0 && options_.clock() - tablet_seen_us_ < k_tablet_quiet_us;
}

void App::tablet_arrived(int device, const decode::DeviceIdentity& identity) {
  editing_.connect(device, identity);
  on_device(device, identity);
  if (editing_.session().pens().decodes(device)) editing_.set_tablet(device, setting_of(device));
  const bool again = tablets_.contains(device);
  tablets_[device] = identity;
  plugged_.insert(device);
  // Fingers alone are a part of a tablet that says so itself.
  const DeskTablet* tablet = desk_.find(device);
  if (decode::is_wacom_receiver(identity)) {
    // Its tablet says so itself once it is heard.
    if (decode::is_receiver_monitor(identity)) notices_.tell(identity.name + (again ? " is back" : " is ready"));
    return;
  }
  if (tablet == nullptr || tablet->has_anything()) notices_.tell(identity.name + (again ? " is back" : " is ready"));
}

void App::lights_seen(int device, const decode::Lights& lights) {
  if (lights_of(device).value_or(lights) != lights) editing_.see_lights(device, lights);
  lights_[device] = lights;
}

std::optional<decode::Lights> App::lights_of(int device) const {
  const decode::PadDecoder* pad = editing_.session().hands().pad(device);
  if (pad == nullptr || pad->features().modes == 0) return std::nullopt;
  return pad->sample().mode;
}

void App::tablet_setting_changed() {
  preferences_.changed();
  for (const auto& [device, name] : tablets_) {
    if (editing_.session().pens().decodes(device)) editing_.set_tablet(device, setting_of(device));
  }
}

void App::tablet_left(int device, const std::string& name) {
  editing_.disconnect(device);
  plugged_.erase(device);
  receiver_status_.erase(device);
  lights_.erase(device);
  const auto hand = editing_.session().hand_moments();
  const std::vector<replay::HandMoment> let_go(hand.begin(), hand.end());
  editing_.follow_pen();
  tablet_near_ = false;
  barrel_ = false;
  drag_.reset();
  touch_view_.reset();
  if (mouse_on_panel_) hover_panels(at_, false);
  mouse_on_panel_ = false;
  forget_tablet(device, name, let_go);
}

void App::try_pen(PxPoint at, double pressure, bool begins) {
  if (dialogs_.open() != Dialog::tablet) return;
  if (begins && dialogs_.state<PenTrial>().area.holds(at)) {
    dialogs_.state<PenTrial>().line.clear();
    dialogs_.state<PenTrial>().pressure.clear();
  }
  constexpr std::size_t k_most = 100000;
  if (dialogs_.state<PenTrial>().line.size() >= k_most ||
      (dialogs_.state<PenTrial>().line.empty() && !dialogs_.state<PenTrial>().area.holds(at)))
    return;
  dialogs_.state<PenTrial>().line.push_back(at);
  dialogs_.state<PenTrial>().pressure.push_back(pressure);
}

void App::tablet_report(int device, std::int64_t received_us, base::Bytes bytes) {
  canvas_.commit();
  const auto moments = editing_.report_at(device, received_us, bytes);
  const auto hand = editing_.session().hand_moments();
  take_hand(std::vector<replay::HandMoment>(hand.begin(), hand.end()));
  if (const base::Bytes status = editing_.session().receiver_status(device); !status.empty())
    receiver_status_[device].assign(status.begin(), status.end());
  if (const auto lights = lights_of(device)) lights_[device] = *lights;
  if (moments.empty()) return;
  tablet_seen_us_ = options_.clock();
  tablet_near_ = moments.back().kind != PenEventKind::away;
  for (const auto& moment : moments) {
    if (moment.kind == PenEventKind::stroke_begin) try_pen(moment.position, moment.pressure, true);
    if (moment.kind == PenEventKind::stroke_point) try_pen(moment.position, moment.pressure, false);
  }
  take_moments(device, moments);
}

}  // namespace penpose::app
