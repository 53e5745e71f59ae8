#pragma once

#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/drawing/pose_curve.h"
#include "core/document/view/reference_picture.h"
#include "ui/app/view/area.h"
#include "ui/render/behind.h"

namespace penpose::app {

/// Files of one film's frames by their numbers, of which `path` is one; `path` alone where it has no number or is the
/// only one. In the order of the numbers.
[[nodiscard]] std::vector<std::string> frames_beside(const std::string& path);

/// The picture of a PNG or a JPEG file, no side longer than 2048 px. Errors: those of the file and of the format.
[[nodiscard]] base::Result<render::Image> read_picture(const std::string& path);

/// A picture, or the frames of a film, that one animates after. Behind the model it stands where it was put beside the
/// model and faces whoever looks: it goes along when the view is moved or zoomed. A card stays on the window.
class Backdrop {
 public:
  /// Shows the file at `path` of `frames`. Errors: those of read_picture for it.
  static base::Result<std::shared_ptr<Backdrop>> open(const std::vector<std::string>& frames, const std::string& path,
                                                      const document::ReferencePicture& placed);

  /// Shows the frame of a moment as soon as it is read, which is done beside. An error is told once.
  [[nodiscard]] base::Status show(double time_s, int rate);
  /// A frame is being read.
  [[nodiscard]] bool loading() const { return next_.valid(); }

  /// Where it stands and how much of it shows, as the document has it or as it is changed in hand.
  [[nodiscard]] const document::ReferencePicture& placed() const { return placed_; }
  void place(const document::ReferencePicture& placed) { placed_ = placed; }
  void set_opacity(double opacity) { placed_.opacity = opacity; }
  void set_beside(bool beside) { placed_.beside = beside; }
  /// Begins later by some seconds.
  void delay(double by_s);

  /// Moved by px of a view, of whose window `free` is the part that no panel covers.
  void drag(const document::View& view, const Area& free, geometry::PxPoint by);
  /// Made larger by a factor, about a place of the view that stays.
  void enlarge(const document::View& view, const Area& free, double factor, geometry::PxPoint about);
  [[nodiscard]] render::Behind seen(const document::View& view, const Area& free) const;

  [[nodiscard]] std::size_t frame_count() const { return frames_.size(); }
  [[nodiscard]] std::size_t frame() const { return shown_; }
  [[nodiscard]] const std::string& path() const { return frames_[shown_]; }

  bool adjusting = true;     ///< drags on the canvas move it
  geometry::PxPoint held{};  ///< where it was last dragged to

 private:
  using Read = base::Result<render::Image>;
  std::vector<std::string> frames_;
  std::size_t shown_ = 0;
  std::size_t asked_ = 0;  ///< the last that was asked for, whether it could be read or not
  std::shared_ptr<const render::Image> image_;
  std::future<Read> next_;
  document::ReferencePicture placed_;
  double first_height_ = 1;  ///< as it was put there
};

}  // namespace penpose::app
