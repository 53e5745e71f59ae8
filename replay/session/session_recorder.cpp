#include "replay/session/session_recorder.h"

namespace penpose::replay {

// The writer keeps its first error; whoever owns it asks for it at the end.

void SessionRecorder::on_begin(Session& session, const std::string& model_path) {
  static_cast<void>(writer_.begin(session.editor().state().whole, place_of_ ? place_of_(model_path) : model_path));
}

void SessionRecorder::on_device(int device, const decode::DeviceIdentity& identity) {
  static_cast<void>(writer_.declare(device, trace_device(identity)));
}

void SessionRecorder::on_report(const TraceReport& report) {
  writer_.report(report.device, report.time_us, report.bytes);
}

void SessionRecorder::on_line(const SessionLine& line) { static_cast<void>(writer_.line(line)); }

void SessionRecorder::on_stroke_end() { static_cast<void>(writer_.flush(true)); }

void SessionRecorder::on_step(Session& session, const SessionStep&) {
  static_cast<void>(writer_.state(session.editor().state()));
}

TraceDevice trace_device(const decode::DeviceIdentity& identity) {
  TraceDevice device;
  device.report_descriptor = identity.report_descriptor;
  device.name = identity.name.empty() ? "unknown" : identity.name;  // readers of traces expect one
  const std::string unit = identity.unit.empty() ? "penpose" : identity.unit;
  if (identity.interface_number) {
    device.physical = unit + "/input" + std::to_string(*identity.interface_number);
  } else if (!identity.unit.empty()) {
    device.physical = unit;
  }
  device.bus = identity.bus;
  device.vendor = identity.vendor;
  device.product = identity.product;
  device.strings = identity.strings;
  return device;
}

}  // namespace penpose::replay
