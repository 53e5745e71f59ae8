#include "ui/app/key_map.h"

#include <algorithm>

namespace penpose::app {
namespace {

ActionKeys own_keys(const ActionInfo& one) { return {one.key, one.other}; }

bool has(const ActionKeys& keys, const KeyStroke& key) {
  return key.key != 0 && std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// The first one is shown, so it is there where one is.
ActionKeys in_order(ActionKeys keys) {
  if (keys[1] == keys[0]) keys[1] = {};
  if (keys[0].key == 0) std::swap(keys[0], keys[1]);
  return keys;
}

const ActionInfo* action_called(std::string_view name) {
  const auto all = all_actions();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const ActionInfo& one) { return one.action.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

ActionKeys KeyMap::keys_of(Action action) const {
  const auto chosen = chosen_.find(action.name);
  return chosen != chosen_.end() ? chosen->second : own_keys(info(action));
}

const ActionInfo* KeyMap::action_of(const KeyStroke& pressed) const {
  const KeyStroke key = as_actions_name(pressed);
  for (const ActionInfo& one : all_actions()) {
    if (has(keys_of(one.action), key)) return &one;
  }
  return nullptr;
}

std::string KeyMap::shortcut_of(Action action) const { return shortcut_text(keys_of(action)[0]); }

std::string KeyMap::tooltip_of(Action action) const {
  const std::string key = shortcut_of(action);
  return std::string(info(action).tip) + (key.empty() ? "" : " (" + key + ")");
}

bool KeyMap::fixed(Action action) {
  const ActionKeys keys = own_keys(info(action));
  return std::any_of(keys.begin(), keys.end(), is_reserved);
}

void KeyMap::keep(Action action, ActionKeys keys) {
  keys = in_order(keys);
  if (keys == own_keys(info(action))) {
    chosen_.erase(std::string(action.name));
  } else {
    chosen_[std::string(action.name)] = keys;
  }
}

void KeyMap::take_away(const KeyStroke& key, Action except) {
  for (const ActionInfo& one : all_actions()) {
    ActionKeys keys = keys_of(one.action);
    if (one.action == except || !has(keys, key)) continue;
    std::replace(keys.begin(), keys.end(), key, KeyStroke());
    keep(one.action, keys);
  }
}

void KeyMap::set(Action action, std::size_t place, const KeyStroke& key) {
  ActionKeys keys = keys_of(action);
  std::replace(keys.begin(), keys.end(), key, KeyStroke());
  keys[place] = key;
  if (key.key != 0) take_away(key, action);
  keep(action, keys);
}

void KeyMap::reset(Action action) {
  for (const KeyStroke& key : own_keys(info(action))) take_away(key, action);
  chosen_.erase(std::string(action.name));
}

std::vector<std::string> KeyMap::lines() const {
  std::vector<std::string> lines;
  for (const auto& [name, keys] : chosen_) {
    std::string line = name;
    for (const KeyStroke& key : keys) {
      if (key.key != 0) line.append("|").append(shortcut_text(key));
    }
    lines.push_back(line);
  }
  return lines;
}

base::Status KeyMap::take(std::string_view line) {
  const std::string_view name = line.substr(0, line.find('|'));
  const ActionInfo* action = action_called(name);
  if (action == nullptr) return base::Error{"no action is called that", "", ""};
  if (fixed(action->action)) return base::Error{"its keys stay what they are", "", ""};
  if (chosen_.contains(name)) return base::Error{"another line sets its keys", "", ""};
  ActionKeys keys;
  std::size_t count = 0;
  for (std::string_view rest = line.substr(name.size()); !rest.empty();) {
    rest.remove_prefix(1);
    const std::string_view text = rest.substr(0, rest.find('|'));
    rest.remove_prefix(text.size());
    const auto key = parse_shortcut(text);
    if (!key) return base::Error{"a key is written as Ctrl+Shift+Z", "", ""};
    if (count == keys.size()) return base::Error{"an action has two keys at most", "", ""};
    if (is_reserved(*key)) return base::Error{"Esc and Return stay what they are", "", ""};
    for (const auto& [other, chosen] : chosen_) {
      if (other != name && has(chosen, *key)) return base::Error{"another line gives that key to " + other, "", ""};
    }
    keys[count++] = as_actions_name(*key);
  }
  keep(action->action, keys);
  return base::Done{};
}

void KeyMap::settle() {
  const auto chosen = chosen_;
  for (const auto& [name, keys] : chosen) {
    for (const KeyStroke& key : keys) {
      if (key.key != 0) take_away(key, Action{name});
    }
  }
}

}  // namespace penpose::app
