#include "ui/app/view/present/cpu_presenter.h"

#include <utility>

#include "ui/app/view/present/moving_detail.h"
#include "ui/app/view/present/output/changed_parts.h"
#include "ui/app/view/present/panel_layer.h"
#include "ui/render/cpu/cpu_renderer.h"
#include "ui/render/cpu/curve_ink.h"
#include "ui/render/cpu/ghost_veil.h"
#include "ui/render/picture/doubled.h"

namespace penpose::app {
namespace {

class CpuPresenter final : public Presenter {
 public:
  CpuPresenter(PictureOutput& output, Rotation rotation, bool slow, PresentClock clock)
      : output_(output), rotation_(rotation), slow_(slow), clock_(std::move(clock)) {}

  base::Status begin() override {
    renderer_ = std::make_unique<render::CpuRenderer>();
    // Darkening of creases would cost the pen its frames; edges are smoothed when nothing moves.
    renderer_->set_occlusion(false);
    renderer_->set_smoothing(!slow_);
    return base::Done{};
  }

  void end() override { renderer_.reset(); }

  base::Status draw(const DrawFrame& frame, ImDrawData& panels) override {
    const bool moved = view_ && !(view_->camera == frame.view.camera && view_->viewport == frame.view.viewport);
    view_ = frame.view;
    // A slow screen shows the end of a movement alone.
    const bool coarse = !slow_ && detail_.begin(moved, clock_());
    if (auto drawn = coarse ? draw_coarse(frame) : draw_whole(frame); !drawn) return drawn;
    detail_.end(clock_());
    panels_.lay(panels, picture_);
    return base::Done{};
  }

  void show() override {
    std::vector<render::PxRect> parts{{0, 0, picture_.width, picture_.height}};
    if (slow_) {
      parts = changed_parts(shown_, picture_);
      shown_ = picture_;
    }
    if (rotation_ == Rotation::none) {
      output_.show(picture_, parts);
    } else {
      turn(picture_, parts, rotation_, turned_);
      for (render::PxRect& part : parts) part = on_panel(part, {picture_.width, picture_.height}, rotation_);
      output_.show(turned_, parts);
    }
    const auto panel = output_.size();
    if (panel) drawable_ = turned_size(*panel, rotation_);
  }

  void send_letters() override { panels_.forget(); }  // they are read where ImGui has them

  [[nodiscard]] bool refining() const override { return !slow_ && (detail_.coarse() || renderer_->refining()); }
  [[nodiscard]] std::vector<std::string> take_undrawn() override { return renderer_->take_undrawn(); }
  [[nodiscard]] std::optional<geometry::Viewport> drawable() const override { return drawable_; }

 private:
  base::Status draw_whole(const DrawFrame& frame) {
    renderer_->set_behind(frame.behind);
    renderer_->set_veil(frame.veil);
    const auto camera = geometry::Camera::make(frame.view.camera, frame.view.viewport);
    if (!camera) return camera.error();
    return renderer_->draw(scene_of(frame), *camera, picture_);
  }

  /// Half as wide and high and doubled; lines stay as thin as they are.
  base::Status draw_coarse(const DrawFrame& frame) {
    const auto [width, height] = frame.view.viewport;
    render::Behind behind = frame.behind;
    behind.from = behind.from * 0.5;
    behind.to = behind.to * 0.5;
    renderer_->set_behind(behind);
    renderer_->set_veil(nullptr);
    const auto camera = geometry::Camera::make(frame.view.camera, frame.view.viewport);
    const auto small = geometry::Camera::make(frame.view.camera, {(width + 1) / 2, (height + 1) / 2});
    if (!camera) return camera.error();
    if (!small) return small.error();
    render::Scene scene = scene_of(frame);
    scene.curves = {};
    if (auto drawn = renderer_->draw(scene, *small, coarse_); !drawn) return drawn;
    picture_.width = width;
    picture_.height = height;
    picture_.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    render::draw_doubled(coarse_, picture_);
    if (frame.veil) render::lay_veil(*frame.veil, picture_);
    render::draw_curves(frame.curves, *camera, picture_);
    return base::Done{};
  }

  PictureOutput& output_;
  Rotation rotation_;
  bool slow_;
  std::unique_ptr<render::CpuRenderer> renderer_;
  PresentClock clock_;
  MovingDetail detail_;
  std::optional<document::View> view_;  ///< of the last picture
  PanelLayer panels_;
  render::Image coarse_;
  render::Image picture_;
  render::Image shown_;   ///< on a slow screen, what it shows
  render::Image turned_;  ///< on a panel that is mounted turned
  std::optional<geometry::Viewport> drawable_;
};

}  // namespace

std::unique_ptr<Presenter> make_cpu_presenter(PictureOutput& output, Rotation rotation, bool slow, PresentClock clock) {
  return std::make_unique<CpuPresenter>(output, rotation, slow, std::move(clock));
}

}  // namespace penpose::app
