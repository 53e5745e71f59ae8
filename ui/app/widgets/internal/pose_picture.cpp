#include "ui/app/widgets/internal/pose_picture.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <system_error>

#include "core/picture/decode_picture.h"

namespace penpose::app {
namespace {

constexpr std::size_t k_pose_picture_bytes = 4 * std::size_t{PosePictures::k_px} * PosePictures::k_px;

/// A picture file's px, the nearest of each: pictures of others may have another size.
std::vector<std::uint8_t> pixels_of_file(base::Bytes png) {
  constexpr int k_side = PosePictures::k_px;
  std::vector<std::uint8_t> pixels(k_pose_picture_bytes, 0);
  const auto image = picture::decode_picture(png, k_side);
  if (!image || image->width < 1 || image->height < 1) return pixels;
  for (int y = 0; y < k_side; ++y) {
    for (int x = 0; x < k_side; ++x) {
      const std::uint8_t* from = image->at(x * image->width / k_side, y * image->height / k_side);
      std::copy(from, from + 4, pixels.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * k_side + x));
    }
  }
  return pixels;
}

}  // namespace

void PosePictures::reserve(ImFontAtlas& atlas) {
  sheet_.reserve(atlas);
  pictures_.clear();
  asked_.clear();
}

void PosePictures::begin_frame() {
  ++frame_;
  if (!drawn_.valid() || drawn_.wait_for(std::chrono::seconds(0)) == std::future_status::timeout) return;
  Pixels pixels;
  try {
    pixels = drawn_.get();
  } catch (const std::exception&) {
    // What needs more memory than there is has no picture.
    pixels.assign(k_pose_picture_bytes, 0);
  }
  draw(std::move(making_), pixels);
  making_ = {};
}

const PictureFrame& PosePictures::frame_of(const EditingSession& editing, FacePart part) {
  const auto& model = editing.document().model;
  const auto features = editing.features();
  if (framed_ != model || framed_features_ != features.size()) {
    framed_ = model;
    framed_features_ = features.size();
    frames_ = picture_frames(*framed_, features);
  }
  return frames_[static_cast<std::size_t>(part)];
}

std::optional<PosePictures::Corners> PosePictures::place_of(const EditingSession& editing,
                                                            const document::SharedPose& pose, FacePart part) {
  return place_of(editing, pose, frame_of(editing, part));
}

std::optional<PosePictures::Corners> PosePictures::place_of(const EditingSession& editing,
                                                            const document::SharedPose& pose,
                                                            const PictureFrame& frame) {
  const auto& model = editing.document().model;
  if (!sheet_.ready() || pose.size() != model->rig->parameters().size()) return std::nullopt;
  const Picture wanted{model, pose, frame, {}};
  if (const auto found = find(wanted)) return found;
  if (drawn_.valid() || !free_place()) return std::nullopt;
  making_ = wanted;
  const auto paint = [this, wanted] { return painter_.paint(*wanted.model, wanted.pose, wanted.frame, k_px); };
  try {
    drawn_ = std::async(std::launch::async, paint);
  } catch (const std::system_error&) {
    drawn_ = std::async(std::launch::deferred, paint);  // no more threads: this one does it
  }
  return std::nullopt;
}

std::optional<PosePictures::Corners> PosePictures::place_of(const std::string& name, base::Bytes png) {
  if (!sheet_.ready()) return std::nullopt;
  Picture wanted{{}, {}, {}, name};
  if (const auto found = find(wanted)) return found;
  if (!free_place()) return std::nullopt;
  // One a frame.
  if (changed_) {
    more_ = true;
    return std::nullopt;
  }
  draw(wanted, pixels_of_file(png));
  return find(wanted);
}

std::optional<PosePictures::Corners> PosePictures::find(const Picture& wanted) {
  const auto found = std::find(pictures_.begin(), pictures_.end(), wanted);
  if (found == pictures_.end()) return std::nullopt;
  const auto place = static_cast<std::size_t>(found - pictures_.begin());
  asked_[place] = frame_;
  return sheet_.corners(place);
}

std::optional<std::size_t> PosePictures::free_place() const {
  if (pictures_.size() < sheet_.count()) return pictures_.size();
  const auto oldest = std::min_element(asked_.begin(), asked_.end());
  if (*oldest + 1 >= frame_) return std::nullopt;
  return static_cast<std::size_t>(oldest - asked_.begin());
}

void PosePictures::draw(Picture made, const Pixels& pixels) {
  const auto place = sheet_.ready() ? free_place() : std::nullopt;
  if (!place) return;
  if (*place == pictures_.size()) {
    pictures_.emplace_back();
    asked_.emplace_back();
  }
  pictures_[*place] = std::move(made);
  asked_[*place] = frame_;
  sheet_.draw(*place, pixels);
  changed_ = true;
}

}  // namespace penpose::app
