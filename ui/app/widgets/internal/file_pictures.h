#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ui/app/browser/thumbnails.h"
#include "ui/app/widgets/internal/picture_sheet.h"

namespace penpose::app {

/// Small pictures of files beside the letters in ImGui's texture. Private to the module: ImGui's types show.
class FilePictures {
 public:
  /// Sets room aside; before the atlas is built.
  void reserve(ImFontAtlas& atlas);
  /// Somebody asked for one, and there is no room yet.
  [[nodiscard]] bool wants_room() const { return wanted_ && !sheet_.reserved(); }
  [[nodiscard]] bool reserved() const { return sheet_.reserved(); }
  /// Where the picture of a file is in the texture (two corners); nothing while there is none. `stamp`: when the file
  /// was changed.
  [[nodiscard]] std::optional<std::pair<ImVec2, ImVec2>> place_of(const std::string& path, std::int64_t stamp);
  /// Something was drawn into the texture since it was last asked.
  [[nodiscard]] bool take_changed() { return std::exchange(changed_, false); }
  /// Some are still being made.
  [[nodiscard]] bool waits() const { return wanted_ && thumbnails_.waits(); }

 private:
  Thumbnails thumbnails_;
  PictureSheet sheet_{Thumbnails::k_px, 6};
  std::vector<std::pair<std::string, std::int64_t>> drawn_;  ///< by place
  std::size_t next_ = 0;                                     ///< the place that is taken next where all are
  bool wanted_ = false;
  bool changed_ = false;
};

}  // namespace penpose::app
