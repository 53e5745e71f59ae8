#include "ui/app/widgets/internal/pose_picture.h"

#include <algorithm>

#include "core/picture/decode_picture.h"

namespace penpose::app {

void PosePictures::reserve(ImFontAtlas& atlas) {
  sheet_.reserve(atlas);
  pictures_.clear();
  next_ = 0;
}

std::optional<PosePictures::Corners> PosePictures::place_of(const document::Document& document,
                                                            const document::PoseKey& key, FacePart part) {
  if (key.pose.size() != document.model->rig->parameters().size()) return std::nullopt;
  return place(Picture{document.model, key.pose, part, {}}, [&] {
    if (framed_ != document.model) {
      framed_ = document.model;
      frames_ = picture_frames(*framed_);
    }
    return pose_pixels(*document.model, key.pose, frames_[static_cast<std::size_t>(part)], k_px);
  });
}

std::optional<PosePictures::Corners> PosePictures::place_of(const std::string& name, base::Bytes png) {
  return place(Picture{{}, {}, {}, name}, [&] {
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(4 * k_px * k_px), 0);
    const auto image = picture::decode_picture(png, k_px);
    if (!image || image->width < 1 || image->height < 1) return pixels;
    // Pictures of others may have another size: the nearest px of each.
    for (int y = 0; y < k_px; ++y) {
      for (int x = 0; x < k_px; ++x) {
        const std::uint8_t* from = image->at(x * image->width / k_px, y * image->height / k_px);
        std::copy(from, from + 4, pixels.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * k_px + x));
      }
    }
    return pixels;
  });
}

template <typename Draw>
std::optional<PosePictures::Corners> PosePictures::place(Picture wanted, const Draw& draw) {
  if (!sheet_.ready()) return std::nullopt;
  const auto found = std::find(pictures_.begin(), pictures_.end(), wanted);
  auto place = static_cast<std::size_t>(found - pictures_.begin());
  if (found == pictures_.end()) {
    if (drew_) return std::nullopt;
    drew_ = changed_ = true;
    if (pictures_.size() < sheet_.count()) {
      pictures_.emplace_back();
    } else {
      place = next_++ % pictures_.size();
    }
    pictures_[place] = std::move(wanted);
    sheet_.draw(place, draw());
  }
  return sheet_.corners(place);
}

}  // namespace penpose::app
