#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/document/model.h"
#include "ui/app/widgets/picture_frame.h"

namespace penpose::app {

/// Draws small pictures of a model's poses as the canvas shows them, with its colours and textures, and with nothing
/// behind it. Keeps what belongs to the model from one picture to the next. One thread at a time.
class PosePainter {
 public:
  PosePainter();
  ~PosePainter();

  /// RGBA, `px` by `px`, row by row; clear where the model is not. All clear where it cannot be drawn.
  /// Precondition: one value a parameter.
  [[nodiscard]] std::vector<std::uint8_t> paint(const document::Model& model, const rig::Pose& pose,
                                                const PictureFrame& frame, int px);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The same for one picture alone.
[[nodiscard]] std::vector<std::uint8_t> pose_pixels(const document::Model& model, const rig::Pose& pose,
                                                    const PictureFrame& frame, int px);

}  // namespace penpose::app
