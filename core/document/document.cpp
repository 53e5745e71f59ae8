#include "core/document/document.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>
#include <utility>

#include "core/document/time/timeline_animation.h"
#include "core/document/time/timeline_editing.h"

namespace penpose::document {

Document make_document(Model model) {
  Document document;
  document.pose = model.pose;
  document.model = std::make_shared<const Model>(std::move(model));
  document.timeline = std::make_shared<const Timeline>();
  return document;
}

Document with_model(const Document& document, Model model) {
  Document after = document;
  after.model = std::make_shared<const Model>(std::move(model));
  const auto old_parameters = document.model->rig->parameters();
  const auto parameters = after.model->rig->parameters();
  std::vector<std::optional<std::size_t>> old_number;
  for (const rig::Parameter& parameter : parameters) {
    old_number.push_back(rig::find_parameter(old_parameters, parameter.name));
  }
  const auto carried = [&](const rig::Pose& pose) {
    rig::Pose other;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const double value = old_number[i] ? pose[*old_number[i]] : parameters[i].rest;
      other.push_back(std::clamp(value, parameters[i].minimum, parameters[i].maximum));
    }
    return other;
  };
  after.pose = carried(document.pose);
  const auto carried_keys = [&](const std::shared_ptr<const Timeline>& keys) -> std::shared_ptr<const Timeline> {
    if (!keys) return nullptr;
    Timeline timeline = *keys;
    for (PoseKey& key : timeline.keys) {
      key.pose = carried(key.pose);
      if (key.controls.usual()) continue;
      std::vector<ControlKey> controls;
      for (const auto& number : old_number)
        controls.push_back(number ? key.controls[*number] : ControlKey{KeyKind::none});
      key.controls = std::move(controls);
    }
    return std::make_shared<const Timeline>(settled(std::move(timeline), parameters));
  };
  after.timeline = carried_keys(document.timeline);
  for (auto& clip : after.clips) {
    Clip other = *clip;
    // Both are the same list where nothing was changed.
    other.opened = clip->opened == document.timeline ? after.timeline : carried_keys(clip->opened);
    other.timeline = clip->timeline == clip->opened ? other.opened : carried_keys(clip->timeline);
    clip = std::make_shared<const Clip>(std::move(other));
  }
  std::erase_if(after.locked, [&](const std::string& name) { return !rig::find_parameter(parameters, name); });
  after.mouths = mouths_of_rig(document.mouths, parameters);
  if (document.taken) after.taken = taken_of_rig(*document.taken, parameters);
  return after;
}

std::shared_ptr<const std::vector<TakenReading>> taken_of_rig(std::vector<TakenReading> taken,
                                                              std::span<const rig::Parameter> parameters) {
  const auto known = [&](const std::string& name) { return rig::find_parameter(parameters, name).has_value(); };
  std::erase_if(taken, [&](const TakenReading& one) {
    return !std::all_of(one.taken.begin(), one.taken.end(), known) ||
           !std::all_of(one.instead_of.begin(), one.instead_of.end(), known) ||
           (one.taken.empty() && one.instead_of.empty());
  });
  if (taken.empty()) return nullptr;
  return std::make_shared<const std::vector<TakenReading>>(std::move(taken));
}

bool is_plain(const Document& document) {
  return document.locked.empty() && !document.pressure_weighting && document.hand == 1.0 && document.curves.empty() &&
         document.last_curve == 0 && !document.taken && !document.pending && document.timeline->keys.empty() &&
         document.views.empty() && !document.face && !document.neutral && !document.sound && document.mouths.empty() &&
         !document.spoken && !document.words && !document.bookmarks && document.clips.empty() && !document.camera &&
         !document.reference;
}

namespace {

bool overshoots(const Timeline& timeline, std::size_t parameter, double time_s) {
  const std::size_t place = first_from(timeline, time_s);
  const auto after = key_after(timeline, parameter, place);
  const auto before = place > 0 ? key_before(timeline, parameter, place - 1) : std::nullopt;
  if (after && timeline.keys[*after].controls[parameter].kind == KeyKind::overshoot) return true;
  return before && after && segment_of(timeline, parameter, *before, *after).overshoots;
}

}  // namespace

rig::Pose pose_at(const Document& document, double time_s) {
  rig::Pose pose = sample(*document.timeline, time_s, document.pose);
  const auto parameters = document.model->rig->parameters();
  for (std::size_t i = 0; i < pose.size(); ++i) {
    const double within = std::clamp(pose[i], parameters[i].minimum, parameters[i].maximum);
    // Rounding alone leaves the range elsewhere.
    if (within != pose[i] && !overshoots(*document.timeline, i, time_s)) pose[i] = within;
  }
  return pose;
}

std::string shown_clip_name(const Document& document) {
  return document.clips.empty() ? k_timeline_name : clip_name(*document.clips[document.clip]);
}

std::string clip_name(const Clip& clip) {
  return clip.name.empty() && clip.animation ? "animation " + std::to_string(*clip.animation + 1) : clip.name;
}

const Timeline& keys_of_clip(const Document& document, std::size_t number) {
  return number == document.clip ? *document.timeline : *document.clips[number]->timeline;
}

namespace {

/// Clips that were made here, as animations.
std::vector<Animation> made_of(const Document& document, const Model& model) {
  std::vector<Animation> made;
  const auto add = [&](const std::string& name, const Timeline& timeline) {
    Animation animation = to_animation(model, timeline);
    animation.name = name;
    if (!animation.channels.empty()) made.push_back(std::move(animation));
  };
  if (document.clips.empty()) add(k_timeline_name, *document.timeline);
  for (std::size_t i = 0; i < document.clips.size(); ++i) {
    if (!document.clips[i]->animation) add(document.clips[i]->name, keys_of_clip(document, i));
  }
  return made;
}

}  // namespace

std::vector<std::string> made_animations(const Document& document) {
  std::vector<std::string> names;
  for (const Animation& one : made_of(document, *document.model)) names.push_back(one.name);
  return names;
}

Model model_of(const Document& document) {
  Model model = *document.model;
  model.pose = document.pose;
  std::set<std::size_t, std::greater<>> emptied;
  for (std::size_t i = 0; i < document.clips.size(); ++i) {
    const Clip& clip = *document.clips[i];
    if (!clip.animation) continue;
    Animation& animation = model.animations[*clip.animation];
    const Timeline& keys = keys_of_clip(document, i);
    if (keys.keys.empty()) emptied.insert(*clip.animation);
    if (!(*clip.opened == keys)) animation = with_keys(model, animation, *clip.opened, keys);
    animation.name = clip.name;
  }
  for (const std::size_t number : emptied)
    model.animations.erase(model.animations.begin() + static_cast<std::ptrdiff_t>(number));
  std::vector<Animation> made = made_of(document, model);
  model.animations.insert(model.animations.begin(), std::make_move_iterator(made.begin()),
                          std::make_move_iterator(made.end()));
  return model;
}

const PoseCurve* find_curve(const Document& document, CurveId id) {
  for (const auto& curve : document.curves) {
    if (curve->id == id) return curve.get();
  }
  return nullptr;
}

std::optional<CurveId> waiting_reference(const Document& document) {
  for (const auto& curve : document.curves) {
    if (curve->role == PoseCurveRole::reference && !curve->target) return curve->id;
  }
  return std::nullopt;
}

const FaceLine* find_face_line(const Document& document, CurveId id) {
  if (!document.face) return nullptr;
  for (const FaceLine& line : document.face->lines) {
    if (line.id == id) return &line;
  }
  return nullptr;
}

}  // namespace penpose::document
