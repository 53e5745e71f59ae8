#include "core/document/commands/list/sound_commands.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/document/commands/apply_parts.h"
#include "core/document/commands/list/time_commands.h"
#include "core/document/time/timeline_editing.h"

namespace penpose::document {
namespace {

std::optional<base::Error> check_offset(double offset_s) {
  if (offset_s >= -k_latest_key_s && offset_s <= k_latest_key_s) return std::nullopt;
  return base::Error{"the sound would begin beyond the timeline", "offset_s", "give seconds from -36000 to 36000"};
}

base::Error no_sound() { return {"there is no sound", "", "open one first"}; }

std::optional<base::Error> check_values(const Document& document, const SetMouth& command) {
  const auto parameters = document.model->rig->parameters();
  std::vector<bool> named(parameters.size());
  for (const NamedValue& one : command.values) {
    const auto number = number_of(document, one.name, "values");
    if (!number) return number.error();
    if (named[*number]) return base::Error{"\"" + one.name + "\" is named twice", "values", "name it once"};
    named[*number] = true;
    if (auto error = out_of_range(parameters[*number], one.value)) return error;
  }
  return std::nullopt;
}

/// The keys that were made of mouths, as other mouths make them; those that somebody changed since stay. `document` has
/// the mouths as they were.
Document with_mouths(const Document& document, Mouths mouths) {
  Document changed = document;
  changed.mouths = std::move(mouths);
  if (!document.spoken || document.timeline->keys.empty()) return changed;
  const SpokenMouths& spoken = *document.spoken;
  const auto parameters = document.model->rig->parameters();
  const auto before = controls_of(document.mouths, spoken, parameters);
  const auto now = controls_of(changed.mouths, spoken, parameters);
  TimelineEditing keys(*document.timeline, parameters, document.pose);
  for (const SpokenMouth& one : spoken) {
    const Mouth* was = find_mouth(document.mouths, one.mouth);
    const Mouth* is = find_mouth(changed.mouths, one.mouth);
    const auto place = key_at(*document.timeline, one.time_s);
    if (was == nullptr || is == nullptr || !place) continue;
    const PoseKey& key = document.timeline->keys[*place];
    const std::vector<double> made = values_of(*was, before, parameters);
    bool as_made = true;
    for (std::size_t i = 0; i < before.size(); ++i)
      as_made = as_made && key.controls.has(before[i]) && key.pose[before[i]] == made[i];
    if (!as_made) continue;
    const std::vector<double> values = values_of(*is, now, parameters);
    for (std::size_t i = 0; i < now.size(); ++i) {
      const bool keyed = key.controls.has(now[i]);
      keys.set(one.time_s, now[i], values[i], keyed ? key.controls[now[i]] : ControlKey{});
    }
  }
  changed.timeline = std::make_shared<const Timeline>(std::move(keys).finish());
  // The pose in hand is that of the moment.
  if (document.pose == pose_at(document, document.time_s)) changed.pose = pose_at(changed, document.time_s);
  return changed;
}

}  // namespace

Changed run(const Document& document, const SetSound& command, Parts&) {
  if (command.file.empty() || command.file.size() > k_longest_sound_path)
    return base::Error{"the name of a file was expected", "file", "name a sound of at most 4096 bytes"};
  if (auto error = check_offset(command.offset_s)) return *error;
  Document changed = document;
  changed.sound =
      std::make_shared<const SoundReference>(SoundReference{command.file, command.content, command.offset_s});
  // What is said in another sound is not known.
  if (!document.sound || document.sound->content != command.content) changed.words = nullptr;
  return changed;
}

Changed run(const Document& document, const RemoveSound&, Parts&) {
  if (!document.sound) return no_sound();
  Document changed = document;
  changed.sound = nullptr;
  changed.words = nullptr;
  return changed;
}

Changed run(const Document& document, const MoveSound& command, Parts&) {
  if (!document.sound) return no_sound();
  if (auto error = check_offset(command.offset_s)) return *error;
  Document changed = document;
  changed.sound = std::make_shared<const SoundReference>(
      SoundReference{document.sound->file, document.sound->content, command.offset_s});
  return changed;
}

Changed run(const Document& document, const SetMouth& command, Parts&) {
  if (command.name.empty()) return base::Error{"a mouth needs a name", "name", "give one"};
  if (auto error = check_values(document, command)) return *error;
  Mouths mouths = document.mouths;
  const auto given = std::make_shared<const Mouth>(Mouth{command.name, command.values});
  std::shared_ptr<const Mouth> kept = mouths_of_rig({given}, document.model->rig->parameters()).front();
  for (auto& mouth : mouths) {
    if (mouth->name != command.name) continue;
    mouth = std::move(kept);
    return with_mouths(document, std::move(mouths));
  }
  if (mouths.size() >= k_most_mouths)
    return base::Error{"there are 100 mouths already", "name", "draw one of them again, or delete one"};
  mouths.push_back(std::move(kept));
  Document changed = document;
  changed.mouths = std::move(mouths);
  return changed;
}

Changed run(const Document& document, const DeleteMouth& command, Parts&) {
  Document changed = document;
  if (!erase_named(changed.mouths, command.name)) return base::Error{"there is no mouth of that name", "name", ""};
  if (!document.spoken) return changed;
  SpokenMouths spoken = *document.spoken;
  std::erase_if(spoken, [&](const SpokenMouth& one) { return one.mouth == command.name; });
  changed.spoken = spoken.empty() ? nullptr : std::make_shared<const SpokenMouths>(std::move(spoken));
  return changed;
}

Changed run(const Document& document, const KeyMouths& command, Parts& work) {
  if (command.mouths.empty() || command.mouths.size() != command.times_s.size())
    return base::Error{"there is not one mouth for each moment", "mouths", "name one a moment"};
  const auto parameters = document.model->rig->parameters();
  SpokenMouths spoken;
  for (std::size_t i = 0; i < command.mouths.size(); ++i) {
    if (find_mouth(document.mouths, command.mouths[i]) == nullptr)
      return base::Error{"there is no mouth \"" + command.mouths[i] + "\"", "mouths", "keep it first"};
    spoken.push_back({command.times_s[i], command.mouths[i]});
  }
  const auto controls = controls_of(document.mouths, spoken, parameters);
  if (controls.empty()) return base::Error{"these mouths move nothing", "mouths", "draw them first"};
  KeyPoses keys;
  for (const std::size_t number : controls) keys.names.push_back(parameters[number].name);
  keys.times_s = command.times_s;
  for (const SpokenMouth& one : spoken) {
    for (const double value : values_of(*find_mouth(document.mouths, one.mouth), controls, parameters))
      keys.values.push_back(value);
  }
  auto changed = run(document, keys, work);
  if (changed) changed->spoken = std::make_shared<const SpokenMouths>(std::move(spoken));
  return changed;
}

Changed run(const Document& document, const SetWords& command, Parts&) {
  if (!document.sound) return no_sound();
  if (command.words.size() != command.times_s.size())
    return base::Error{"there is not one word for each moment", "words", "name one a moment"};
  if (command.words.size() > k_most_words) return base::Error{"these are too many words", "words", "give 100000"};
  SpokenWords words;
  for (std::size_t i = 0; i < command.words.size(); ++i) {
    const double time_s = command.times_s[i];
    if (!(time_s >= 0 && time_s <= k_latest_key_s) || (i > 0 && time_s < command.times_s[i - 1]))
      return base::Error{"the moments of the words do not ascend from 0", "times_s", "give them in the order of time"};
    if (command.words[i].empty() || command.words[i].size() > k_longest_word)
      return base::Error{"a word is empty or too long", "words", "give 1 to 200 bytes each"};
    words.push_back({time_s, command.words[i]});
  }
  Document changed = document;
  changed.words = words.empty() ? nullptr : std::make_shared<const SpokenWords>(std::move(words));
  return changed;
}

}  // namespace penpose::document
