#pragma once

#include <string>
#include <vector>

#include "ui/app/canvas/canvas.h"
#include "ui/app/controls/controls.h"
#include "ui/app/notices.h"
#include "ui/app/playback/arcs.h"
#include "ui/app/playback/ghosts.h"
#include "ui/app/playback/performer.h"
#include "ui/app/tools/tool.h"

namespace penpose::app {

/// The tool of the window that is in hand, and the line that it draws.
class ToolInHand {
 public:
  struct Parts {
    EditingSession& editing;
    Controls& controls;
    PanelState& panels;
    Playback& playback;
    const Performer& performer;
    const Canvas& canvas;
    ArcsInSight& arcs;
    GhostHand& ghosts;
    Notices& notices;
  };
  explicit ToolInHand(const Parts& parts) : parts_(parts) {}

  [[nodiscard]] const WindowTool& now() const;
  void take(const WindowTool& tool);
  /// Begins to perform, or ends it. A tool that has its own way to perform stays in hand, else what is under the pen is
  /// pulled; ended, the tool from before is in hand again.
  void perform_or_end();
  /// Says what to draw next, in one line.
  [[nodiscard]] std::string hint() const;

  // The pen on the canvas.
  void press(PxPoint at);
  void move(PxPoint at);
  void release();

 private:
  Parts parts_;
  const WindowTool* chosen_ = nullptr;  ///< of those that a session records as none
  const WindowTool* before_ = nullptr;  ///< that which pulls was taken in hand
  std::vector<PxPoint> line_;
  std::vector<std::int64_t> times_us_;  ///< of its points
  std::uint64_t revision_ = 0;          ///< of the document when it began
};

}  // namespace penpose::app
