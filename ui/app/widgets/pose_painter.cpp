#include "ui/app/widgets/pose_painter.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/rig/surface_poser.h"
#include "ui/render/appearance.h"
#include "ui/render/cpu/cpu_renderer.h"

namespace penpose::app {
namespace {

/// Of all textures of a small picture together.
constexpr std::uint64_t k_small_texture_px = 1'500'000;
/// Samples of a px across and down.
constexpr int k_samples = 2;

/// One pixel of the picture over black and over white, sums of samples: its own colour and how much it covers.
void take_pixel(const std::array<int, 3>& black, const std::array<int, 3>& white, std::uint8_t* to) {
  constexpr int k_all = 255 * k_samples * k_samples;
  int through = 0;
  for (std::size_t c = 0; c < 3; ++c) through += white[c] - black[c];
  const int covers = std::clamp(k_all - through / 3, 0, k_all);
  for (std::size_t c = 0; c < 3; ++c)
    to[c] = static_cast<std::uint8_t>(covers > 0 ? std::clamp(255 * black[c] / covers, 0, 255) : 0);
  to[3] = static_cast<std::uint8_t>(255 * covers / k_all);
}

std::vector<std::uint8_t> without_backdrop(const render::Image& black, const render::Image& white, int px) {
  std::vector<std::uint8_t> out(static_cast<std::size_t>(4 * px * px), 0);
  std::uint8_t* to = out.data();
  for (int y = 0; y < px; ++y) {
    for (int x = 0; x < px; ++x, to += 4) {
      std::array<int, 3> dark{}, light{};
      for (int k = 0; k < k_samples * k_samples; ++k) {
        const int sx = k_samples * x + k % k_samples;
        const int sy = k_samples * y + k / k_samples;
        for (std::size_t c = 0; c < 3; ++c) {
          dark[c] += black.at(sx, sy)[c];
          light[c] += white.at(sx, sy)[c];
        }
      }
      take_pixel(dark, light, to);
    }
  }
  return out;
}

}  // namespace

struct PosePainter::State {
  render::CpuRenderer renderer{k_small_texture_px};
  std::shared_ptr<const mesh::TriangleMesh> mesh;
  std::shared_ptr<const rig::CharacterRig> rig;
  std::shared_ptr<const document::Look> look;
  render::Appearance appearance;
  std::optional<rig::SurfacePoser> poser;
  std::uint64_t shape = 0, pose = 0;

  void take(const document::Model& model) {
    if (mesh != model.mesh || look != model.look) {
      appearance = render::make_appearance(model);
      ++shape;
    }
    if (rig != model.rig) poser.emplace(model.rig);
    mesh = model.mesh;
    rig = model.rig;
    look = model.look;
  }
};

PosePainter::PosePainter() = default;
PosePainter::~PosePainter() = default;

std::vector<std::uint8_t> PosePainter::paint(const document::Model& model, const rig::Pose& pose,
                                             const PictureFrame& frame, int px) {
  const std::vector<std::uint8_t> none(static_cast<std::size_t>(4 * px * px), 0);
  const auto camera =
      geometry::Camera::make(camera_of_frame(model, frame), geometry::Viewport{k_samples * px, k_samples * px});
  if (!camera) return none;
  if (!state_) {
    state_ = std::make_unique<State>();
    // One sample a px: there are several of them to a px of the picture.
    state_->renderer.set_smoothing(true);
  }
  state_->take(model);
  static_cast<void>(state_->poser->update(pose));
  render::Scene scene;
  scene.positions = state_->poser->positions();
  scene.normals = state_->poser->normals();
  scene.triangles = model.mesh->triangles();
  scene.appearance = &state_->appearance;
  scene.shape_number = state_->shape;
  scene.pose_number = ++state_->pose;
  std::array<render::Image, 2> over;
  for (std::size_t i = 0; i < over.size(); ++i) {
    const auto shade = static_cast<float>(i);
    scene.background = {{shade, shade, shade, 1}, {shade, shade, shade, 1}, 0};
    if (!state_->renderer.draw(scene, *camera, over[i])) return none;
  }
  return without_backdrop(over[0], over[1], px);
}

std::vector<std::uint8_t> pose_pixels(const document::Model& model, const rig::Pose& pose, const PictureFrame& frame,
                                      int px) {
  return PosePainter().paint(model, pose, frame, px);
}

}  // namespace penpose::app
