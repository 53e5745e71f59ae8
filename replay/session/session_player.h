#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/document.h"
#include "replay/session/by_today/redrawn_session.h"
#include "replay/session/session.h"
#include "replay/trace/trace_source.h"

namespace penpose::replay {

/// Watches a replay, in the order in which things happen.
class PlayerObserver {
 public:
  virtual ~PlayerObserver() = default;
  PlayerObserver() = default;
  PlayerObserver(const PlayerObserver&) = delete;
  PlayerObserver& operator=(const PlayerObserver&) = delete;

  virtual void on_begin(Session&, const std::string& /*model_path*/) {}
  virtual void on_device(int /*device*/, const decode::DeviceIdentity&) {}
  virtual void on_report(const TraceReport&) {}
  virtual void on_line(const SessionLine&) {}
  /// A stroke ended and is about to be drawn.
  virtual void on_stroke_end() {}
  virtual void on_step(Session&, const SessionStep&) {}
};

struct PlayerOptions {
  Pace pace = Pace::full_speed;
  TraceSource::Wait wait = {};  ///< of real time; replaced in tests
  /// Opens what a session names: a model, or a project that the session continued. `path` is as in the session; empty
  /// for a plain trace, which is drawn on the default model.
  std::function<base::Result<document::Document>(const std::string& path)> open;
  std::optional<std::size_t> stop_after_strokes = std::nullopt;
  std::function<bool(const Session&)> stop_when = {};  ///< asked after every step; may be empty
  /// Draws a session of this edition or an older one with today's reading, and says what came out differently.
  bool by_today = false;
  /// Whether what such a session was drawn on may be in another state than it was then; empty: it may not.
  std::function<bool(const std::string& path)> may_differ = {};
  const decode::TabletTable* own_tablets = nullptr;
  PlayerObserver* observer = nullptr;  ///< may be null
};

/// The first place where a replay is not what was recorded.
struct Divergence {
  std::uint64_t line = 0;               ///< of the file, from 1
  std::vector<std::string_view> parts;  ///< what differs (document::k_state_parts)
};

/// The message for it.
[[nodiscard]] base::Error error_of(const Divergence& divergence);

/// The session's model has another state than when it was recorded.
[[nodiscard]] base::Error changed_model_error(const std::string& path, const base::Hash128& found,
                                              const base::Hash128& named);
/// A session that names no model.
[[nodiscard]] base::Error no_model_error();

/// The result of a replay.
struct ReplayResult {
  std::unique_ptr<Session> session;  ///< null when the file holds nothing
  bool plain = true;                 ///< the file is a trace and no session: drawn with the defaults
  std::string program;               ///< that recorded it
  std::string model;                 ///< path in the session
  std::uint64_t reports = 0;
  std::size_t steps = 0;                  ///< strokes on the canvas and commands
  std::size_t refused = 0;                ///< of these, how many changed nothing
  std::vector<base::Error> refusals;      ///< the first few
  std::size_t checked = 0;                ///< states compared
  std::size_t differing = 0;              ///< of these, how many differed
  std::optional<Divergence> divergence;   ///< the first
  std::optional<RedrawnSession> redrawn;  ///< of a session that was drawn by today; nothing diverges then
  std::int64_t first_us = 0;              ///< time of the first report
  std::int64_t last_us = 0;               ///< and of the last
  std::vector<base::Error> problems;      ///< lines that could not be read, and a cut at the end: the rest was replayed
};

/// Replays a session or a plain trace, using memory that does not grow with its length. Errors: those of reading and of
/// loading the model; a session of another edition, unless it is older and drawn by today; a model that has changed
/// since it was recorded.
[[nodiscard]] base::Result<ReplayResult> play_session(ReadBytes read, const PlayerOptions& options);

}  // namespace penpose::replay
