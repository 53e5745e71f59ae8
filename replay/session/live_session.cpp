#include "replay/session/live_session.h"

#include <utility>

#include "replay/session/session_recorder.h"

namespace penpose::replay {

// The writer keeps its first error for whoever owns it; drawing goes on without it.

LiveSession::LiveSession(document::Document document, SessionWriter* writer, const std::string& model_path,
                         const decode::TabletTable* own)
    : session_(std::move(document), own), writer_(writer) {
  if (writer_ == nullptr) return;
  static_cast<void>(writer_->begin(session_.editor().state().whole, model_path));
  static_cast<void>(writer_->line(ViewChanged{session_.editor().view()}));
  listen();
}

LiveSession::LiveSession(Session session, SessionWriter* writer, std::int64_t last_us)
    : session_(std::move(session)), writer_(writer), last_us_(last_us) {
  listen();
  for (const int device : session_.pens().drawing()) static_cast<void>(act(TabletGone{device}, last_us_));
}

void LiveSession::listen() {
  session_.listen_to_stroke_ends([this] {
    if (writer_ != nullptr) static_cast<void>(writer_->flush(true));
  });
}

void LiveSession::connect(int device, const decode::DeviceIdentity& identity) {
  // A replay learns of the tablet with its first report only; the stroke that is cut off must end where it did here.
  if (session_.pens().draws(device)) static_cast<void>(act(TabletGone{device}, last_us_));
  if (writer_ != nullptr) static_cast<void>(writer_->declare(device, trace_device(identity)));
  session_.connect(device, identity);
}

std::span<const PenMoment> LiveSession::report(int device, std::int64_t time_us, base::Bytes bytes) {
  last_us_ = time_us;
  if (writer_ != nullptr) writer_->report(device, time_us, bytes);
  const auto moments = session_.report(device, time_us, bytes);
  write_state();
  return moments;
}

base::Status LiveSession::act(const SessionLine& line, std::int64_t time_us) {
  if (writer_ != nullptr) static_cast<void>(writer_->line(line));
  auto status = session_.apply(line, time_us);
  write_state();
  return status;
}

void LiveSession::write_state() {
  if (writer_ == nullptr || session_.steps().empty()) return;
  static_cast<void>(writer_->state(session_.editor().state()));
}

}  // namespace penpose::replay
