#include "replay/session/pen_input.h"

#include <utility>

namespace penpose::replay {

using decode::PenEventKind;

namespace {

/// A pen's stroke has at most so many samples, an hour at a thousand a second; what comes after is not kept.
constexpr std::size_t k_most_samples = 3'600'000;

base::Result<decode::PenMappingOptions> options_of(const TabletSetting& setting, geometry::Viewport viewport) {
  decode::PenMappingOptions options;
  options.width_px = viewport.width;
  options.height_px = viewport.height;
  options.keep_aspect = setting.keep_aspect;
  options.left_handed = setting.left_handed;
  options.quarter_turns = static_cast<int>(setting.quarter_turns % 4);
  if (setting.area.size() == 4) {
    options.area = decode::TabletArea{setting.area[0], setting.area[1], setting.area[2], setting.area[3]};
  } else if (!setting.area.empty()) {
    return base::Error{"a tablet's area has four numbers", "area", "give left;top;right;bottom in fractions"};
  }
  if (!setting.pressure.empty()) {
    std::vector<decode::PressureCurve::Point> points;
    for (const curve::PxPoint& p : setting.pressure) points.push_back({p.x, p.y});
    auto made = decode::PressureCurve::make(std::move(points));
    if (!made) return made.error();
    options.pressure = std::move(made).value();
  }
  return options;
}

base::Error wrong_area() {
  return {"the area is empty or reaches beyond the tablet", "area", "give fractions from 0 to 1"};
}

}  // namespace

void PenInput::connect(int device, const decode::DeviceIdentity& identity) {
  Tablet& tablet = tablets_[device];
  if (tablet.stroke) completed_.push_back(*std::move(tablet.stroke));
  const TabletSetting setting = tablet.setting;
  tablet = Tablet{};
  tablet.setting = setting;
  auto recognition = decode::make_decoder(identity, own_);
  if (recognition) {
    tablet.decoder = std::move(recognition->decoder);
    tablet.method = std::move(recognition->method);
    tablet.guess = std::move(recognition->guess);
    tablet.by_table = tablet.decoder->by_table();
  }
  map_anew(tablet);
}

std::span<const PenMoment> PenInput::disconnect(int device, std::int64_t time_us) {
  moments_.clear();
  const auto found = tablets_.find(device);
  if (found == tablets_.end()) return moments_;
  events_.clear();
  found->second.events.finish(time_us, events_);
  take_events(found->second);
  return moments_;
}

base::Status PenInput::set_tablet(int device, const TabletSetting& setting) {
  auto options = options_of(setting, view_.viewport);
  if (!options) return options.error();
  Tablet& tablet = tablets_[device];
  if (!tablet.decoder) {
    // The tablet may come later; what can be wrong without knowing it is told now.
    decode::PenAxes any;
    any.x.maximum = any.y.maximum = 1;
    if (const auto mapping = decode::PenMapping::make(any, *std::move(options)); !mapping) return wrong_area();
  }
  const TabletSetting before = std::exchange(tablet.setting, setting);
  map_anew(tablet);
  if (!tablet.decoder || tablet.mapping) return base::Done{};
  tablet.setting = before;
  map_anew(tablet);
  return wrong_area();
}

void PenInput::set_view(const document::View& view) {
  const bool resized = !(view.viewport == view_.viewport);
  view_ = view;
  if (!resized) return;
  for (auto& [device, tablet] : tablets_) map_anew(tablet);
}

void PenInput::map_anew(Tablet& tablet) const {
  tablet.mapping.reset();
  if (!tablet.decoder) return;
  auto options = options_of(tablet.setting, view_.viewport);
  if (!options) return;
  auto mapping = decode::PenMapping::make(tablet.decoder->axes(), std::move(options).value());
  if (mapping) tablet.mapping = std::move(mapping).value();
}

std::span<const PenMoment> PenInput::report(int device, std::int64_t time_us, base::Bytes bytes) {
  moments_.clear();
  const auto found = tablets_.find(device);
  if (found == tablets_.end()) return moments_;
  Tablet& tablet = found->second;
  if (!tablet.decoder || !tablet.mapping) return moments_;
  if (tablet.decoder->decode(bytes) != decode::ReportKind::pen) return moments_;
  if (tablet.decoder->by_table() != tablet.by_table) {
    // The tablet was switched between the form that it describes and its maker's own, whose ranges differ.
    tablet.by_table = !tablet.by_table;
    map_anew(tablet);
    if (!tablet.mapping) return moments_;
  }
  tablet.was_guess = tablet.was_guess || tablet.by_table;
  events_.clear();
  for (const decode::PenSample& sample : tablet.decoder->frames()) tablet.events.add(sample, time_us, events_);
  take_events(tablet);
  return moments_;
}

void PenInput::take_events(Tablet& tablet) {
  for (const decode::PenEvent& event : events_) {
    // A puck lies on the tablet like a pen but draws nothing.
    if (event.tool == decode::Tool::mouse) continue;
    const auto& mapping = tablet.stroke_mapping ? tablet.stroke_mapping : tablet.mapping;
    if (!mapping) continue;
    const decode::MappedSample mapped = mapping->map(event.sample);
    const PenMoment moment{
        event.kind,        {mapped.x_px, mapped.y_px}, mapped.pressure, event.tool == decode::Tool::eraser,
        event.button,      event.sample.buttons,       event.time_us,   event.sample.rotation,
        event.sample.wheel};
    moments_.push_back(moment);
    if (event.kind == PenEventKind::stroke_begin) {
      tablet.stroke =
          DrawnStroke{{}, view_, moment.eraser, on_canvas_ && (moment.buttons & ~tablet.setting.drawing_buttons) == 0};
      tablet.stroke_mapping = tablet.mapping;
    }
    if (!tablet.stroke) continue;
    if (event.kind == PenEventKind::stroke_begin || event.kind == PenEventKind::stroke_point) {
      if (tablet.stroke->samples.size() < k_most_samples) {
        tablet.stroke->samples.push_back({moment.position, moment.pressure, moment.time_us});
      }
    } else if (event.kind == PenEventKind::stroke_end) {
      completed_.push_back(*std::move(tablet.stroke));
      tablet.stroke.reset();
      tablet.stroke_mapping.reset();
    }
  }
}

const DrawnStroke* PenInput::current() const {
  for (const auto& [device, tablet] : tablets_) {
    if (tablet.stroke) return &*tablet.stroke;
  }
  return nullptr;
}

bool PenInput::draws(int device) const {
  const auto found = tablets_.find(device);
  return found != tablets_.end() && found->second.stroke.has_value();
}

std::vector<int> PenInput::drawing() const {
  std::vector<int> devices;
  for (const auto& [device, tablet] : tablets_) {
    if (tablet.stroke) devices.push_back(device);
  }
  return devices;
}

bool PenInput::decodes(int device) const {
  const auto found = tablets_.find(device);
  return found != tablets_.end() && found->second.decoder != nullptr;
}

const decode::PenAxes* PenInput::axes_of(int device) const {
  const auto found = tablets_.find(device);
  return found == tablets_.end() || !found->second.decoder ? nullptr : &found->second.decoder->axes();
}

std::string PenInput::guess_of(int device) const {
  const auto found = tablets_.find(device);
  return found == tablets_.end() || !found->second.was_guess ? std::string() : found->second.guess;
}

std::vector<std::string> PenInput::guesses() const {
  std::vector<std::string> texts;
  for (const auto& [device, tablet] : tablets_) {
    if (std::string guess = guess_of(device); !guess.empty()) texts.push_back(std::move(guess));
  }
  return texts;
}

std::string PenInput::method_of(int device) const {
  const auto found = tablets_.find(device);
  return found == tablets_.end() ? std::string() : found->second.method;
}

}  // namespace penpose::replay
