#include "core/io/project/internal/project_view.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/document/commands/apply.h"
#include "core/document/commands/command_text.h"

namespace penpose::io {
namespace {

using document::Document;

Problem read_view_key(const json::Json& view, const std::string& pointer, const Document& document,
                      std::uint32_t& out) {
  const json::Json* value = json::find(view, "key");
  if (value == nullptr) return std::nullopt;
  const auto number = json::number(*value);
  for (std::uint32_t key = 1; key <= document::k_view_keys; ++key) {
    if (number && *number == key) out = key;
  }
  const bool again =
      std::any_of(document.views.begin(), document.views.end(), [&](const auto& one) { return one->key == out; });
  if (out == 0 || again) return project_error("a key of its own was expected, 1 to 9", json::child(pointer, "key"));
  return std::nullopt;
}

Problem read_views(const json::Json& project, const std::string& pointer, Document& out) {
  const json::Json* views = json::find(project, "views");
  if (views == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, "views");
  if (!views->is_array() || views->size() > k_most_curves) return project_error("a list of views was expected", here);
  for (std::size_t i = 0; i < views->size(); ++i) {
    const std::string at = json::child(here, i);
    document::NamedView named;
    const json::Json* name = json::find((*views)[i], "name");
    if (name == nullptr || !name->is_string()) return project_error("a name was expected", json::child(at, "name"));
    named.name = name->get<std::string>();
    const bool again =
        std::any_of(out.views.begin(), out.views.end(), [&](const auto& one) { return one->name == named.name; });
    if (named.name.empty() || again) return project_error("a name of its own was expected", json::child(at, "name"));
    if (auto problem = read_view((*views)[i], at, named.view)) return problem;
    if (auto problem = read_view_key((*views)[i], at, out, named.key)) return problem;
    out.views.push_back(std::make_shared<const document::NamedView>(std::move(named)));
  }
  return std::nullopt;
}

base::Result<document::Command> command_of(const json::Json& text) {
  return document::parse_command(text.is_string() ? text.get<std::string>() : std::string());
}

Problem read_camera_track(const json::Json& project, const std::string& pointer, Document& out) {
  const json::Json* keys = json::find(project, "camera");
  if (keys == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, "camera");
  if (!keys->is_array() || keys->empty() || keys->size() > document::k_most_camera_keys)
    return project_error("a list of keys of the camera was expected", here);
  document::CameraTrack track;
  for (std::size_t i = 0; i < keys->size(); ++i) {
    const auto command = command_of((*keys)[i]);
    if (!command) return project_error(command.error().what, json::child(here, i));
    const auto* key = command->get_if<document::KeyCamera>();
    const bool fits = key != nullptr && document::is_camera_kind(key->kind) && key->time_s >= 0 &&
                      key->time_s <= document::k_latest_key_s &&
                      geometry::Camera::make(key->view.camera, key->view.viewport).ok();
    if (!fits || (!track.keys.empty() && key->time_s <= track.keys.back().time_s))
      return project_error("keys of the camera were expected that ascend from 0", json::child(here, i));
    track.keys.push_back({key->time_s, key->view, key->kind});
  }
  out.camera = std::make_shared<const document::CameraTrack>(std::move(track));
  return std::nullopt;
}

Problem read_reference(const json::Json& project, const std::string& pointer, Document& out) {
  const json::Json* value = json::find(project, "reference");
  if (value == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, "reference");
  const auto command = command_of(*value);
  if (!command) return project_error(command.error().what, here);
  if (!command->holds<document::SetReference>()) return project_error("a reference was expected", here);
  document::ApplyWorkspace work;
  auto changed = document::apply(out, *command, work);
  if (!changed) return project_error(changed.error().what, here);
  out = std::move(changed).value();
  return std::nullopt;
}

}  // namespace

Problem read_project_views(const json::Json& project, const std::string& pointer, Document& out) {
  for (const auto read : {read_views, read_camera_track, read_reference}) {
    if (auto problem = read(project, pointer, out)) return problem;
  }
  return std::nullopt;
}

void write_project_views(const Document& document, json::Json& project) {
  json::Json views = json::Json::array();
  for (const auto& named : document.views) {
    json::Json one = {{"name", named->name}, {"view", document::to_text(named->view)}};
    if (named->key != 0) one["key"] = named->key;
    views.push_back(std::move(one));
  }
  project["views"] = std::move(views);
  if (document.camera) {
    json::Json keys = json::Json::array();
    for (const document::CameraKey& key : document.camera->keys)
      keys.push_back(document::to_text(document::KeyCamera{key.time_s, key.view, key.kind}));
    project["camera"] = std::move(keys);
  }
  if (document.reference) project["reference"] = document::to_text(document::SetReference{*document.reference});
}

}  // namespace penpose::io
