#pragma once

#include <string>

#include "replay/session/session.h"
#include "replay/session/session_writer.h"

namespace penpose::replay {

/// A session that happens now: what tablets and the user do changes the document and is written down in the same order,
/// with the state after every stroke and command.
class LiveSession {
 public:
  /// `writer` may be null: then nothing is written. It must outlive this. `model_path` is the hint in the session.
  LiveSession(document::Document document, SessionWriter* writer, const std::string& model_path,
              const decode::TabletTable* own = nullptr);
  /// Goes on with a session that `writer` adds to: one that was read from the file up to its end, which came at
  /// `last_us`. Strokes that were cut off there end.
  LiveSession(Session session, SessionWriter* writer, std::int64_t last_us);
  LiveSession(const LiveSession&) = delete;
  LiveSession& operator=(const LiveSession&) = delete;

  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] const Session& session() const { return session_; }

  void connect(int device, const decode::DeviceIdentity& identity);
  /// As Session::report; `session().steps()` says what it did.
  std::span<const PenMoment> report(int device, std::int64_t time_us, base::Bytes bytes);
  /// As Session::apply.
  base::Status act(const SessionLine& line, std::int64_t time_us);

 private:
  void listen();
  void write_state();

  Session session_;
  SessionWriter* writer_;
  std::int64_t last_us_ = 0;  ///< time of the last report
};

}  // namespace penpose::replay
