#pragma once

#include <cstdint>
#include <string>

#include "core/document/document.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/notices.h"
#include "ui/app/playback/playback.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// A bookmark being changed in its dialog.
struct BookmarkEntry {
  double time_s = 0;
  std::string name;
  std::uint32_t color = 0;
};

/// The bookmark of the shown timeline at a moment; null: none. Valid until the document changes.
[[nodiscard]] const document::Bookmark* bookmark_at(const document::Document& document, double time_s);

/// Sets a bookmark at the cursor; where one is already, opens the dialog for its name and its colour.
void set_bookmark(EditingSession& editing, const Playback& playback, Dialogs& dialogs, Notices& notices);
/// Opens the dialog of a bookmark.
void edit_bookmark(const document::Bookmark& bookmark, Dialogs& dialogs);
/// Goes to the bookmark before (-1) or after (1) the cursor.
void step_bookmark(const EditingSession& editing, Playback& playback, Notices& notices, int direction);

}  // namespace penpose::app
