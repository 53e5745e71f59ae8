#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/interface.h"

namespace penpose::portal {

/// Files of some extensions, as the system's dialog offers them.
struct FileFilter {
  std::string label;
  std::vector<std::string> extensions;  ///< in lower case, with their dots; none: every file
};

/// What the system's dialog of files is asked for.
struct FileQuestion {
  bool saves = false;
  std::string title;
  std::string parent;  ///< the window before which it stands, "x11:1a2b"; may be empty
  std::string folder;  ///< where it begins
  std::string name;    ///< that is offered to be saved under
  std::vector<FileFilter> filters;
};

struct FileAnswer {
  enum class Kind : std::uint8_t {
    waits,        ///< there is none yet
    chosen,       ///< `path`
    cancelled,    ///< by the user
    unavailable,  ///< no portal answered within a moment, it refused, or it is gone
  };
  Kind kind = Kind::waits;
  std::string path;
};

/// The system's dialogs of files. One is open at a time, and nobody waits for it.
class FilePortal : public base::Interface {
 public:
  /// Asks, in place of what was asked before. Returns at once.
  virtual void ask(const FileQuestion& question) = 0;
  /// The answer, once; `waits` until there is one and afterwards.
  virtual FileAnswer take() = 0;
};

/// By xdg-desktop-portal over D-Bus, on a thread of its own; null: this program was built without it (PENPOSE_PORTAL).
/// `wake` is called from that thread when there is an answer.
[[nodiscard]] std::unique_ptr<FilePortal> make_file_portal(std::function<void()> wake);

/// The path of a "file:" address with its escapes; empty: it is no file of this machine.
[[nodiscard]] std::string path_of_address(const std::string& address);

}  // namespace penpose::portal
