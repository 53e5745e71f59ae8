#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "replay/session/pen_input.h"
#include "ui/app/browser/file_list.h"
#include "ui/app/hands/binding.h"
#include "ui/app/key_map.h"
#include "ui/app/playback/frames.h"
#include "ui/app/view/ink.h"

namespace penpose::app {

/// How large what is hit is: `usual` is 9 mm, which a finger and a pen hit for certain.
enum class Density : std::uint8_t { compact, usual, touch };

/// What somebody chose once and finds again.
struct Settings {
  double scale = 1;  ///< on top of the display's own, 0.5..3
  bool light = false;
  bool soft_shadows = true;  ///< in cavities and on the ground
  bool steps_seen = false;   ///< the first steps were shown
  bool side_closed = false;  ///< the panel at the right is a rail
  bool pose_first = false;   ///< Pose is in hand at first, not Draw: what was last taken of the two
  Density density = Density::usual;
  Stabiliser stabiliser = Stabiliser::light;
  int rate = k_usual_rate;  ///< frames a second of what has none of its own
  /// The menu around the pen, clockwise from the top.
  std::array<Action, 8> radial{Action::undo,       Action::redo,      Action::tool_pose,  Action::tool_constraint,
                               Action::tool_erase, Action::frame_all, Action::view_front, Action::key_pose};
  KeyMap keys;  ///< of the keyboard
  replay::TabletSetting tablet;
  /// What was chosen for the keys, dials and pens of tablets: by tablet, then by what is bound (`name_of`). What is
  /// missing does what `default_binding` says.
  std::map<std::string, std::map<std::string, Binding>> pads;
  // How high the dope sheet and the curves are, px at scale 1; 0: as usual.
  double sheet_height = 0, curves_height = 0;
  FileSort file_sort = FileSort::name;  ///< in dialogs of files
  bool hidden_files = false;            ///< there
  bool system_dialogs = true;           ///< of files, where there are some; else ours
  std::string pose_folder;              ///< of the library of poses; empty: the usual one
  std::vector<std::string> recent;      ///< files, the last one first
  std::vector<std::string> unread;      ///< lines that were not taken, which are written again as they are
  friend bool operator==(const Settings&, const Settings&) = default;
};

/// The range of Settings::sheet_height and curves_height, px.
inline constexpr double k_least_rows_px = 60, k_most_rows_px = 4000;
inline constexpr std::size_t k_most_recent = 10;
/// A file that was written by hand is read up to here.
inline constexpr std::size_t k_most_pads = 100;
inline constexpr std::size_t k_most_bindings = 200;

/// "name=value" lines. What cannot be read keeps its default, so that a broken file never keeps the app from starting;
/// `refused` gets why, a line each. Lines that begin with # are kept without a word.
[[nodiscard]] Settings parse_settings(std::string_view text, std::vector<base::Error>* refused = nullptr);
[[nodiscard]] std::string to_text(const Settings& settings);

[[nodiscard]] Settings load_settings(const std::string& folder, std::vector<base::Error>* refused = nullptr);
/// The file in that folder.
[[nodiscard]] std::string settings_file(const std::string& folder);
/// Written to a temporary file and renamed. An empty folder: nothing is kept.
base::Status save_settings(const Settings& settings, const std::string& folder);

/// Puts a file in front of the recent ones.
void remember_file(Settings& settings, const std::string& path);

}  // namespace penpose::app
