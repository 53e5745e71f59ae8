#include "ui/film/film_frames.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <utility>

#include "core/document/time/animation_sampling.h"
#include "ui/render/merged.h"

namespace penpose::film {
namespace {

/// More than any film has; the moments of files may be anything.
constexpr double k_last_frame = 1e6;

int frame_at(double time_s, double rate) {
  return static_cast<int>(std::clamp(std::round(time_s * rate), 0.0, k_last_frame));
}

/// Nothing of it moves with time.
bool is_still(const document::Document& document) {
  return document.timeline->keys.empty() && document.model->animations.empty();
}

double end_s_of(const document::Document& document) {
  if (is_still(document)) return 0;
  const auto& keys = document.timeline->keys;
  return keys.empty() ? document::duration_s(document.model->animations.front()) : keys.back().time_s;
}

base::Result<document::Model> moment_of(const document::Document& document, double time_s) {
  const document::Model& model = *document.model;
  if (document.timeline->keys.empty() && !model.animations.empty())
    return document::model_at(model, document::sample(model, model.animations.front(), time_s));
  document::Model moment = model;
  moment.pose = is_still(document) ? document.pose : document::pose_at(document, time_s);
  return moment;
}

/// A frame of several characters.
struct Together {
  render::MergedShape shape;
  render::MergedPose pose;
};

base::Result<Together> together_at(const FilmFrames& frames, int frame, const document::Model& moment,
                                   const render::PosedMesh& posed, const render::Appearance& appearance) {
  std::vector<document::Model> models;
  std::vector<render::PosedMesh> meshes;
  for (std::size_t i = 0; i < frames.others().size(); ++i) {
    auto model = frames.other_at(i, frame);
    if (!model) return model.error();
    meshes.push_back(render::posed_mesh(*model));
    models.push_back(std::move(*model));
  }
  std::vector<render::ScenePart> parts{{&moment, &appearance, {}, posed.positions, posed.normals}};
  for (std::size_t i = 0; i < models.size(); ++i) {
    const Beside& other = frames.others()[i];
    parts.push_back({&models[i], &other.appearance, other.placement, meshes[i].positions, meshes[i].normals});
  }
  return Together{render::merged_shape(parts), render::merged_pose(parts)};
}

}  // namespace

render::Background light_background() { return {render::from_srgb(0xe4e7ea), render::from_srgb(0xaab2ba)}; }

base::Result<FilmFrames> FilmFrames::make(document::Document document, double rate, std::vector<Beside> others) {
  FilmFrames frames;
  frames.document_ = std::move(document);
  frames.others_ = std::move(others);
  frames.rate_ = rate;
  const auto all = frames.all();
  if (!frames.document_.camera && std::all_of(all.begin(), all.end(), [](const auto* one) { return is_still(*one); }))
    return base::Error{"there is nothing to film", "", "key a pose first"};
  return frames;
}

std::vector<const document::Document*> FilmFrames::all() const {
  std::vector<const document::Document*> all{&document_};
  for (const Beside& other : others_) all.push_back(&other.document);
  return all;
}

int FilmFrames::last() const {
  int last = document_.camera ? frame_at(document_.camera->keys.back().time_s, rate_) : 0;
  for (const auto* one : all()) last = std::max(last, frame_at(end_s_of(*one), rate_));
  return last;
}

std::vector<int> FilmFrames::keyed() const {
  std::set<int> frames;
  for (const auto* one : all()) {
    for (const auto& key : one->timeline->keys) frames.insert(frame_at(key.time_s, rate_));
    if (!one->timeline->keys.empty() || is_still(*one)) continue;
    for (const auto& channel : one->model->animations.front().channels) {
      for (const auto time_s : channel.times_s) frames.insert(frame_at(time_s, rate_));
    }
  }
  if (frames.empty() && document_.camera) {
    for (const auto& key : document_.camera->keys) frames.insert(frame_at(key.time_s, rate_));
  }
  return {frames.begin(), frames.end()};
}

base::Result<document::Model> FilmFrames::at(int frame) const { return moment_of(document_, frame / rate_); }

base::Result<document::Model> FilmFrames::other_at(std::size_t other, int frame) const {
  return moment_of(others_[other].document, frame / rate_);
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
  Together together;
  if (!frames.others().empty()) {
    auto all = together_at(frames, frame, *moment, posed, appearance);
    if (!all) return all.error();
    together = std::move(*all);
    scene.positions = together.pose.positions;
    scene.normals = together.pose.normals;
    scene.triangles = together.shape.triangles;
    scene.appearance = &together.shape.appearance;
  }
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
