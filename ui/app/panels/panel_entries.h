#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "ui/app/view/area.h"
#include "ui/app/widgets/picture_frame.h"

// What panels keep that others look at.

namespace penpose::app {

/// Where the progress of a film is shown; nothing: none is written.
struct FilmPlace {
  std::optional<Area> area;
};

/// Bars over the canvas that others leave room for; nothing: it is not there.
struct CanvasBars {
  std::optional<Area> cast;       ///< the characters, above
  std::optional<Area> reference;  ///< what is done with the reference in hand, at the foot
};

/// Which parameters are listed.
struct ParameterList {
  std::string filter;
  std::set<std::string> folded;  ///< groups
  bool moved_only = false;       ///< only controls that are not at rest
  /// Those that were listed so. One that is locked stays, though what was drawn is then solved without it.
  std::set<std::string> moved;
};

/// The list of sketched controls.
struct ControlList {
  std::string scrolled_to;  ///< the one that it was last scrolled to
  std::string rename;       ///< what is being typed as a name of the selected control
};

/// What the timeline shows below its ruler.
enum class TimelinePart : std::uint8_t {
  poses,   ///< the moments of keys alone
  sheet,   ///< a row for each control besides
  curves,  ///< the curves of the chosen controls
};

/// What a pen does in the sheet or on the curves, from its press to its release.
struct KeyDrag {
  enum class Does : std::uint8_t { nothing, boxes, moves, scales_from, scales_to, handles };
  Does does = Does::nothing;
  std::pair<float, float> from = {};  ///< px
  double begin_s = 0;                 ///< moment below the press
  double value = 0;                   ///< likewise, a share of the range
  bool pulled = false;                ///< far enough to be no touch
  std::size_t control = 0;            ///< of a handle
  double key_s = 0;                   ///< likewise
  bool incoming = false;              ///< likewise
};

/// The part of time that the timeline shows, seconds.
struct TimelineShown {
  TimelinePart part = TimelinePart::poses;
  bool all_rows = false;                 ///< also controls that rest in every key
  std::set<std::string> folded;          ///< groups
  std::set<std::size_t> chosen;          ///< controls whose curves are shown
  std::optional<double> breakdown = {};  ///< where its slider is held; nothing: it is not
  double rows_px = 0;                    ///< how high the sheet or the curves are; 0: they have no room
  float scrolled = 0;                    ///< px of rows above the first that is seen
  KeyDrag drag;
  double from_s = 0;
  double span_s = 0;                                  ///< 0: all
  double seen_time_s = 0;                             ///< where the cursor was last brought into sight
  std::optional<std::pair<double, double>> key_drag;  ///< a key in hand: from, to
  std::string frame_text;                             ///< what is being typed as a frame
  bool frame_typed = false;                           ///< it is being typed
};

/// The row of other readings.
struct ReadingsPlace {
  std::optional<Area> area;          ///< at the foot of the canvas; nothing: none is there
  std::optional<std::size_t> taken;  ///< the button that the pen pressed and is still over
};

/// What the pictures of other readings show: all alike what differs between them, from where one looks.
struct ReadingsFrame {
  std::uint64_t revision = 0;  ///< of the document that they are readings of
  std::size_t count = 0;       ///< of readings
  PictureFrame frame;
};

}  // namespace penpose::app
