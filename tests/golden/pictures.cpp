#include "tests/golden/pictures.h"

#include <memory>

#include "core/base/state_hash.h"
#include "core/character/demo_head.h"
#include "ui/render/appearance.h"
#include "ui/render/cpu/cpu_renderer.h"
#include "ui/render/framing.h"

namespace penpose::tests {
namespace {

using render::CpuRenderer;
using render::Scene;

constexpr geometry::Viewport k_size{240, 160};

/// What the scenes are made of.
struct Set {
  document::Model model = character::make_demo_head().value();
  render::PosedMesh posed = render::posed_mesh(model);
  render::Appearance appearance = render::make_appearance(model, {});

  [[nodiscard]] Scene scene() const {
    Scene made = render::scene_of(model, posed, appearance);
    made.shape_number = made.pose_number = 1;
    return made;
  }
  [[nodiscard]] geometry::Camera camera(double yaw, double pitch = 0) const {
    return render::frame_points(posed.positions, k_size, {yaw, pitch});
  }
};

std::string hash_of(const render::Image& image) { return base::hash_bytes(image.pixels).hex(); }

std::string drawn(const Scene& scene, const geometry::Camera& camera, render::Behind behind = {}) {
  CpuRenderer renderer;
  renderer.set_behind(std::move(behind));
  return hash_of(renderer.render(scene, camera).value());
}

/// As the window draws it: sharp at first, smooth at rest.
std::string smoothed(const Scene& scene, const geometry::Camera& camera) {
  CpuRenderer renderer;
  renderer.set_occlusion(false);
  renderer.set_smoothing(true);
  render::Image image;
  do {
    image = renderer.render(scene, camera).value();
  } while (renderer.refining());
  return hash_of(image);
}

render::Image stripes() {
  render::Image image{24, 16, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (const int value : {x * 10, y * 15, (x * y) % 256, x % 5 == 0 ? 90 : 255}) {
        image.pixels.push_back(static_cast<std::uint8_t>(value));
      }
    }
  }
  return image;
}

/// The head with a picture on all of it.
document::Model textured(const document::Model& model, document::AlphaMode alpha) {
  auto look = std::make_shared<document::Look>();
  look->images.push_back({"stripes", "image/png",
                          std::make_shared<const std::vector<std::uint8_t>>(render::encode_png(stripes()).value()), 24,
                          16});
  look->surfaces.resize(1);
  look->surfaces[0].alpha = alpha;
  look->surfaces[0].double_sided = true;
  look->surfaces[0].texture = document::TextureUse{};
  look->surfaces[0].texture->scale = {7, 9};
  look->surfaces[0].texture->rotation = 0.3;
  look->surface_of.assign(model.mesh->triangles().size(), 0);
  for (const auto& p : model.mesh->positions()) {
    look->coordinates[0].push_back({static_cast<float>(p.x), static_cast<float>(p.y)});
  }
  document::Model made = model;
  made.look = std::move(look);
  return made;
}

std::vector<render::CurveDrawing> curves() {
  std::vector<render::CurveDrawing> all(3);
  for (int i = 0; i <= 40; ++i) {
    all[0].points_px.push_back({40 + 3.1 * i, 60 + 0.02 * (i - 20) * (i - 20)});
    all[0].widths_px.push_back(1 + 0.2F * static_cast<float>(i));
    all[1].points_px.push_back({30.5 + 4 * i, 110 - 1.3 * i});
    all[1].point_colors.push_back({static_cast<float>(i) / 40, 0.2F, 0.5F, 0.8F});
  }
  all[1].kind = render::CurveKind::target;
  all[1].highlighted = true;
  all[2].points_px = {{120, 30}};
  all[2].width_px = 9;
  return all;
}

}  // namespace

std::map<std::string, std::string> picture_hashes() {
  const Set set;
  std::map<std::string, std::string> hashes;
  const auto keep = [&](const std::string& name, std::string hash) { hashes["picture-" + name] = std::move(hash); };
  Scene scene = set.scene();
  keep("front", drawn(scene, set.camera(0)));
  keep("three-quarter", drawn(scene, set.camera(35, 10)));
  keep("smoothed", smoothed(scene, set.camera(-35)));
  const auto lines = curves();
  scene.curves = lines;
  keep("curves", drawn(scene, set.camera(0)));
  scene = set.scene();
  scene.wireframe = true;
  keep("wireframe", smoothed(scene, set.camera(20)));
  scene = set.scene();
  scene.appearance = nullptr;
  keep("plain", drawn(scene, set.camera(0)));
  scene = set.scene();
  std::vector<render::Color> overlay;
  for (const glm::vec3& p : set.posed.positions) overlay.push_back(render::weight_color(p.y * 4 + 0.5F));
  scene.overlay = overlay;
  keep("overlay", drawn(scene, set.camera(0)));
  scene = set.scene();
  const auto image = std::make_shared<render::Image>(stripes());
  keep("behind", drawn(scene, set.camera(0), {image, {20.5, 10}, {200, 140.25}, 0.7F}));
  const geometry::CameraPose inside{{0, 0, 0.02}, {0.01, -0.02, 0.1}, {0, 1, 0}, 70};
  keep("inside", drawn(scene, geometry::Camera::make(inside, k_size).value()));
  for (const auto& [name, alpha] : {std::pair{"texture", document::AlphaMode::opaque},
                                    {"mask", document::AlphaMode::mask},
                                    {"blend", document::AlphaMode::blend}}) {
    const document::Model model = textured(set.model, alpha);
    const render::Appearance appearance = render::make_appearance(model, {});
    scene = set.scene();
    scene.appearance = &appearance;
    keep(name, drawn(scene, set.camera(15)));
  }
  return hashes;
}

}  // namespace penpose::tests
