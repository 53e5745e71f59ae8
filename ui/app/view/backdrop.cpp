#include "ui/app/view/backdrop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <utility>

#include "core/document/time/timeline.h"
#include "core/geometry/camera.h"
#include "core/picture/jpeg.h"
#include "ui/files/files.h"
#include "ui/files/folder_files.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

constexpr int k_most_backdrop_px = 2048;
constexpr double k_smallest = 0.02;  ///< of the height of the model, as it was when the picture was put there
constexpr double k_largest = 50;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// What stands before the last number of a file's name and what behind it.
struct Numbered {
  std::string before;
  std::string after;
};

std::optional<Numbered> numbered(const std::string& name) {
  std::size_t end = name.size();
  while (end > 0 && !is_digit(name[end - 1])) --end;
  if (end == 0) return std::nullopt;
  std::size_t begin = end;
  while (begin > 0 && is_digit(name[begin - 1])) --begin;
  return Numbered{name.substr(0, begin), name.substr(end)};
}

bool of_same_film(const Numbered& film, const std::string& name) {
  if (name.size() <= film.before.size() + film.after.size()) return false;
  if (!name.starts_with(film.before) || !name.ends_with(film.after)) return false;
  const auto first = name.begin() + static_cast<std::ptrdiff_t>(film.before.size());
  return std::all_of(first, name.end() - static_cast<std::ptrdiff_t>(film.after.size()), is_digit);
}

}  // namespace

std::vector<std::string> frames_beside(const std::string& path) {
  const fs::path file(path);
  // The digit of ".mp3" or ".jp2" is no number of a frame.
  const auto film = numbered(file.stem().string());
  if (!film) return {path};
  const std::string ending = file.extension().string();
  const auto all = files::folder_files(
      file.has_parent_path() ? file.parent_path().string() : ".",
      [&](const fs::path& one) { return one.extension() == ending && of_same_film(*film, one.stem().string()); });
  if (!all || !*all || (*all)->size() < 2) return {path};
  return **all;
}

base::Result<render::Image> read_picture(const std::string& path) {
  const auto bytes = files::read_plain_file(path, files::k_most_picture_bytes);
  if (!bytes) return bytes.error();
  // By what it is, and not by what it is called.
  const bool png = bytes->size() > 1 && (*bytes)[0] == 0x89 && (*bytes)[1] == 'P';
  auto image = png ? render::decode_png(*bytes) : picture::decode_jpeg(*bytes, k_most_backdrop_px);
  if (!image) return image.error();
  return picture::shrunk(*image, k_most_backdrop_px);
}

base::Result<std::shared_ptr<Backdrop>> Backdrop::open(const std::vector<std::string>& frames, const std::string& path,
                                                       const document::ReferencePicture& placed) {
  auto backdrop = std::make_shared<Backdrop>();
  backdrop->frames_ = frames.empty() ? std::vector<std::string>{path} : frames;
  const auto at = std::find_if(backdrop->frames_.begin(), backdrop->frames_.end(), [&](const std::string& one) {
    return fs::path(one).filename() == fs::path(path).filename();
  });
  backdrop->shown_ = backdrop->asked_ =
      at == backdrop->frames_.end() ? 0 : static_cast<std::size_t>(at - backdrop->frames_.begin());
  auto image = read_picture(backdrop->frames_[backdrop->shown_]);
  if (!image) return image.error();
  backdrop->image_ = std::make_shared<const render::Image>(std::move(*image));
  backdrop->placed_ = placed;
  backdrop->first_height_ = placed.height;
  return backdrop;
}

base::Status Backdrop::show(double time_s, int rate) {
  base::Status status = base::Done{};
  if (next_.valid() && next_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    auto read = next_.get();
    if (read) {
      image_ = std::make_shared<const render::Image>(std::move(*read));
      shown_ = asked_;
    } else {
      status = read.error();
    }
  }
  const auto frame = static_cast<std::size_t>(std::max(0.0, std::floor((time_s - placed_.offset_s) * rate + 1e-6)));
  const std::size_t wanted = std::min(frame, frames_.size() - 1);
  if (next_.valid() || wanted == asked_) return status;
  asked_ = wanted;
  next_ = std::async(std::launch::async, [path = frames_[wanted]] { return read_picture(path); });
  return status;
}

void Backdrop::delay(double by_s) {
  placed_.offset_s = std::clamp(placed_.offset_s + by_s, -document::k_latest_key_s, document::k_latest_key_s);
}

void Backdrop::drag(const document::View& view, const Area& free, geometry::PxPoint by) {
  if (placed_.beside) {
    constexpr double k_farthest = 0.95;
    placed_.card.x = std::clamp(placed_.card.x + by.x / free.width(), -k_farthest, k_farthest);
    placed_.card.y = std::clamp(placed_.card.y + by.y / free.height(), -k_farthest, k_farthest);
    return;
  }
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!camera) return;
  const double unit = camera->units_per_px(camera->depth(placed_.middle));
  if (unit > 0) placed_.middle += camera->right() * (by.x * unit) - camera->up() * (by.y * unit);
}

void Backdrop::enlarge(const document::View& view, const Area& free, double factor, geometry::PxPoint about) {
  if (!(factor > 0)) return;
  if (placed_.beside) {
    const double before = placed_.card_height;
    placed_.card_height = std::clamp(before * factor, document::k_smallest_card, document::k_largest_card);
    const PxPoint corner{free.left + placed_.card.x * free.width(), free.top + placed_.card.y * free.height()};
    return drag(view, free, (corner - about) * (placed_.card_height / before - 1));
  }
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  const auto middle = camera ? camera->project(placed_.middle) : std::nullopt;
  if (!middle) return;
  const double before = placed_.height;
  placed_.height = std::clamp(placed_.height * factor, k_smallest * first_height_, k_largest * first_height_);
  drag(view, free, (*middle - about) * (placed_.height / before - 1));
}

render::Behind Backdrop::seen(const document::View& view, const Area& free) const {
  if (!image_) return {};
  const auto opacity = static_cast<float>(placed_.opacity);
  const double shape = static_cast<double>(image_->width) / image_->height;
  if (placed_.beside) {
    const double high = placed_.card_height * free.height();
    const PxPoint corner{free.left + placed_.card.x * free.width(), free.top + placed_.card.y * free.height()};
    return {image_, corner, corner + PxPoint{high * shape, high}, opacity, true};
  }
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  const auto middle = camera ? camera->project(placed_.middle) : std::nullopt;
  if (!middle) return {};
  const double high = placed_.height / camera->units_per_px(camera->depth(placed_.middle));
  const double wide = high * shape;
  return {image_,
          {middle->x - 0.5 * wide, middle->y - 0.5 * high},
          {middle->x + 0.5 * wide, middle->y + 0.5 * high},
          opacity};
}

}  // namespace penpose::app
