#include "ui/film/contact_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "ui/film/frame_number.h"

namespace penpose::film {
namespace {

constexpr int k_gap = 8;
constexpr double k_wide = 4.0 / 3;
constexpr std::int64_t k_longest_side = 16384;
constexpr std::int64_t k_most_px = 64'000'000;
constexpr std::uint8_t k_ground[4] = {16, 17, 20, 255};

/// Of the digits; beneath a picture there is twice as much room.
int digits_of(geometry::Viewport cell) { return std::clamp(cell.height / 14, 9, 28); }

}  // namespace

base::Result<ContactSheet> ContactSheet::make(std::size_t count, geometry::Viewport cell) {
  if (count == 0) return base::Error{"there are no frames for the sheet", "", "name others"};
  ContactSheet sheet;
  sheet.cell_ = cell;
  sheet.number_px_ = digits_of(cell);
  const std::int64_t across = cell.width + k_gap;
  const std::int64_t down = cell.height + 2 * sheet.number_px_ + k_gap;
  const double columns = std::ceil(
      std::sqrt(k_wide * static_cast<double>(count) * static_cast<double>(down) / static_cast<double>(across)));
  sheet.columns_ = std::clamp<std::size_t>(static_cast<std::size_t>(columns), 1, count);
  const std::size_t rows = (count + sheet.columns_ - 1) / sheet.columns_;
  const std::int64_t width = static_cast<std::int64_t>(sheet.columns_) * across + k_gap;
  const std::int64_t height = static_cast<std::int64_t>(rows) * down + k_gap;
  if (width > k_longest_side || height > k_longest_side || width * height > k_most_px) {
    return base::Error{"a sheet has no room for " + std::to_string(count) + " frames of this size", "",
                       "take fewer of them, or smaller ones"};
  }
  sheet.image_.width = static_cast<int>(width);
  sheet.image_.height = static_cast<int>(height);
  sheet.image_.pixels.resize(static_cast<std::size_t>(width * height) * 4);
  for (std::size_t i = 0; i < sheet.image_.pixels.size(); ++i) sheet.image_.pixels[i] = k_ground[i % 4];
  return sheet;
}

void ContactSheet::put(std::size_t place, const render::Image& picture, int frame) {
  const int left = k_gap + static_cast<int>(place % columns_) * (cell_.width + k_gap);
  const int top = k_gap + static_cast<int>(place / columns_) * (cell_.height + 2 * number_px_ + k_gap);
  const auto row_bytes = static_cast<std::size_t>(std::min(picture.width, cell_.width)) * 4;
  for (int y = 0; y < std::min(picture.height, cell_.height); ++y) {
    const auto to =
        static_cast<std::size_t>(top + y) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(left);
    std::memcpy(image_.pixels.data() + 4 * to, picture.at(0, y), row_bytes);
  }
  draw_number(image_, frame, {left + 0.5 * cell_.width, top + cell_.height + 1.2 * number_px_, 1.0 * number_px_},
              false);
}

}  // namespace penpose::film
