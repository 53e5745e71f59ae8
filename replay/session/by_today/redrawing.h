#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "replay/session/by_today/older_editions.h"
#include "replay/session/by_today/redrawn_session.h"
#include "replay/session/session_line.h"

namespace penpose::replay {

/// Follows a session of any edition while it is drawn again with today's reading: says what each of its steps is today,
/// compares what comes of it with what was recorded, and keeps undo to the steps that it took back then.
///
/// The calls of a step, in order: `begin_stroke`, or `begin_line` and `today`; `did` for each step of today's that it
/// became; `follow_up` with `did` once more; and `reached` with the state that the session has after it.
class Redrawing {
 public:
  explicit Redrawing(std::uint32_t edition);
  [[nodiscard]] std::uint32_t edition() const { return out_.edition; }

  /// Whether the session was begun on that document.
  [[nodiscard]] bool began_on(const document::Document& document, const base::Hash128& named);

  void begin_stroke(std::uint64_t number);
  /// `line`: "do ...", "undo" or "redo", as step_line gives it. `number`: of the line in the session, from 1.
  void begin_line(std::uint64_t number, std::string_view line);
  /// What that line is today. Errors: why nothing is to be
  /// done for it, which is kept for the report: today's reading cannot express it; it was refused then, and would not
  /// be now; there is nothing to undo or redo.
  [[nodiscard]] base::Result<std::vector<SessionLine>> today(std::string_view line, const document::Document& now);
  void did(const base::Status& status);
  /// What has to follow so that the document is as sessions of that edition had it.
  [[nodiscard]] std::optional<SessionLine> follow_up(const document::Document& now);
  void reached(const document::DocumentState& recorded, const document::Document& now, std::uint64_t line);

  /// How it came out. To be called once, at the end.
  [[nodiscard]] RedrawnSession finish();

 private:
  enum class Does : std::uint8_t { change, undo, redo };
  struct Pending {
    RedrawnStep step;
    Does does = Does::change;
    std::size_t done = 0;  ///< steps of today's
    bool refused = false;  ///< the last of them, or all: nothing is changed
    bool unknown = false;  ///< it cannot be expressed today
    document::KeyKind kind_before = document::KeyKind::smooth;
  };
  /// A step that undo took back then.
  struct Past {
    std::size_t today = 0;  ///< in so many steps of today's
    document::KeyKind before = document::KeyKind::smooth;
    document::KeyKind after = document::KeyKind::smooth;
  };

  void begin(std::uint64_t number, std::string_view what, Does does);
  void refuse(const base::Error& why, bool unknown);
  void set_kind(document::KeyKind kind);
  void make_hashers();
  void cross(bool back);
  void close(std::optional<bool> changed_then, bool changed_now);
  void keep_past(const Pending& step, bool changed_then, bool changed_now);

  std::vector<document::DocumentHasher> hashers_;  ///< one a form
  bool one_kind_;
  document::KeyKind kind_;
  std::shared_ptr<const document::Timeline> of_kind_;  ///< whose keys are all of that kind
  std::optional<Pending> pending_;
  std::vector<Past> done_;
  std::vector<Past> undone_;
  base::Hash128 recorded_;  ///< the last state that was recorded
  base::Hash128 now_;       ///< and the one that was there then, in the first form
  std::vector<std::string_view> differing_;
  RedrawnSession out_;
};

/// The line of a step without "# penpose "; nothing where a comment is none.
[[nodiscard]] std::optional<std::string_view> step_line(std::string_view comment);

}  // namespace penpose::replay
