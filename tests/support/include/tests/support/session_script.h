#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "replay/session/live_session.h"
#include "replay/session/virtual_pen.h"

namespace penpose::tests {

/// Draws on a document with a virtual pen, as a hand would, and keeps the session's text.
class SessionScript {
 public:
  explicit SessionScript(document::Document document, std::string model_path = "test-model")
      : writer_(
            [this](std::string_view text, bool) -> base::Status {
              text_ += text;
              return base::Done{};
            },
            "penpose-test"),
        live_(std::make_unique<replay::LiveSession>(std::move(document), &writer_, std::move(model_path))) {
    live_->connect(0, replay::virtual_pen_identity());
  }

  [[nodiscard]] replay::LiveSession& live() { return *live_; }
  [[nodiscard]] const drawing::Editor& editor() const { return live_->session().editor(); }
  [[nodiscard]] drawing::Editor& editor() { return live_->session().editor(); }
  [[nodiscard]] const document::Document& document() const { return editor().document(); }
  /// Everything that was written so far.
  [[nodiscard]] const std::string& text() const { return text_; }

  base::Status act(const replay::SessionLine& line) {
    time_us_ += 20000;
    return live_->act(line, time_us_);
  }
  base::Status perform(const document::Command& command) { return act(replay::Performed{command}); }
  void choose(drawing::ToolKind kind) {
    drawing::Tool tool;
    tool.kind = kind;
    static_cast<void>(act(replay::ToolChosen{tool}));
  }

  /// One stroke, a report for each point. Gives what it did; done when nothing was to be done.
  base::Status stroke(const std::vector<geometry::PxPoint>& line, double pressure = 0.5, bool eraser = false) {
    base::Status status{base::Done{}};
    const auto send = [&](geometry::PxPoint at, bool tip, bool in_range) {
      time_us_ += 3333;
      const auto report =
          replay::virtual_pen_report({at, pressure, in_range, tip, eraser, false}, editor().view().viewport);
      live_->report(0, time_us_, report);
      if (!live_->session().steps().empty()) status = live_->session().steps().back().status;
    };
    if (line.empty()) return status;
    send(line.front(), false, true);
    for (const geometry::PxPoint& p : line) send(p, true, true);
    send(line.back(), false, true);
    send(line.back(), false, false);
    time_us_ += 100000;
    return status;
  }

 private:
  std::string text_;
  replay::SessionWriter writer_;
  std::unique_ptr<replay::LiveSession> live_;
  std::int64_t time_us_ = 0;
};

}  // namespace penpose::tests
