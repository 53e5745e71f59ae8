#pragma once

#include <functional>
#include <string>
#include <utility>

#include "replay/session/session_player.h"
#include "replay/session/session_writer.h"

namespace penpose::replay {

/// Writes a replay down as a session of its own, with the states that it reaches: a plain trace becomes a session, and
/// one whose states are out of date gets new ones.
class SessionRecorder final : public PlayerObserver {
 public:
  /// `place_of`: where the model is that a session names, which the new one will name; empty: as it is named.
  explicit SessionRecorder(SessionWriter& writer, std::function<std::string(const std::string&)> place_of = {})
      : writer_(writer), place_of_(std::move(place_of)) {}

  void on_begin(Session& session, const std::string& model_path) override;
  void on_device(int device, const decode::DeviceIdentity& identity) override;
  void on_report(const TraceReport& report) override;
  void on_line(const SessionLine& line) override;
  void on_stroke_end() override;
  void on_step(Session& session, const SessionStep& step) override;

 private:
  SessionWriter& writer_;
  std::function<std::string(const std::string&)> place_of_;
};

/// How a trace declares a device that is known by its identity.
[[nodiscard]] TraceDevice trace_device(const decode::DeviceIdentity& identity);

}  // namespace penpose::replay
