#include "core/io/project/internal/project_time.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "core/document/commands/text_form.h"
#include "core/document/time/clips/clip.h"
#include "core/document/time/timeline_editing.h"
#include "core/io/project/internal/project_bookmarks.h"
#include "core/io/project/internal/project_sound.h"

namespace penpose::io {
namespace {

using document::ControlKey;
using document::ControlKeys;
using document::KeyKind;

constexpr double k_steepest_slope = 1e12;

std::optional<ControlKey> read_control(const json::Json& value, std::size_t parameters, std::size_t& parameter) {
  if (!value.is_array() || (value.size() != 2 && value.size() != 4)) return std::nullopt;
  const auto number = json::number(value[0]);
  if (!number || !(*number >= 0 && *number < static_cast<double>(parameters)) || std::floor(*number) != *number)
    return std::nullopt;
  parameter = static_cast<std::size_t>(*number);
  if (!value[1].is_string()) return std::nullopt;
  const auto kind = document::TextForm<KeyKind>::read(value[1].get<std::string>());
  if (!kind || *kind == KeyKind::none || document::has_slopes(*kind) != (value.size() == 4)) return std::nullopt;
  ControlKey key{*kind, 0, 0};
  if (!document::has_slopes(*kind)) return key;
  const auto in = json::number(value[2]);
  const auto out = json::number(value[3]);
  if (!in || !out || !(std::abs(*in) <= k_steepest_slope && std::abs(*out) <= k_steepest_slope)) return std::nullopt;
  key.in = *in;
  key.out = *out;
  return key;
}

Problem read_controls(const json::Json& key, const std::string& pointer, std::size_t parameters, ControlKeys& out) {
  const json::Json* value = json::find(key, "controls");
  if (value == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, "controls");
  if (!value->is_array()) return project_error("a list of keys of controls was expected", here);
  std::vector<ControlKey> list(parameters, {KeyKind::none, 0, 0});
  for (std::size_t i = 0; i < value->size(); ++i) {
    std::size_t parameter = 0;
    const auto control = read_control((*value)[i], parameters, parameter);
    if (!control)
      return project_error("the number of a control, a kind and the slopes of a free or overshooting one were expected",
                           json::child(here, i));
    list[parameter] = *control;
  }
  out = std::move(list);
  return std::nullopt;
}

json::Json controls_to_json(const document::PoseKey& key) {
  json::Json list = json::Json::array();
  for (std::size_t i = 0; i < key.pose.size(); ++i) {
    const ControlKey control = key.controls[i];
    if (control.kind == KeyKind::none) continue;
    std::string kind;
    document::TextForm<KeyKind>::write(kind, control.kind);
    json::Json one = json::Json::array({i, kind});
    if (document::has_slopes(control.kind)) {
      one.push_back(control.in);
      one.push_back(control.out);
    }
    list.push_back(std::move(one));
  }
  return list;
}

Problem read_keys(const json::Json& value, const std::string& here, std::span<const rig::Parameter> parameters,
                  std::shared_ptr<const document::Timeline>& out) {
  if (!value.is_object()) return project_error("an object was expected", here);
  document::Timeline timeline;
  const json::Json* keys = json::find(value, "keys");
  const std::string list = json::child(here, "keys");
  if (keys == nullptr || !keys->is_array()) return project_error("a list of keys was expected", list);
  for (std::size_t i = 0; i < keys->size(); ++i) {
    const std::string at = json::child(list, i);
    document::PoseKey key;
    const json::Json* time = json::find((*keys)[i], "time_s");
    const auto seconds = time == nullptr ? std::nullopt : json::number(*time);
    const double before = timeline.keys.empty() ? -1.0 : timeline.keys.back().time_s;
    if (!seconds || !(*seconds >= 0 && *seconds > before && *seconds <= document::k_latest_key_s)) {
      return project_error("moments were expected that ascend from 0", json::child(at, "time_s"));
    }
    key.time_s = *seconds;
    const json::Json* pose = json::find((*keys)[i], "pose");
    if (pose == nullptr) return project_error("a pose was expected", json::child(at, "pose"));
    rig::Pose values;
    if (auto problem = read_row(*pose, json::child(at, "pose"), parameters.size(), values)) return problem;
    if (const json::Json* name = json::find((*keys)[i], "name"); name != nullptr) {
      if (!name->is_string()) return project_error("a name was expected", json::child(at, "name"));
      key.name = name->get<std::string>();
    }
    if (auto problem = read_controls((*keys)[i], at, parameters.size(), key.controls)) return problem;
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      if (key.controls[p].kind == KeyKind::overshoot) continue;
      values[p] = std::clamp(values[p], parameters[p].minimum, parameters[p].maximum);
    }
    key.pose = std::move(values);
    timeline.keys.push_back(std::move(key));
  }
  out = std::make_shared<const document::Timeline>(document::settled(std::move(timeline), parameters));
  return std::nullopt;
}

Problem read_clip(const json::Json& value, const std::string& here, const document::Document& document,
                  document::Clip& out) {
  const json::Json* name = json::find(value, "name");
  if (name == nullptr || !name->is_string()) return project_error("a name was expected", json::child(here, "name"));
  out.name = name->get<std::string>();
  if (const json::Json* animation = json::find(value, "animation"); animation != nullptr) {
    const auto number = json::number(*animation);
    const auto count = static_cast<double>(document.model->animations.size());
    if (!number || !(*number >= 0 && *number < count) || std::floor(*number) != *number)
      return project_error("the number of an animation was expected", json::child(here, "animation"));
    out.animation = static_cast<std::size_t>(*number);
  }
  const json::Json* timeline = json::find(value, "timeline");
  if (timeline == nullptr) return std::nullopt;
  if (auto problem = read_bookmarks(value, here, out.bookmarks)) return problem;
  if (auto problem =
          read_keys(*timeline, json::child(here, "timeline"), document.model->rig->parameters(), out.timeline))
    return problem;
  return read_spoken(value, here, document.mouths, out.spoken);
}

}  // namespace

