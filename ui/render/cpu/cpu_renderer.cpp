#include "ui/render/cpu/cpu_renderer.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "ui/render/cpu/backdrop_rows.h"
#include "ui/render/cpu/curve_ink.h"
#include "ui/render/cpu/ghost_veil.h"
#include "ui/render/cpu/ground_rows.h"
#include "ui/render/cpu/occlusion.h"
#include "ui/render/cpu/outlines.h"
#include "ui/render/cpu/shading/tile_drawer.h"
#include "ui/render/cpu/triangles/changed_tiles.h"
#include "ui/render/cpu/workers.h"
#include "ui/render/kept_pictures.h"
#include "ui/render/smoothing.h"

namespace penpose::render {
namespace {

/// A side of a picture, px. Corners are placed in whole numbers.
constexpr int k_most_side_px = 8192;
constexpr unsigned k_most_threads = 4;

}  // namespace

struct CpuRenderer::State {
  std::uint64_t most_texture_px = k_most_texture_px;
  Workers workers{std::clamp(std::thread::hardware_concurrency(), 1U, k_most_threads)};
  SceneTracker tracker;
  DrawList list;
  std::vector<VertexFinish> finish;
  std::vector<Bytes4> overlay;
  std::vector<Bytes4> tint;
  std::vector<Bytes4> light;  ///< empty: nothing to say
  Outlines outlines;
  std::shared_ptr<const document::Look> look;
  KeptPictures<TextureMap> textures;
  Behind behind;
  std::shared_ptr<const Image> veil;
  bool occlude = true;
  bool smooths = false;

  std::vector<ScreenVertex> vertices;
  DrawItems items;
  View first_view;  ///< of the first pass of a picture that is smoothed
  std::vector<ScreenVertex> first_vertices;
  Image backdrop;  ///< what is behind the model
  Background backdrop_colors;
  Behind backdrop_behind;
  std::shared_ptr<const BakedLight> backdrop_ground;  ///< whose shade is in it; null: none
  View backdrop_view;                                 ///< by which it was drawn
  Image surfaces;                                     ///< the picture without curves
  std::vector<float> depths;                          ///< inverse, of the first pass; empty: not asked for
  std::vector<std::uint16_t> sums;                    ///< of passes, one a byte of the picture
  int passes = 0;                                     ///< that the sums have
  bool still = false;
  PictureSource last;

