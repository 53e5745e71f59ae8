#pragma once

#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/drawing/pose_curve.h"
#include "ui/render/behind.h"

namespace penpose::app {

/// Files of one film's frames by their numbers, of which `path` is one; `path` alone where it has no number or is the
/// only one. In the order of the numbers.
[[nodiscard]] std::vector<std::string> frames_beside(const std::string& path);

/// The picture of a PNG or a JPEG file, no side longer than 2048 px. Errors: those of the file and of the format.
[[nodiscard]] base::Result<render::Image> read_picture(const std::string& path);

/// A picture, or the frames of a film, behind the model. It stands where it was put beside the model and faces whoever
/// looks: it goes along when the view is moved or zoomed.
class Backdrop {
 public:
  /// As high as the model, in its middle. Errors: those of read_picture for its first frame.
  static base::Result<std::shared_ptr<Backdrop>> open(const std::string& path, const geometry::ModelPoint& middle,
                                                      double height);

  /// Shows the frame of a moment as soon as it is read, which is done beside. An error is told once.
  [[nodiscard]] base::Status show(double time_s, int rate);
  /// A frame is being read.
  [[nodiscard]] bool loading() const { return next_.valid(); }

  /// Moved by px of a view.
  void drag(const document::View& view, geometry::PxPoint by);
  /// Made larger by a factor, about a place of the view that stays.
  void enlarge(const document::View& view, double factor, geometry::PxPoint about);
  [[nodiscard]] render::Behind seen(const document::View& view) const;

  [[nodiscard]] std::size_t frame_count() const { return frames_.size(); }
  [[nodiscard]] std::size_t frame() const { return shown_; }
  [[nodiscard]] const std::string& path() const { return frames_[shown_]; }

  double opacity = 0.8;      ///< 0..1
  bool adjusting = true;     ///< drags on the canvas move it
  geometry::PxPoint held{};  ///< where it was last dragged to

 private:
  using Read = base::Result<render::Image>;
  std::vector<std::string> frames_;
  std::size_t shown_ = 0;
  std::size_t asked_ = 0;  ///< the last that was asked for, whether it could be read or not
  std::shared_ptr<const render::Image> image_;
  std::future<Read> next_;
  geometry::ModelPoint middle_{0};
  double height_ = 1;        ///< model units
  double first_height_ = 1;  ///< as it was put there
};

}  // namespace penpose::app