json::Json timeline_to_json(const document::Timeline& timeline) {
  json::Json keys = json::Json::array();
  for (const document::PoseKey& key : timeline.keys) {
    json::Json one = {{"time_s", key.time_s}, {"pose", static_cast<const rig::Pose&>(key.pose)}};
    if (!key.name.empty()) one["name"] = key.name;
    if (!key.controls.usual()) one["controls"] = controls_to_json(key);
    keys.push_back(std::move(one));
  }
  return {{"keys", std::move(keys)}};
}

Problem read_timeline(const json::Json& project, const std::string& pointer, document::Document& out) {
  const json::Json* value = json::find(project, "timeline");
  if (value == nullptr) return std::nullopt;
  return read_keys(*value, json::child(pointer, "timeline"), out.model->rig->parameters(), out.timeline);
}

json::Json clips_to_json(const document::Document& document) {
  json::Json list = json::Json::array();
  // Animations that are left out of the file, because nothing is left of them.
  std::vector<bool> empty(document.model->animations.size());
  for (std::size_t i = 0; i < document.clips.size(); ++i) {
    const auto& animation = document.clips[i]->animation;
    if (animation) empty[*animation] = document::keys_of_clip(document, i).keys.empty();
  }
  for (std::size_t i = 0; i < document.clips.size(); ++i) {
    const document::Clip& clip = *document.clips[i];
    json::Json one = {{"name", clip.name}};
    if (clip.animation && !empty[*clip.animation]) {
      const auto here = empty.begin() + static_cast<std::ptrdiff_t>(*clip.animation);
      one["animation"] = *clip.animation - static_cast<std::size_t>(std::count(empty.begin(), here, true));
    }
    if (i != document.clip) one["timeline"] = timeline_to_json(*clip.timeline);
    if (clip.spoken) write_spoken(*clip.spoken, one);
    if (clip.bookmarks) one["bookmarks"] = bookmarks_to_json(*clip.bookmarks);
    list.push_back(std::move(one));
  }
  return list;
}

Problem read_clips(const json::Json& project, const std::string& pointer, document::Document& out) {
  const json::Json* value = json::find(project, "clips");
  if (value == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, "clips");
  if (!value->is_array() || value->empty() || value->size() > document::k_most_clips)
    return project_error("a list of clips was expected", here);
  std::optional<std::size_t> shown;
  std::set<std::size_t> animations;
  for (std::size_t i = 0; i < value->size(); ++i) {
    document::Clip clip;
    const std::string at = json::child(here, i);
    if (auto problem = read_clip((*value)[i], at, out, clip)) return problem;
    if (clip.animation && !animations.insert(*clip.animation).second)
      return project_error("an animation is a clip twice", json::child(at, "animation"));
    if (!clip.timeline && shown.has_value()) return project_error("keys were expected", json::child(at, "timeline"));
    if (!clip.timeline) shown = i;
    if (clip.animation) clip.opened = clip.timeline ? clip.timeline : out.timeline;
    out.clips.push_back(std::make_shared<const document::Clip>(std::move(clip)));
  }
  if (!shown) return project_error("one clip that is shown was expected", here);
  out.clip = *shown;
  return std::nullopt;
}

}  // namespace penpose::io
