#include "replay/session/hand_input.h"

#include <algorithm>

namespace penpose::replay {

void HandInput::connect(int device, const decode::DeviceIdentity& identity) {
  auto hand = decode::make_hand_decoders(identity, own_, switches_.join(device, identity));
  interfaces_.erase(device);
  pens_.erase(device);
  if (identity.bus == decode::k_bus_virtual) virtual_.insert(device);
  if (identity.bus != decode::k_bus_virtual) virtual_.erase(device);
  if (!hand.pad && !hand.touch) return;
  Interface& interface = interfaces_[device];
  if (hand.pad) interface.events = decode::PadEvents(hand.pad->features());
  interface.hand = std::move(hand);
  if (const auto lights = lights_.find(device); lights != lights_.end()) apply_lights(device, lights->second);
}

void HandInput::take_events(int device) {
  for (const decode::PadEvent& event : events_) moments_.push_back({HandMoment::Kind::pad, device, event});
  events_.clear();
}

std::span<const HandMoment> HandInput::disconnect(int device, std::int64_t time_us) {
  moments_.clear();
  lights_.erase(device);
  pen(device, false, time_us);
  const auto found = interfaces_.find(device);
  if (found == interfaces_.end()) return moments_;
  Interface& interface = found->second;
  interface.events.finish(time_us, events_);
  take_events(device);
  if (interface.hand.pad) interface.hand.pad->reset();
  if (interface.hand.touch) interface.hand.touch->reset();
  if (!interface.fingers.empty()) {
    interface.fingers.clear();
    moments_.push_back({HandMoment::Kind::fingers, device, {}});
  }
  interface.palm.reset();
  interface.battery = {};
  return moments_;
}

void HandInput::pen(int device, bool near, std::int64_t time_us) {
  if (virtual_.contains(device)) return;
  pens_[device] = near;
  const bool any = std::any_of(pens_.begin(), pens_.end(), [](const auto& one) { return one.second; });
  for (auto& [number, interface] : interfaces_) interface.palm.pen(any, time_us);
}

void HandInput::end_frame(int device, Interface& interface, std::int64_t time_us) {
  const auto through = interface.palm.let_through(interface.hand.touch->contacts(), time_us);
  interface.fingers.assign(through.begin(), through.end());
  moments_.push_back({HandMoment::Kind::fingers, device, {}});
}

std::span<const HandMoment> HandInput::report(int device, std::int64_t time_us, base::Bytes bytes) {
  moments_.clear();
  if (!lights_.empty()) lights_.erase(device);
  const auto found = interfaces_.find(device);
  if (found == interfaces_.end()) return moments_;
  Interface& interface = found->second;
  decode::PadDecoder* pad = interface.hand.pad.get();
  if (pad != nullptr && pad->decode(bytes)) {
    interface.events.add(pad->sample(), time_us, events_);
    take_events(device);
  }
  // Some tell of it in reports that tell of no key.
  if (pad != nullptr && !(pad->battery() == interface.battery)) {
    interface.battery = pad->battery();
    moments_.push_back({HandMoment::Kind::battery, device, {}});
  }
  if (interface.hand.touch && interface.hand.touch->decode(bytes)) end_frame(device, interface, time_us);
  return moments_;
}

void HandInput::set_lights(int device, const decode::Lights& lights) {
  lights_[device] = lights;
  apply_lights(device, lights);
}

void HandInput::apply_lights(int device, const decode::Lights& lights) {
  const auto found = interfaces_.find(device);
  if (found == interfaces_.end() || !found->second.hand.pad) return;
  for (std::size_t side = 0; side < lights.size(); ++side) found->second.hand.pad->set_light(side, lights[side]);
}

const decode::PadDecoder* HandInput::pad(int device) const {
  const auto found = interfaces_.find(device);
  return found == interfaces_.end() ? nullptr : found->second.hand.pad.get();
}

const decode::TouchDecoder* HandInput::touch(int device) const {
  const auto found = interfaces_.find(device);
  return found == interfaces_.end() ? nullptr : found->second.hand.touch.get();
}

std::span<const decode::TouchContact> HandInput::fingers(int device) const {
  const auto found = interfaces_.find(device);
  if (found == interfaces_.end()) return {};
  return found->second.fingers;
}

}  // namespace penpose::replay
