#include "core/document/commands/list/time/bookmark_commands.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/document/commands/apply_parts.h"

namespace penpose::document {
namespace {

Bookmarks bookmarks_of(const Document& document) { return document.bookmarks ? *document.bookmarks : Bookmarks(); }

/// Takes away the one at a moment; nothing: there is none.
std::optional<Bookmark> taken_bookmark(Bookmarks& bookmarks, double time_s) {
  const auto found =
      std::find_if(bookmarks.begin(), bookmarks.end(), [&](const Bookmark& one) { return one.time_s == time_s; });
  if (found == bookmarks.end()) return std::nullopt;
  Bookmark taken = std::move(*found);
  bookmarks.erase(found);
  return taken;
}

void add_bookmark(Bookmarks& bookmarks, Bookmark added) {
  const auto later =
      std::find_if(bookmarks.begin(), bookmarks.end(), [&](const Bookmark& one) { return one.time_s > added.time_s; });
  bookmarks.insert(later, std::move(added));
}

std::optional<base::Error> check_moment(double time_s, const char* place) {
  if (time_s >= 0 && time_s <= k_latest_key_s) return std::nullopt;
  return base::Error{"a bookmark stands off the timeline", place, "give seconds from 0 to 36000"};
}

base::Error no_bookmark() { return {"there is no bookmark at that moment", "time_s", "go to a bookmark first"}; }

Document with_bookmarks(const Document& document, Bookmarks bookmarks) {
  Document changed = document;
  changed.bookmarks = shared_bookmarks(std::move(bookmarks));
  return changed;
}

}  // namespace

Changed run(const Document& document, const SetBookmark& command, Parts&) {
  if (auto error = check_moment(command.time_s, "time_s")) return *error;
  if (command.name.size() > k_longest_bookmark)
    return base::Error{"the name of the bookmark is too long", "name", "give at most 200 bytes"};
  if (command.color >= k_bookmark_colors)
    return base::Error{"there is no such colour of bookmarks", "color", "give a number from 0 to 5"};
  Bookmarks bookmarks = bookmarks_of(document);
  taken_bookmark(bookmarks, command.time_s);
  if (bookmarks.size() >= k_most_bookmarks)
    return base::Error{"there are 1000 bookmarks already", "time_s", "delete one"};
  add_bookmark(bookmarks, {command.time_s, command.name, command.color});
  return with_bookmarks(document, std::move(bookmarks));
}

Changed run(const Document& document, const MoveBookmark& command, Parts&) {
  if (auto error = check_moment(command.to_s, "to_s")) return *error;
  Bookmarks bookmarks = bookmarks_of(document);
  auto moved = taken_bookmark(bookmarks, command.time_s);
  if (!moved) return no_bookmark();
  taken_bookmark(bookmarks, command.to_s);
  moved->time_s = command.to_s;
  add_bookmark(bookmarks, *std::move(moved));
  return with_bookmarks(document, std::move(bookmarks));
}

Changed run(const Document& document, const DeleteBookmark& command, Parts&) {
  Bookmarks bookmarks = bookmarks_of(document);
  if (!taken_bookmark(bookmarks, command.time_s)) return no_bookmark();
  return with_bookmarks(document, std::move(bookmarks));
}

}  // namespace penpose::document
