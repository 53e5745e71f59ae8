#pragma once

#include <cstdint>
#include <deque>
#include <imgui.h>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/document/document.h"
#include "ui/app/widgets/internal/picture_sheet.h"
#include "ui/app/widgets/surface_picture.h"

// Small pictures of poses. Private to the module: ImGui's types show.

namespace penpose::app {

/// Pictures of keyed poses beside the letters in ImGui's one texture. One is drawn a frame, so that no frame is late.
class PosePictures {
 public:
  static constexpr int k_px = 96;
  static constexpr int k_across = 5;

  /// Sets room aside in the atlas; before it is built. What was drawn is drawn again.
  void reserve(ImFontAtlas& atlas);
  void begin_frame() { drew_ = false; }
  /// Where the picture of a key's pose, or of a part of it, is in the texture (two corners); nothing while there is
  /// none yet.
  using Corners = std::pair<ImVec2, ImVec2>;
  [[nodiscard]] std::optional<Corners> place_of(const document::Document& document, const document::PoseKey& key,
                                                FacePart part);
  /// The same of a picture file; `name` stands for its content.
  [[nodiscard]] std::optional<Corners> place_of(const std::string& name, base::Bytes png);
  [[nodiscard]] bool reserved() const { return sheet_.reserved(); }
  /// Something was drawn into the texture since it was last asked.
  [[nodiscard]] bool take_changed() { return std::exchange(changed_, false); }
  /// There is more to draw in the next frame.
  [[nodiscard]] bool waits() const { return drew_; }

 private:
  struct Picture {
    std::shared_ptr<const document::Model> model;
    document::SharedPose pose;
    FacePart part = FacePart::all;
    std::string name;  ///< of a file; empty: of a pose
    friend bool operator==(const Picture&, const Picture&) = default;
  };
  template <typename Draw>
  [[nodiscard]] std::optional<Corners> place(Picture wanted, const Draw& draw);

  PictureSheet sheet_{k_px, k_across};
  std::shared_ptr<const document::Model> framed_;  ///< whose `frames_` they are
  PictureFrames frames_;
  std::deque<Picture> pictures_;  ///< by place; as many as there is room for
  std::size_t next_ = 0;          ///< the place that is taken next where all are
  bool drew_ = false;
  bool changed_ = false;
};

}  // namespace penpose::app
