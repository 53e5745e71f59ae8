#include "ui/app/cast/cast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "core/document/time/timeline.h"
#include "ui/files/load_model.h"
#include "ui/render/merged.h"

namespace penpose::app {
namespace {

constexpr double k_same_moment_s = 1e-4;

}  // namespace

std::string character_name(const std::string& path) {
  if (path.starts_with("builtin:")) return path.substr(std::string_view("builtin:").size());
  const files::ModelName name = files::model_name(path);
  std::string stem = std::filesystem::path(name.file).stem().string();
  if (stem.size() > io::k_longest_character_name / 2) stem.resize(io::k_longest_character_name / 2);
  return stem.empty() ? "character" : stem;
}

const document::Document& Cast::document(std::size_t character) const {
  return character == active_ && !members_[character]->session.live ? editing_.document()
                                                                    : members_[character]->session.document();
}

geometry::Placement Cast::beside(std::size_t character) const {
  return geometry::joined(at(character).placement, geometry::inverse(at(active_).placement));
}

std::optional<std::size_t> Cast::find(const std::string& name) const {
  const auto found = std::find_if(members_.begin(), members_.end(), [&](const auto& one) { return one->name == name; });
  return found == members_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - members_.begin()));
}

std::string Cast::free_name(const std::string& wanted) const {
  std::string name = wanted;
  for (int i = 2; find(name); ++i) name = wanted + " " + std::to_string(i);
  return name;
}

void Cast::changed() {
  moved_ = true;
  ++revision_;
}

void Cast::end(Character& character) {
  if (!character.session.live) return;
  recording_.end(character.recorded, character.session.live->session().editor().history());
}

void Cast::end_others() {
  for (const auto& one : members_) end(*one);
  if (removed_) end(*removed_);
  removed_.reset();
}

void Cast::begin(const std::string& path) {
  end_others();
  members_.clear();
  members_.push_back(std::make_unique<Character>());
  members_.front()->name = character_name(path);
  members_.front()->path = path;
  active_ = 0;
  moved_ = false;
  ++revision_;
}

void Cast::set_aside() {
  Character& now = *members_[active_];
  now.session = editing_.set_aside();
  now.recorded = recording_.set_aside();
  now.posed_at_s.reset();
  std::swap(now.surface, canvas_.surface());
}

void Cast::add(const std::string& path, const io::CastMember* like) {
  const geometry::Placement before = at(active_).placement;
  members_.push_back(std::make_unique<Character>());
  Character& one = *members_.back();
  active_ = members_.size() - 1;
  one.path = path;
  one.name = free_name(like != nullptr ? like->name : character_name(path));
  if (like != nullptr) one.placement = like->placement;
  if (like != nullptr) one.shown = like->shown;
  canvas_.surface().update(editing_.shown().model(), editing_.shown().pose());
  canvas_.set_camera(placed(joined(before, inverse(one.placement)), canvas_.view().camera));
  changed();
}

void Cast::take_up(std::size_t character) {
  const geometry::Placement before = at(active_).placement;
  Character& one = *members_[character];
  editing_.take_up(std::exchange(one.session, {}));
  recording_.take_up(std::exchange(one.recorded, {}));
  std::swap(one.surface, canvas_.surface());
  active_ = character;
  one.shown = true;
  canvas_.surface().update(editing_.shown().model(), editing_.shown().pose());
  canvas_.set_camera(placed(joined(before, inverse(one.placement)), canvas_.view().camera));
  ++revision_;
}

void Cast::remove(std::size_t character) {
  if (removed_) end(*removed_);
  removed_ = std::move(members_[character]);
  members_.erase(members_.begin() + static_cast<std::ptrdiff_t>(character));
  if (active_ > character) --active_;
  changed();
}

void Cast::bring_back() {
  if (!removed_) return;
  removed_->name = free_name(removed_->name);
  members_.push_back(std::move(removed_));
  changed();
}

void Cast::describe(std::size_t character, const io::CastMember& like) {
  rename(character, like.name);
  place(character, like.placement);
  show(character, like.shown);
}

