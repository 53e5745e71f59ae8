#include "ui/app/view/present/cpu_presenter.h"

#include "ui/app/view/present/output/changed_parts.h"
#include "ui/app/view/present/panel_layer.h"
#include "ui/render/cpu/cpu_renderer.h"

namespace penpose::app {
namespace {

class CpuPresenter final : public Presenter {
 public:
  CpuPresenter(PictureOutput& output, Rotation rotation, bool slow)
      : output_(output), rotation_(rotation), slow_(slow) {}

  base::Status begin() override {
    renderer_ = std::make_unique<render::CpuRenderer>();
    // Darkening of creases would cost the pen its frames; edges are smoothed when nothing moves.
    renderer_->set_occlusion(false);
    renderer_->set_smoothing(!slow_);
    return base::Done{};
  }

  void end() override { renderer_.reset(); }

  base::Status draw(const DrawFrame& frame, ImDrawData& panels) override {
    renderer_->set_behind(frame.behind);
    const auto camera = geometry::Camera::make(frame.view.camera, frame.view.viewport);
    if (!camera) return camera.error();
    if (auto drawn = renderer_->draw(scene_of(frame), *camera, picture_); !drawn) return drawn;
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

  [[nodiscard]] bool refining() const override { return !slow_ && renderer_->refining(); }
  [[nodiscard]] std::vector<std::string> take_undrawn() override { return renderer_->take_undrawn(); }
  [[nodiscard]] std::optional<geometry::Viewport> drawable() const override { return drawable_; }

 private:
  PictureOutput& output_;
  Rotation rotation_;
  bool slow_;
  std::unique_ptr<render::CpuRenderer> renderer_;
  PanelLayer panels_;
  render::Image picture_;
  render::Image shown_;   ///< on a slow screen, what it shows
  render::Image turned_;  ///< on a panel that is mounted turned
  std::optional<geometry::Viewport> drawable_;
};

}  // namespace

std::unique_ptr<Presenter> make_cpu_presenter(PictureOutput& output, Rotation rotation, bool slow) {
  return std::make_unique<CpuPresenter>(output, rotation, slow);
}

}  // namespace penpose::app
