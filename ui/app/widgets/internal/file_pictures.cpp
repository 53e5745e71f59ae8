#include "ui/app/widgets/internal/file_pictures.h"

#include <algorithm>

namespace penpose::app {

void FilePictures::reserve(ImFontAtlas& atlas) {
  sheet_.reserve(atlas);
  drawn_.clear();
  next_ = 0;
}

std::optional<std::pair<ImVec2, ImVec2>> FilePictures::place_of(const std::string& path, std::int64_t stamp) {
  wanted_ = true;
  const Thumbnails::Pixels* pixels = thumbnails_.of(path, stamp);
  if (pixels == nullptr || pixels->empty() || !sheet_.ready()) return std::nullopt;
  const std::pair key{path, stamp};
  const auto found = std::find(drawn_.begin(), drawn_.end(), key);
  auto place = static_cast<std::size_t>(found - drawn_.begin());
  if (found == drawn_.end()) {
    if (drawn_.size() < sheet_.count()) {
      drawn_.emplace_back();
    } else {
      place = next_++ % drawn_.size();
    }
    drawn_[place] = key;
    sheet_.draw(place, *pixels);
    changed_ = true;
  }
  return sheet_.corners(place);
}

}  // namespace penpose::app
