#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "replay/session/session_line.h"
#include "replay/trace/trace_writer.h"

namespace penpose::replay {

/// Takes text to where a session is kept; `sync` asks for it to survive a power cut. After an error nothing of the text
/// is there.
using AppendText = std::function<base::Status(std::string_view text, bool sync)>;

/// Writes a session as it happens. What was drawn is handed over at the latest when a pen lifts, every other line at
/// once, so that a file cut off at any byte holds all that had ended. An error of the file is given back; the session
/// itself goes on, and what could not be written is kept and handed over again with what comes next, up to 64 MiB: a
/// disk that was full for a while costs nothing. Then nothing more is written.
class SessionWriter {
 public:
  SessionWriter(AppendText append, std::string program);

  /// The first lines: what is drawn on.
  base::Status begin(const base::Hash128& model, std::string_view path);
  base::Status declare(int device, const TraceDevice& facts);
  /// Handed over with the next line or stroke.
  void report(int device, std::int64_t time_us, base::Bytes bytes);
  base::Status line(const SessionLine& line);
  /// A stroke ended, or a command was done, and this is the state now.
  base::Status state(const document::DocumentState& state);
  /// Hands over what is left.
  base::Status flush(bool sync);

  /// Why the last lines are not written; nothing where they are.
  [[nodiscard]] const std::optional<base::Error>& broken() const { return broken_; }

 private:
  AppendText append_;
  std::string program_;
  TraceWriter writer_;
  std::string kept_;  ///< not written yet
  bool given_up_ = false;
  std::optional<base::Error> broken_;
};

}  // namespace penpose::replay
