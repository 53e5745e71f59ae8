#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ui/app/browser/file_list.h"
#include "ui/app/browser/places.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/files/file_kinds.h"
#include "ui/app/files/files.h"
#include "ui/app/panels/panels.h"
#include "ui/app/preferences.h"

namespace penpose::app {

/// What browsing works with.
struct BrowsedWith {
  Files& files;
  Preferences& preferences;
  Dialogs& dialogs;
};

/// What browsing keeps while the dialog is open. The folder is that of FileChoice.
struct FileBrowser {
  std::string text;                     ///< typed: the beginning of a name, or a path
  bool was_empty = false;               ///< nothing was typed in the last frame
  std::optional<std::size_t> chosen;    ///< by the arrows, in what is listed
  bool places_shown = false;            ///< where there is no room for both
  std::size_t kind = 0;                 ///< of the kinds offered
  std::optional<std::string> new_name;  ///< of a folder, being typed
  bool new_begins = false;              ///< its field takes the keyboard
  std::string new_error;
  std::string made;  ///< the folder that was made last, while it can be taken back

  // What was listed, and of what.
  std::string folder;
  FileView view;
  std::filesystem::file_time_type changed = {};
  std::vector<FileEntry> entries;
  std::string error;
  std::vector<FilePlace> places;
};

struct BrowseLook {
  std::span<const FileKind> kinds;  ///< at least one
  float rows = 6;                   ///< of the list, where there is room
  float rows_below = 1;             ///< of the dialog, below the list
  bool has_field = true;            ///< a field for the beginning of a name or a path; else the dialog has its own
};

/// Places, folders and files, by pen and keyboard: arrows, Return, Backspace for the folder above, Tab completes what
/// is typed. Gives the path of the file that was chosen.
[[nodiscard]] std::string browse(PanelContext& context, const BrowsedWith& with, const BrowseLook& look);

}  // namespace penpose::app
