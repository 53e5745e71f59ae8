#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ui/render/renderer.h"

namespace penpose::render {

/// Draws scenes on the processor, with up to four threads. The same bits on every machine.
class CpuRenderer final : public Renderer {
 public:
  CpuRenderer();
  ~CpuRenderer() override;

  base::Result<Image> render(const Scene& scene, const geometry::Camera& camera) override;
  /// The same into a picture that is kept, so that nothing is allocated. While it is being smoothed a picture begins
  /// with sharp edges. Errors: as render.
  base::Status draw(const Scene& scene, const geometry::Camera& camera, Image& picture);

  void set_behind(Behind behind) override;
  void set_veil(std::shared_ptr<const Image> veil) override;
  void set_occlusion(bool on) override;
  void set_smoothing(bool on) override;
  [[nodiscard]] bool refining() const override;
  [[nodiscard]] std::vector<std::string> take_undrawn() override;
  [[nodiscard]] std::string driver() const override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace penpose::render
