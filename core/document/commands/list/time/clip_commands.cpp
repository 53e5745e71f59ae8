#include "core/document/commands/list/time/clip_commands.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/document/commands/apply_parts.h"
#include "core/document/time/clips/animation_keys.h"
#include "core/document/time/timeline_editing.h"

namespace penpose::document {
namespace {

using ClipPointer = std::shared_ptr<const Clip>;

/// With the shown timeline in the list, which it is not where it is the only one.
Document listed(const Document& document) {
  Document changed = document;
  if (changed.clips.empty()) {
    changed.clips.push_back(std::make_shared<const Clip>(Clip{k_timeline_name}));
    changed.clip = 0;
  }
  return changed;
}

/// Puts the keys of the shown clip into the list.
void put_away(Document& document) {
  Clip shown = *document.clips[document.clip];
  shown.timeline = document.timeline;
  shown.spoken = document.spoken;
  shown.bookmarks = document.bookmarks;
  document.clips[document.clip] = std::make_shared<const Clip>(std::move(shown));
}

/// Shows a clip of the list, whose keys the document then has.
void take_out(Document& document, std::size_t number) {
  Clip shown = *document.clips[number];
  document.timeline = std::exchange(shown.timeline, nullptr);
  document.spoken = std::exchange(shown.spoken, nullptr);
  document.bookmarks = std::exchange(shown.bookmarks, nullptr);
  document.clips[number] = std::make_shared<const Clip>(std::move(shown));
  document.clip = number;
  document.pose = pose_at(document, document.time_s);
  document.moment = nullptr;
}

Document shown(Document document, std::size_t number) {
  put_away(document);
  take_out(document, number);
  return document;
}

Document with_added(Document document, Clip clip) {
  const std::size_t number = document.clip + 1;
  document.clips.insert(document.clips.begin() + static_cast<std::ptrdiff_t>(number),
                        std::make_shared<const Clip>(std::move(clip)));
  return shown(std::move(document), number);
}

std::optional<base::Error> check_room(const Document& document) {
  if (document.clips.size() < k_most_clips) return std::nullopt;
  return base::Error{"there are 1000 clips already", "", "delete one"};
}

std::optional<base::Error> check_name(const Document& document, const std::string& name) {
  if (name.empty()) return base::Error{"a clip needs a name", "name", "give one"};
  const bool of_clip = std::any_of(document.clips.begin(), document.clips.end(),
                                   [&](const ClipPointer& one) { return one->name == name; });
  const auto& animations = document.model->animations;
  const bool of_animation =
      std::any_of(animations.begin(), animations.end(), [&](const Animation& one) { return one.name == name; });
  if (of_clip || of_animation) return base::Error{"\"" + name + "\" is taken", "name", "give another name"};
  return std::nullopt;
}

void without_animation(Document& document, std::size_t number) {
  Model model = *document.model;
  model.animations.erase(model.animations.begin() + static_cast<std::ptrdiff_t>(number));
  document.model = std::make_shared<const Model>(std::move(model));
  for (ClipPointer& clip : document.clips) {
    if (!clip->animation || *clip->animation < number) continue;
    Clip later = *clip;
    later.animation = *clip->animation - 1;
    clip = std::make_shared<const Clip>(std::move(later));
  }
}

}  // namespace

Changed run(const Document& document, const OpenClip& command, Parts&) {
  const auto& animations = document.model->animations;
  const std::size_t number = command.animation;
  if (number >= animations.size()) return base::Error{"there is no such animation", "animation", "count from 0"};
  const bool open = std::any_of(document.clips.begin(), document.clips.end(),
                                [&](const ClipPointer& one) { return one->animation == number; });
  if (open) return base::Error{"it is open already", "animation", "show its clip"};
  if (auto error = check_room(document)) return *error;
  auto keys = keys_of(*document.model, animations[number]);
  if (!keys) return keys.error();
  const auto timeline = std::make_shared<const Timeline>(std::move(*keys));
  Clip clip{animations[number].name, number, timeline, timeline};
  if (!document.clips.empty() || !document.timeline->keys.empty()) return with_added(listed(document), std::move(clip));
  Document changed = document;
  changed.clips = {std::make_shared<const Clip>(std::move(clip))};
  take_out(changed, 0);
  return changed;
}

Changed run(const Document& document, const ShowClip& command, Parts&) {
  if (command.clip >= document.clips.size()) return base::Error{"there is no such clip", "clip", "count from 0"};
  if (command.clip == document.clip) return document;
  return shown(document, command.clip);
}

Changed run(const Document& document, const AddClip& command, Parts&) {
  if (auto error = check_room(document)) return *error;
  Document changed = listed(document);
  if (auto error = check_name(changed, command.name)) return *error;
  Clip clip{command.name};
  clip.timeline = command.copies ? document.timeline : std::make_shared<const Timeline>();
  if (command.copies) {
    clip.spoken = document.spoken;
    clip.bookmarks = document.bookmarks;
  }
  return with_added(std::move(changed), std::move(clip));
}

Changed run(const Document& document, const NameClip& command, Parts&) {
  Document changed = listed(document);
  if (changed.clips[changed.clip]->name == command.name) return changed;
  if (auto error = check_name(changed, command.name)) return *error;
  Clip clip = *changed.clips[changed.clip];
  clip.name = command.name;
  changed.clips[changed.clip] = std::make_shared<const Clip>(std::move(clip));
  return changed;
}

Changed run(const Document& document, const DeleteClip&, Parts&) {
  if (document.clips.size() < 2) return base::Error{"there is one clip only", "", "delete its keys"};
  Document changed = document;
  const std::size_t number = document.clip;
  const auto animation = document.clips[number]->animation;
  take_out(changed, number > 0 ? number - 1 : 1);
  changed.clips.erase(changed.clips.begin() + static_cast<std::ptrdiff_t>(number));
  changed.clip = number > 0 ? number - 1 : 0;
  if (animation) without_animation(changed, *animation);
  return changed;
}

Changed run(const Document& document, const TrimClip& command, Parts&) {
  if (!(command.from_s >= 0 && command.to_s > command.from_s && command.to_s <= k_latest_key_s))
    return base::Error{"there is no span to cut it to", "to_s", "give a later moment than from_s, up to 36000"};
  if (document.timeline->keys.empty()) return base::Error{"the clip has no keys", "", "set some first"};
  Document changed = document;
  changed.timeline = std::make_shared<const Timeline>(
      trimmed(*document.timeline, document.model->rig->parameters(), command.from_s, command.to_s));
  if (document.spoken) {
    SpokenMouths spoken;
    for (const SpokenMouth& one : *document.spoken) {
      if (one.time_s >= command.from_s && one.time_s <= command.to_s)
        spoken.push_back({one.time_s - command.from_s, one.mouth});
    }
    changed.spoken = spoken.empty() ? nullptr : std::make_shared<const SpokenMouths>(std::move(spoken));
  }
  if (document.bookmarks) {
    Bookmarks bookmarks;
    for (const Bookmark& one : *document.bookmarks) {
      if (one.time_s >= command.from_s && one.time_s <= command.to_s)
        bookmarks.push_back({one.time_s - command.from_s, one.name, one.color});
    }
    changed.bookmarks = shared_bookmarks(std::move(bookmarks));
  }
  changed.time_s = std::clamp(document.time_s - command.from_s, 0.0, command.to_s - command.from_s);
  changed.pose = pose_at(changed, changed.time_s);
  changed.moment = nullptr;
  return changed;
}

}  // namespace penpose::document
