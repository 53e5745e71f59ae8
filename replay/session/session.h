#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/drawing/editor.h"
#include "firmware_io/decode/wacom/wacom_receiver.h"
#include "replay/session/hand_input.h"
#include "replay/session/pen_input.h"
#include "replay/session/session_line.h"

namespace penpose::replay {

/// What a report or a line did to the document.
struct SessionStep {
  bool is_stroke = false;             ///< a stroke on the canvas ended; otherwise a command, an undo or a redo
  base::Status status{base::Done{}};  ///< why it changed nothing
};

/// A document being drawn on by tablets: reports and lines in, changes of the document out. The app and the replay of a
/// session feed the same calls to this, so that they end in the same state.
class Session {
 public:
  explicit Session(document::Document document, const decode::TabletTable* own = nullptr);

  [[nodiscard]] drawing::Editor& editor() { return editor_; }
  [[nodiscard]] const drawing::Editor& editor() const { return editor_; }
  [[nodiscard]] PenInput& pens() { return pens_; }
  [[nodiscard]] const PenInput& pens() const { return pens_; }

  /// Called when a stroke has ended and before it is drawn, which may take a moment: the time to write it down.
  void listen_to_stroke_ends(std::function<void()> listener) { on_stroke_end_ = std::move(listener); }

  /// The keys, dials and fingers of the tablets. They change no document by themselves: what a key was bound to is in
  /// the lines that follow.
  [[nodiscard]] const HandInput& hands() const { return hands_; }
  /// What the other hand did in the last report, or was made to let go by the last line. Valid until the next call.
  [[nodiscard]] std::span<const HandMoment> hand_moments() const { return hand_moments_; }

  void connect(int device, const decode::DeviceIdentity& identity);
  /// The tablet that a device is part of: behind a wireless receiver the one that it hears. Null for unknown devices.
  [[nodiscard]] const decode::DeviceIdentity* identity_of(int device) const;
  /// What a receiver said last, to be given to a session that goes on with its devices.
  [[nodiscard]] base::Bytes receiver_status(int device) const { return receivers_.last_status(device); }
  /// One report: the moments it held, and in `steps` what strokes that ended with it did. Both are valid until the next
  /// call.
  std::span<const PenMoment> report(int device, std::int64_t time_us, base::Bytes bytes);
  /// One line. Lines that name a session, a model or a state change nothing here.
  base::Status apply(const SessionLine& line, std::int64_t time_us);
  /// What the last call of `report` or `apply` did to the document, in order.
  [[nodiscard]] std::span<const SessionStep> steps() const { return steps_; }

  /// Strokes that ended so far, those on panels and those that failed among them.
  [[nodiscard]] std::size_t stroke_count() const { return strokes_; }

 private:
  void draw_completed();
  void hear(std::span<const decode::WacomReceivers::Change> changes, std::int64_t time_us);

  drawing::Editor editor_;
  PenInput pens_;
  HandInput hands_;
  decode::WacomReceivers receivers_;
  std::map<int, decode::DeviceIdentity> identities_;
  std::span<const HandMoment> hand_moments_;
  std::vector<HandMoment> heard_moments_;  ///< those that came with another tablet
  std::vector<SessionStep> steps_;
  std::size_t strokes_ = 0;
  std::function<void()> on_stroke_end_;
};

}  // namespace penpose::replay
