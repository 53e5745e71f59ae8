#pragma once

#include <cstdint>
#include <deque>
#include <future>
#include <imgui.h>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/byte_reader.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/widgets/internal/picture_sheet.h"
#include "ui/app/widgets/pose_painter.h"

// Small pictures of poses. Private to the module: ImGui's types show.

namespace penpose::app {

/// Pictures of poses beside the letters in ImGui's one texture, as the canvas shows them. They are drawn one after the
/// other on another thread, so that no frame is late. Ask for those that are seen alone: where there are more than
/// there is room for, some stay without a picture.
class PosePictures {
 public:
  static constexpr int k_px = 128;
  static constexpr int k_across = 6;

  /// Sets room aside in the atlas; before it is built. What was drawn is drawn again.
  void reserve(ImFontAtlas& atlas);
  /// Takes the picture that has been drawn meanwhile.
  void begin_frame();
  /// Where the picture of a pose, of a part of the face or of what a frame shows, is in the texture (two corners);
  /// nothing while there is none yet.
  using Corners = std::pair<ImVec2, ImVec2>;
  [[nodiscard]] std::optional<Corners> place_of(const EditingSession& editing, const document::SharedPose& pose,
                                                FacePart part);
  [[nodiscard]] std::optional<Corners> place_of(const EditingSession& editing, const document::SharedPose& pose,
                                                const PictureFrame& frame);
  /// The same of a picture file; `name` stands for its content.
  [[nodiscard]] std::optional<Corners> place_of(const std::string& name, base::Bytes png);
  /// What a picture of a part of the document's face shows.
  [[nodiscard]] const PictureFrame& frame_of(const EditingSession& editing, FacePart part);
  [[nodiscard]] bool reserved() const { return sheet_.reserved(); }
  /// Something was drawn into the texture since it was last asked.
  [[nodiscard]] bool take_changed() { return std::exchange(changed_, false); }
  /// One is being drawn.
  [[nodiscard]] bool waits() const { return drawn_.valid(); }
  /// There is more to show in the next frame.
  [[nodiscard]] bool take_more() { return std::exchange(more_, false); }

 private:
  struct Picture {
    std::shared_ptr<const document::Model> model;
    document::SharedPose pose;
    PictureFrame frame;
    std::string name;  ///< of a file; empty: of a pose
    friend bool operator==(const Picture&, const Picture&) = default;
  };
  using Pixels = std::vector<std::uint8_t>;
  [[nodiscard]] std::optional<Corners> find(const Picture& wanted);
  /// A place that is free, or whose picture nobody asks for any more, the one that was asked for longest ago.
  [[nodiscard]] std::optional<std::size_t> free_place() const;
  void draw(Picture made, const Pixels& pixels);

  PictureSheet sheet_{k_px, k_across};
  std::shared_ptr<const document::Model> framed_;  ///< whose `frames_` they are
  std::size_t framed_features_ = 0;                ///< and how many features it had
  PictureFrames frames_;
  std::deque<Picture> pictures_;     ///< by place; as many as there is room for
  std::deque<std::uint64_t> asked_;  ///< in which frame each was last asked for
  std::uint64_t frame_ = 2;
  bool changed_ = false;
  bool more_ = false;
  PosePainter painter_;  ///< of the other thread while `drawn_` waits
  Picture making_;
  std::future<Pixels> drawn_;  ///< ends before the painter
};

}  // namespace penpose::app
