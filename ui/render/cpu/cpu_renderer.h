#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ui/render/renderer.h"

namespace penpose::render {

/// Draws scenes on the processor, with up to four threads. The same bits on every machine.
class CpuRenderer final : public Renderer {
 public:
  /// Textures have no more px together than that: memory of boards is short, and so are their screens.
  static constexpr std::uint64_t k_most_texture_px = 4'800'000;
  explicit CpuRenderer(std::uint64_t most_texture_px = k_most_texture_px);
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
