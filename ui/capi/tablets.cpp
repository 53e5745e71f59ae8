#include <algorithm>

#include "ui/capi/from_c.h"

using namespace penpose;        // NOLINT(google-build-using-namespace): functions of C have no namespace of their own
using namespace penpose::capi;  // NOLINT(google-build-using-namespace)

namespace {

penpose_axis axis_of(const decode::Axis& axis) {
  return {axis.present ? 1 : 0, axis.minimum, axis.maximum, axis.units_per_mm};
}

penpose_sample sample_of(const decode::PenSample& sample) {
  penpose_sample out{};
  out.x = sample.x;
  out.y = sample.y;
  out.pressure = sample.pressure;
  out.tilt_x = sample.tilt_x;
  out.tilt_y = sample.tilt_y;
  out.distance = sample.distance;
  out.rotation = sample.rotation;
  out.wheel = sample.wheel;
  out.serial = sample.serial;
  out.tool_id = sample.tool_id;
  out.buttons = sample.buttons;
  out.tool = static_cast<std::int32_t>(sample.tool);
  out.in_range = sample.in_range ? 1 : 0;
  out.tip = sample.tip ? 1 : 0;
  return out;
}

}  // namespace

int32_t penpose_tablet(penpose_library* library, const penpose_interface* interface_of, penpose_handle* tablet,
                       penpose_axes* axes, penpose_error* error) {
  return call(error, [&] {
    needed(library, "library");
    needed(tablet, "tablet");
    const penpose_interface& given = needed(interface_of, "interface_of");
    decode::DeviceIdentity identity;
    identity.bus = given.bus;
    identity.vendor = given.vendor;
    identity.product = given.product;
    if (given.name != nullptr) identity.name = given.name;
    const auto descriptor = array(given.descriptor, given.descriptor_size, "descriptor");
    identity.report_descriptor.assign(descriptor.begin(), descriptor.end());
    decode::complete_identity(identity);
    auto recognition = taken(decode::make_decoder(identity));
    const decode::PenAxes known = recognition.decoder->axes();
    give<TabletObject>(*library, *tablet, std::move(recognition.decoder));
    if (axes == nullptr) return;
    *axes = {axis_of(known.x),      axis_of(known.y),        axis_of(known.pressure), axis_of(known.tilt_x),
             axis_of(known.tilt_y), axis_of(known.distance), axis_of(known.rotation), axis_of(known.wheel)};
  });
}

int32_t penpose_tablet_report(penpose_library* library, penpose_handle tablet, const void* report, size_t size,
                              penpose_sample* samples, size_t room, size_t* count, penpose_error* error) {
  return call_with<TabletObject>(library, tablet, error, [&](TabletObject& object) {
    needed(count, "count");
    const auto bytes = array(static_cast<const std::uint8_t*>(report), size, "report");
    const auto out = array(samples, room, "samples");
    const bool said = object.decoder->decode(bytes) == decode::ReportKind::pen;
    const auto frames = said ? object.decoder->frames() : std::span<const decode::PenSample>();
    *count = frames.size();
    const auto last = frames.last(std::min(room, frames.size()));
    std::transform(last.begin(), last.end(), out.begin(), sample_of);
    if (last.size() == frames.size()) return;
    fail(PENPOSE_TOO_SMALL, {"the report went through " + std::to_string(frames.size()) + " states", "room",
                             "give more room; the last ones were written"});
  });
}