  base::Status take(const Scene& scene);
  [[nodiscard]] std::vector<Segment> segments() const;
  void draw_backdrop(const Scene& scene, const View& view, geometry::Viewport size);
  void draw_pass(const Scene& scene, const geometry::Camera& camera, int pass, bool pose_alone = false);
  void add_pass();
  void draw_occlusion(const Scene& scene, const geometry::Camera& camera);
  base::Status draw_surfaces(const Scene& scene, const geometry::Camera& camera);
};

base::Status CpuRenderer::State::take(const Scene& scene) {
  const auto changes = tracker.look_at(scene);
  if (!changes) return changes.error();
  if (changes->shape) {
    list = make_draw_list(scene);
    finish = vertex_finish(scene);
    const Appearance* appearance = scene.appearance;
    const bool some_light = appearance != nullptr && (appearance->light || !appearance->gaze.empty());
    light = some_light ? vertex_light(scene) : std::vector<Bytes4>();
    const bool looks = !list.batches.empty();
    look = looks ? scene.appearance->look : nullptr;
    tint = looks ? vertex_tint(*look, scene.positions.size()) : std::vector<Bytes4>();
    // Clay keeps them, because one looks at both in turn.
    if (!looks && (scene.appearance == nullptr || !scene.appearance->look)) textures.clear();
    if (looks) {
      textures.keep(*look, scene.appearance->batches, most_texture_px,
                    [](Image image) { return TextureMap(std::move(image)); });
    }
    outlines.take(list, look.get(), textures, scene.positions.size());
  }
  if (changes->overlay) {
    overlay.resize(scene.overlay.size());
    std::transform(scene.overlay.begin(), scene.overlay.end(), overlay.begin(), pack);
  }
  return base::Done{};
}

std::vector<Segment> CpuRenderer::State::segments() const {
  std::vector<Segment> all;
  std::uint32_t items_so_far = 0;
  const auto add = [&](std::span<const mesh::Triangle> triangles) -> Segment& {
    Segment& made = all.emplace_back();
    made.first_item = items_so_far;
    made.triangles = triangles;
    items_so_far += static_cast<std::uint32_t>(triangles.size());
    return made;
  };
  const auto add_batch = [&](const DrawList::Batch& batch, bool see_through) {
    const document::Surface& surface = look->surfaces[batch.of.surface];
    Segment& made = add(batch.triangles);
    made.surface = &surface;
    made.roughness = batch.of.roughness;
    made.metallic = batch.of.metallic;
    made.culls_back = !surface.double_sided;
    made.see_through = see_through;
    made.least_alpha = see_through ? k_nearly_clear : least_alpha(surface);
    if (surface.texture) {
      made.texture = textures.find(*look, *surface.texture);
      made.place = transform_of(*surface.texture);
    }
    if (!surface.toon || !surface.toon->shade_texture) return;
    made.shade_texture = textures.find(*look, *surface.toon->shade_texture);
    made.shade_place = transform_of(*surface.toon->shade_texture);
  };
  add(list.opaque);
  for (const document::AlphaMode mode :
       {document::AlphaMode::opaque, document::AlphaMode::mask, document::AlphaMode::blend}) {
    for (const DrawList::Batch& batch : list.batches) {
      if (look->surfaces[batch.of.surface].alpha == mode) add_batch(batch, false);
    }
  }
  for (const DrawList::Batch& batch : list.batches) {
    if (!has_outline(look->surfaces[batch.of.surface])) continue;
    add_batch(batch, false);
    all.back().culls_back = false;
    all.back().outline = true;
    all.back().shift = static_cast<std::uint32_t>(finish.size());
  }
  for (const std::size_t b : list.blended) add_batch(list.batches[b], true);
  add(list.translucent).see_through = true;
  return all;
}

void CpuRenderer::State::draw_backdrop(const Scene& scene, const View& view, geometry::Viewport size) {
  const Background& colors = scene.background;
  // The ground is left out where the darkening of creases is.
  const auto ground =
      occlude && (!behind.image || behind.front) && scene.appearance != nullptr ? scene.appearance->light : nullptr;
  const bool known = ground == backdrop_ground && (!ground || view == backdrop_view) && backdrop.width == size.width &&
                     backdrop.height == size.height && backdrop_behind == behind &&
                     same_background(backdrop_colors, colors);
  if (known) return;
  backdrop.width = size.width;
  backdrop.height = size.height;
  const std::size_t row = static_cast<std::size_t>(size.width) * 4;
  backdrop.pixels.resize(row * static_cast<std::size_t>(size.height));
  backdrop_colors = colors;
  backdrop_behind = behind;
  backdrop_ground = ground;
  backdrop_view = view;
  for (int y = 0; y < size.height; ++y) {
    draw_backdrop_row(colors, behind, size, y, 0,
                      std::span(backdrop.pixels).subspan(static_cast<std::size_t>(y) * row, row));
  }
  if (ground) draw_ground(*ground, view, backdrop);
}

void CpuRenderer::State::draw_pass(const Scene& scene, const geometry::Camera& camera, int pass, bool pose_alone) {
  Raster raster{make_view(scene.positions, camera), camera.viewport(), glm::vec2(0)};
  // A view that is made anew with each pose would move all of the picture by thousandths of a px.
  const bool goes_on = pose_alone || (smooths && pass > 0);
  if (goes_on && serves(first_view, raster.view)) raster.view = first_view;
  // Samples move one way, the picture the other; y counts downwards.
  raster.shift = {-k_smoothing_places[pass][0], k_smoothing_places[pass][1]};
  draw_backdrop(scene, raster.view, raster.size);
  order_blended(list, scene, raster.view, [](std::size_t) {});
  // What moved is told by the first pass of the picture before.
  const bool keeps = pass == 0 && smooths;
  std::vector<bool> changed;
  place_vertices(raster, scene.positions, scene.normals, vertices);
  outlines.place(raster, scene.positions, scene.normals, vertices);
  if (keeps) {
    if (pose_alone && outlines.empty() && raster.view == first_view && first_vertices.size() == vertices.size()) {
      if (auto some = changed_tiles(list, raster.size, first_vertices, vertices)) changed = std::move(*some);
    }
    first_view = raster.view;
    first_vertices = vertices;
  }
  items.sort(raster, scene.positions, vertices, segments(), changed);
  surfaces.width = raster.size.width;
  surfaces.height = raster.size.height;
  const std::size_t px = static_cast<std::size_t>(raster.size.width) * static_cast<std::size_t>(raster.size.height);
  surfaces.pixels.resize(px * 4);
  if (pass == 0) depths.assign(occlude ? px : 0, 0.0F);
  const TileScene shown{raster,
                        vertices,
                        {finish, overlay, tint, light, look.get()},
                        items,
                        scene.wireframe ? std::span<const std::pair<std::uint32_t, std::uint32_t>>(list.edges)
                                        : std::span<const std::pair<std::uint32_t, std::uint32_t>>(),
                        backdrop,
                        behind,
                        scene.matcap};
  std::vector<std::unique_ptr<TileDrawer>> drawers(workers.count());
  for (auto& one : drawers) one = std::make_unique<TileDrawer>(shown);
  workers.share(items.tile_count(), [&](int tile, unsigned worker) {
    if (!changed.empty() && !changed[static_cast<std::size_t>(tile)]) return;
    drawers[worker]->draw(tile, surfaces, pass == 0 ? std::span<float>(depths) : std::span<float>());
  });
}

/// The surfaces become the average of all passes.
void CpuRenderer::State::add_pass() {
  const std::size_t size = surfaces.pixels.size();
  if (passes == 0) sums.assign(size, 0);
  ++passes;
  const auto count = static_cast<unsigned>(passes);
  const unsigned half = count / 2;
  // Divided by a product: exact for sums of eight bytes.
  const unsigned over = (65536U + count - 1) / count;
  std::uint16_t* const sum = sums.data();
  std::uint8_t* const px = surfaces.pixels.data();
  for (std::size_t i = 0; i < size; ++i) {
    sum[i] = static_cast<std::uint16_t>(sum[i] + px[i]);
    px[i] = static_cast<std::uint8_t>((sum[i] + half) * over >> 16U);
  }
}

void CpuRenderer::State::draw_occlusion(const Scene& scene, const geometry::Camera& camera) {
  const Raster raster{make_view(scene.positions, camera), camera.viewport(), glm::vec2(0)};
  Occlusion occlusion(raster, depths);
  workers.share(raster.size.height, [&](int y, unsigned) { occlusion.measure_row(y); });
  workers.share(raster.size.height, [&](int y, unsigned) { occlusion.darken_row(y, surfaces); });
}

base::Status CpuRenderer::State::draw_surfaces(const Scene& scene, const geometry::Camera& camera) {
  const auto [width, height] = camera.viewport();
  if (width > k_most_side_px || height > k_most_side_px) {
    return base::Error{"a picture of " + std::to_string(width) + " x " + std::to_string(height) + " px is too large",
                       "size", "use at most " + std::to_string(k_most_side_px) + " px a side"};
  }
  if (auto taken = take(scene); !taken) return taken.error();
  const PictureSource now(scene, camera, behind);
  const bool same = now.same_as(last);
  const bool pose_alone = now.same_but_pose(last) && !occlude && !scene.wireframe;
  last = now;
  still = now.numbered();
  if (!smooths) {
    if (same && passes == k_smoothing_passes) return base::Done{};
    passes = 0;
    for (int pass = 0; pass < k_smoothing_passes; ++pass) {
      draw_pass(scene, camera, pass);
      add_pass();
    }
    if (occlude && !scene.triangles.empty() && !has_toon(list, scene.appearance)) draw_occlusion(scene, camera);
    return base::Done{};
  }
  if (!same) {
    // Where nothing moves the picture stays as smooth as it was.
    passes = 0;
    draw_pass(scene, camera, 0, pose_alone);
  } else if (passes < k_smoothing_passes) {
    if (passes == 0) add_pass();  // what was shown is the first
    if (passes < k_smoothing_passes) {
      draw_pass(scene, camera, passes);
      add_pass();
    }
    if (passes == k_smoothing_passes) sums = {};
  }
  return base::Done{};
}

CpuRenderer::CpuRenderer(std::uint64_t most_texture_px) : state_(std::make_unique<State>()) {
  state_->most_texture_px = most_texture_px;
}
CpuRenderer::~CpuRenderer() = default;

base::Result<Image> CpuRenderer::render(const Scene& scene, const geometry::Camera& camera) {
  Image picture;
  if (auto drawn = draw(scene, camera, picture); !drawn) return drawn.error();
  return picture;
}

base::Status CpuRenderer::draw(const Scene& scene, const geometry::Camera& camera, Image& picture) {
  if (auto drawn = state_->draw_surfaces(scene, camera); !drawn) return drawn.error();
  picture = state_->surfaces;
  if (state_->veil) lay_veil(*state_->veil, picture);
  draw_curves(scene.curves, camera, picture);
  return base::Done{};
}

void CpuRenderer::set_behind(Behind behind) { state_->behind = std::move(behind); }
void CpuRenderer::set_veil(std::shared_ptr<const Image> veil) { state_->veil = std::move(veil); }
void CpuRenderer::set_occlusion(bool on) { state_->occlude = on; }
void CpuRenderer::set_smoothing(bool on) { state_->smooths = on; }
bool CpuRenderer::refining() const { return state_->smooths && state_->still && state_->passes < k_smoothing_passes; }
std::vector<std::string> CpuRenderer::take_undrawn() { return state_->textures.take_undrawn(); }
std::string CpuRenderer::driver() const { return "the processor"; }

}  // namespace penpose::render
