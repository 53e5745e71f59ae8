#include "ui/app/browser/thumbnails.h"

#include <algorithm>
#include <exception>
#include <filesystem>

#include "core/base/text/letters.h"
#include "core/io/model/model_formats.h"
#include "core/picture/jpeg.h"
#include "ui/app/view/backdrop.h"
#include "ui/app/widgets/pose_painter.h"
#include "ui/files/load_model.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

/// What is larger would take long.
constexpr std::uintmax_t k_most_bytes = std::uintmax_t{48} << 20;
constexpr auto k_side = static_cast<std::size_t>(Thumbnails::k_px);

bool is_picture(const std::string& name) {
  const std::string extension = base::lower_case(fs::path(name).extension().string());
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

Thumbnails::Pixels picture_thumbnail(const std::string& path) {
  const auto read = read_picture(path);
  if (!read) return {};
  const render::Image small = picture::shrunk(*read, Thumbnails::k_px);
  Thumbnails::Pixels pixels(4 * k_side * k_side, 0);
  const int left = (Thumbnails::k_px - small.width) / 2;
  const int top = (Thumbnails::k_px - small.height) / 2;
  for (int y = 0; y < small.height; ++y) {
    const auto row = static_cast<std::size_t>(top + y) * k_side + static_cast<std::size_t>(left);
    std::copy_n(small.at(0, y), 4 * static_cast<std::size_t>(small.width),
                pixels.begin() + static_cast<std::ptrdiff_t>(4 * row));
  }
  return pixels;
}

Thumbnails::Pixels model_thumbnail(const std::string& path) {
  const auto model = files::load_model(path, files::NamedBy::file);
  if (!model) return {};
  return pose_pixels(*model, rig::rest_pose(*model->rig), picture_frames(*model).front(), Thumbnails::k_px);
}

}  // namespace

Thumbnails::Pixels thumbnail_of(const std::string& path) {
  std::error_code code;
  const auto bytes = fs::file_size(path, code);
  if (code || bytes > k_most_bytes) return {};
  try {
    return is_picture(path) ? picture_thumbnail(path) : model_thumbnail(path);
  } catch (const std::exception&) {
    // A file that needs more memory than there is has no picture.
    return {};
  }
}

bool Thumbnails::may_have(const std::string& name) {
  const std::string extension = base::lower_case(fs::path(name).extension().string());
  const auto models = io::extensions_read();
  return is_picture(name) || std::find(models.begin(), models.end(), extension) != models.end();
}

Thumbnails::~Thumbnails() {
  {
    const std::lock_guard hold(guard_);
    ends_ = true;
  }
  asked_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Thumbnails::work() {
  std::unique_lock hold(guard_);
  while (true) {
    asked_.wait(hold, [this] { return ends_ || !wanted_.empty(); });
    if (ends_) return;
    making_ = std::move(wanted_.back());
    wanted_.pop_back();
    const Key next = *making_;
    hold.unlock();
    Pixels pixels = thumbnail_of(next.first);
    hold.lock();
    making_.reset();
    arrived_.emplace_back(next, std::move(pixels));
  }
}

bool Thumbnails::waits() const {
  const std::lock_guard hold(guard_);
  return making_ || !wanted_.empty() || !arrived_.empty();
}

const Thumbnails::Pixels* Thumbnails::of(const std::string& path, std::int64_t stamp) {
  const std::lock_guard hold(guard_);
  for (auto& [key, pixels] : arrived_) {
    if (made_.emplace(key, std::move(pixels)).second) order_.push_back(key);
  }
  arrived_.clear();
  while (order_.size() > k_kept) {
    made_.erase(order_.front());
    order_.pop_front();
  }
  const Key key{path, stamp};
  if (const auto found = made_.find(key); found != made_.end()) return &found->second;
  if (making_ != key && std::find(wanted_.begin(), wanted_.end(), key) == wanted_.end()) {
    wanted_.push_back(key);
    if (wanted_.size() > k_most_asked) wanted_.pop_front();
    if (!thread_.joinable()) thread_ = std::thread([this] { work(); });
    asked_.notify_one();
  }
  return nullptr;
}

}  // namespace penpose::app