void Cast::frame_all() {
  std::vector<render::ScenePart> parts;
  const PosedSurface& own = canvas_.surface();
  parts.push_back({.placement = {}, .positions = own.positions()});
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const Character& one = *members_[i];
    if (i != active_ && one.shown && one.session.live)
      parts.push_back({.placement = beside(i), .positions = one.surface.positions()});
  }
  canvas_.frame_points(render::merged_pose(parts).positions);
}

void Cast::rename(std::size_t character, const std::string& name) {
  if (name.empty() || name == at(character).name) return;
  members_[character]->name.clear();
  members_[character]->name = free_name(name.substr(0, io::k_longest_character_name - 10));
  changed();
}

void Cast::show(std::size_t character, bool shown) {
  if (members_[character]->shown == shown) return;
  members_[character]->shown = shown;
  changed();
}

void Cast::place(std::size_t character, const geometry::Placement& placement) {
  Character& one = *members_[character];
  if (one.placement == placement) return;
  // The view of the scene stays.
  if (character == active_)
    canvas_.set_camera(placed(joined(one.placement, inverse(placement)), canvas_.view().camera));
  one.placement = placement;
  changed();
}

void Cast::follow(double time_s, bool plays) {
  recedes_ = !plays;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    Character& one = *members_[i];
    if (!one.session.live || !one.shown || one.posed_at_s == time_s) continue;
    const document::Document& document = one.session.document();
    // What is not keyed is seen where it was left.
    const bool as_left = document.timeline->keys.empty() || std::abs(document.time_s - time_s) < k_same_moment_s;
    one.surface.update(document.model, as_left ? document.pose : document::pose_at(document, time_s));
    one.posed_at_s = time_s;
  }
}

double Cast::last_key_s() const {
  double last_s = 0;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (i == active_) continue;
    const auto& keys = document(i).timeline->keys;
    if (!keys.empty()) last_s = std::max(last_s, keys.back().time_s);
  }
  return last_s;
}

std::optional<std::size_t> Cast::touched(PxPoint at_px) {
  const document::View& view = canvas_.view();
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!several() || !camera) return std::nullopt;
  const auto own = canvas_.surface().pick(*camera, at_px);
  double nearest = own ? own->distance : 1e300;
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    Character& one = *members_[i];
    if (i == active_ || !one.shown || !one.posed_at_s) continue;
    const geometry::Placement there = beside(i);
    const auto seen = geometry::Camera::make(placed(inverse(there), view.camera), view.viewport);
    const auto hit = seen ? one.surface.pick(*seen, at_px) : std::nullopt;
    if (!hit || hit->distance * there.scale >= nearest) continue;
    nearest = hit->distance * there.scale;
    found = i;
  }
  return found;
}

bool Cast::unsaved() const {
  return moved_ || std::any_of(members_.begin(), members_.end(), [](const auto& one) { return one->session.unsaved; });
}

void Cast::mark_saved() {
  moved_ = false;
  for (const auto& one : members_) one->session.unsaved = false;
}

io::Cast Cast::described() const {
  io::Cast cast;
  cast.active = active_;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const Character& one = *members_[i];
    const std::string session = i == active_        ? recording_.path()
                                : one.recorded.file ? one.recorded.file->path()
                                                    : std::string();
    cast.members.push_back({one.name, one.placement, one.shown, session, one.path});
  }
  return cast;
}

std::vector<const document::Document*> Cast::documents() const {
  std::vector<const document::Document*> all;
  for (std::size_t i = 0; i < members_.size(); ++i) all.push_back(&document(i));
  return all;
}

void Cast::note_project(const std::string& project) {
  for (const auto& one : members_) {
    if (!one->session.live || !one->recorded.file) continue;
    const bool saved = !one->session.unsaved && !project.empty();
    one->recorded.file->note_project(project,
                                     saved ? one->session.live->session().editor().state().whole.hex() : std::string());
  }
}

}  // namespace penpose::app
