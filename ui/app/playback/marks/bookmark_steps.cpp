#include "ui/app/playback/marks/bookmark_steps.h"

#include <algorithm>
#include <cmath>

#include "ui/app/playback/frames.h"

namespace penpose::app {
namespace {

constexpr double k_same_bookmark_s = 1e-4;

}  // namespace

const document::Bookmark* bookmark_at(const document::Document& document, double time_s) {
  if (!document.bookmarks) return nullptr;
  const auto found = std::find_if(document.bookmarks->begin(), document.bookmarks->end(),
                                  [&](const auto& one) { return std::abs(one.time_s - time_s) < k_same_bookmark_s; });
  return found == document.bookmarks->end() ? nullptr : &*found;
}

void edit_bookmark(const document::Bookmark& bookmark, Dialogs& dialogs) {
  dialogs.state<BookmarkEntry>() = {bookmark.time_s, bookmark.name, bookmark.color};
  dialogs.show(Dialog{"bookmark"});
}

void set_bookmark(EditingSession& editing, const Playback& playback, Dialogs& dialogs, Notices& notices) {
  const double time_s = playback.time_s();
  if (const auto* here = bookmark_at(editing.document(), time_s)) return edit_bookmark(*here, dialogs);
  // As the one before it was coloured.
  document::SetBookmark command{time_s, {}, 0};
  if (editing.document().bookmarks) {
    for (const document::Bookmark& one : *editing.document().bookmarks) {
      if (one.time_s < time_s) command.color = one.color;
    }
  }
  if (editing.perform(command))
    notices.tell("a bookmark is at frame " + frame_text(time_s, playback.rate()) +
                 ": the same key again gives it a name and a colour");
}

void step_bookmark(const EditingSession& editing, Playback& playback, Notices& notices, int direction) {
  const auto held = editing.document().bookmarks;
  const double now_s = playback.time_s();
  const document::Bookmark* to = nullptr;
  if (held) {
    for (const document::Bookmark& one : *held) {
      if (direction < 0 && one.time_s < now_s - k_same_bookmark_s) to = &one;
      if (direction > 0 && one.time_s > now_s + k_same_bookmark_s && to == nullptr) to = &one;
    }
  }
  if (to != nullptr) return playback.go_to(to->time_s);
  notices.tell(direction < 0 ? "there is no bookmark before this frame" : "there is no bookmark after this frame");
}

}  // namespace penpose::app
