#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/io/surface/orientation.h"
#include "ui/files/own_tablets.h"

namespace penpose::files {

/// How the window is opened.
struct WindowRequest {
  std::string model;            ///< model, project or session; empty: the built-in head with its controls
  io::Orientation orientation;  ///< how the model's coordinates are meant, where it does not say so itself
  std::string session;          ///< where the session is written; empty: into the folder of sessions
  std::string replay;           ///< a trace that is played in place of a tablet; the window closes at its end
  OwnTablets own;               ///< what the user says of tablets
  std::string live;             ///< where the pose of every frame is sent (ui/live); empty: nowhere
  std::string program;          ///< name and version for the session
  bool fullscreen = false;
  std::string draw;           ///< how pictures are drawn: "gl", "es", "cpu"; empty: the best that starts
  std::optional<int> screen;  ///< which of the screens, from 0; none: the first
  int rotate = 0;             ///< degrees, clockwise, by which the picture is turned: 0, 90, 180, 270
  std::string rotate_input;   ///< which pens and fingers turn with it: "built-in" (also empty), "all", "none"
  double dpi = 0;             ///< px per inch of the screen; 0: as it says itself
  double scale = 0;           ///< of the interface, 1 being that of 96 px per inch; 0: as settings and system say
  bool slow_screen = false;   ///< one that takes long to change, such as electronic paper
  bool timings = false;       ///< prints how long things took when the window is closed
};

/// Opens the window and stays until it is closed.
using OpenWindow = std::function<base::Status(const WindowRequest&)>;

}  // namespace penpose::files
