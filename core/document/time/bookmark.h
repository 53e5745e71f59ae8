#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace penpose::document {

/// A moment of the timeline with a name, for people to find again.
struct Bookmark {
  double time_s = 0;
  std::string name;         ///< may be empty
  std::uint32_t color = 0;  ///< below k_bookmark_colors
  friend bool operator==(const Bookmark&, const Bookmark&) = default;
};
/// Ascending in time, no two at the same moment.
using Bookmarks = std::vector<Bookmark>;

inline constexpr std::size_t k_most_bookmarks = 1000;
inline constexpr std::size_t k_longest_bookmark = 200;  ///< bytes of a name
inline constexpr std::uint32_t k_bookmark_colors = 6;

/// Shares a list; null where there is none.
[[nodiscard]] inline std::shared_ptr<const Bookmarks> shared_bookmarks(Bookmarks bookmarks) {
  return bookmarks.empty() ? nullptr : std::make_shared<const Bookmarks>(std::move(bookmarks));
}

}  // namespace penpose::document
