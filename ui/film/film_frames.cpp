#include "ui/film/film_frames.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <utility>

#include "core/document/time/animation_sampling.h"

namespace penpose::film {
namespace {

/// More than any film has; the moments of files may be anything.
constexpr double k_last_frame = 1e6;

int frame_at(double time_s, double rate) {
  return static_cast<int>(std::clamp(std::round(time_s * rate), 0.0, k_last_frame));
}

}  // namespace

render::Background light_background() { return {render::from_srgb(0xe4e7ea), render::from_srgb(0xaab2ba)}; }

base::Result<FilmFrames> FilmFrames::make(document::Document document, double rate) {
  if (document.timeline->keys.empty() && document.model->animations.empty() && !document.camera) {
    return base::Error{"there is nothing to film", "", "key a pose first"};
  }
  FilmFrames frames;
  frames.document_ = std::move(document);
  frames.rate_ = rate;
  return frames;
}

int FilmFrames::last() const {
  const auto& keys = document_.timeline->keys;
  const int seen = document_.camera ? frame_at(document_.camera->keys.back().time_s, rate_) : 0;
  if (!keys.empty()) return std::max(seen, frame_at(keys.back().time_s, rate_));
  if (document_.model->animations.empty()) return seen;
  return std::max(seen, frame_at(document::duration_s(document_.model->animations.front()), rate_));
}

std::vector<int> FilmFrames::keyed() const {
  std::set<int> frames;
  for (const auto& key : document_.timeline->keys) frames.insert(frame_at(key.time_s, rate_));
  if (frames.empty() && !document_.model->animations.empty()) {
    for (const auto& channel : document_.model->animations.front().channels) {
      for (const auto time_s : channel.times_s) frames.insert(frame_at(time_s, rate_));
    }
  }
  if (frames.empty() && document_.camera) {
    for (const auto& key : document_.camera->keys) frames.insert(frame_at(key.time_s, rate_));
  }
  return {frames.begin(), frames.end()};
}

base::Result<document::Model> FilmFrames::at(int frame) const {
  const double time_s = frame / rate_;
  const document::Model& model = *document_.model;
  if (document_.timeline->keys.empty() && !model.animations.empty()) {
    return document::model_at(model, document::sample(model, model.animations.front(), time_s));
  }
  document::Model moment = model;
  moment.pose = document::pose_at(document_, time_s);
  return moment;
}

std::optional<geometry::Camera> FilmFrames::camera_at(int frame, geometry::Viewport whole,
                                                      const std::optional<PxPart>& part) const {
  if (!document_.camera) return std::nullopt;
  const PxPart all{0, 0, whole};
  const PxPart& shown = part ? *part : all;
  const geometry::PxPoint from{static_cast<double>(shown.left), static_cast<double>(shown.top)};
  const geometry::PxPoint size{static_cast<double>(shown.size.width), static_cast<double>(shown.size.height)};
  const auto framed = document::camera_at(*document_.camera, frame / rate_);
  const auto camera = geometry::Camera::make(document::camera_of_whole(*framed, whole, {from, from + size}), whole);
  return camera ? std::optional(*camera) : std::nullopt;
}

render::Image part_of(const render::Image& image, const PxPart& part) {
  render::Image cut;
  cut.width = part.size.width;
  cut.height = part.size.height;
  const auto row_bytes = static_cast<std::size_t>(cut.width) * 4;
  cut.pixels.resize(row_bytes * static_cast<std::size_t>(cut.height));
  for (int y = 0; y < cut.height; ++y) {
    std::memcpy(cut.pixels.data() + row_bytes * static_cast<std::size_t>(y), image.at(part.left, part.top + y),
                row_bytes);
  }
  return cut;
}

base::Result<render::Image> draw_frame(const FilmFrames& frames, int frame, render::Renderer& renderer,
                                       const render::Appearance& appearance, const FrameLook& look) {
  const auto moment = frames.at(frame);
  if (!moment) return moment.error();
  const render::PosedMesh posed = render::posed_mesh(*moment);
  render::Scene scene = render::scene_of(*moment, posed, appearance);
  scene.wireframe = look.wireframe;
  scene.clay = look.clay;
  scene.matcap = look.matcap;
  if (look.light) scene.background = light_background();
  const auto moving = look.moves ? frames.camera_at(frame, look.camera.viewport(), look.part) : std::nullopt;
  const geometry::Camera& camera = moving ? *moving : look.camera;
  if (look.ghosts != nullptr)
    look.ghosts->add(frames.document(), frame / frames.rate(), frames.rate(), camera, scene, renderer);
  auto image = renderer.render(scene, camera);
  if (!image || !look.part) return image;
  return part_of(*image, *look.part);
}

}  // namespace penpose::film
