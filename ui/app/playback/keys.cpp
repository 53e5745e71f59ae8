#include "ui/app/playback/keys.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/document/time/timeline_editing.h"
#include "ui/app/playback/frames.h"
#include "ui/app/playback/sheet/mirrored_keys.h"

namespace penpose::app {
namespace {

constexpr double k_same_key_s = 1e-4;
constexpr double k_at_cursor_s = 1e-9;
/// So long a key shines that has just been set.
constexpr double k_shine_us = 900'000;

}  // namespace

Keys::Keys(EditingSession& editing, Notices& notices, Playback& playback)
    : editing_(editing), notices_(notices), playback_(playback) {}

void Keys::set() {
  if (editing_.perform(document::SetKey{playback_.time_s(), name_at(playback_.time_s())})) land(playback_.time_s());
}

void Keys::land(double time_s) {
  landed_s_ = time_s;
  landed_us_ = playback_.now_us();
  notices_.take_away([](const Notice& one) { return one.text == k_not_keyed_yet; });
}

double Keys::shine(double time_s) const {
  if (!landed_s_ || std::abs(*landed_s_ - time_s) >= k_at_cursor_s) return 0;
  return std::clamp(1 - static_cast<double>(playback_.now_us() - landed_us_) / k_shine_us, 0.0, 1.0);
}

void Keys::remove() {
  editing_.perform(document::DeleteKeys{meant()});
  selected_.clear();
}

document::OfKeys Keys::meant() const {
  if (!selected_.empty()) return selected_.of(editing_.document());
  return {{playback_.time_s()}, {}};
}

KeySelection& Keys::selected() {
  selected_.keep_known(editing_.document());
  return selected_;
}

void Keys::show_again() {
  editing_.shown().preview(std::nullopt);
  editing_.perform_with(document::GoToTime{playback_.time_s()});
}

void Keys::move_selected(double by_s, double about_s, double scale, bool copies) {
  if (selected().empty()) return;
  const auto rate = static_cast<std::uint32_t>(playback_.rate());
  const document::MoveKeys command{selected_.of(editing_.document()), by_s, about_s, scale, copies, rate};
  if (!editing_.perform(command)) return;
  follow(by_s, about_s, scale);
}

void Keys::shift_selected(double by_s, double share) {
  if (selected().empty()) return;
  const auto parameters = editing_.document().model->rig->parameters();
  document::SetKeyValues values{selected_.of(editing_.document()), {}};
  bool changes = false;
  for (const auto& [time_s, parameter] : selected_.keys()) {
    const rig::Parameter& range = parameters[parameter];
    const double was = find(time_s)->pose[parameter];
    const double value = was + share * (range.maximum - range.minimum);
    values.values.push_back(std::clamp(value, range.minimum, range.maximum));
    changes = changes || values.values.back() != was;
  }
  if (changes && !editing_.perform(values)) return;
  if (by_s == 0) {
    if (changes) show_again();
    return;
  }
  const auto rate = static_cast<std::uint32_t>(playback_.rate());
  const document::MoveKeys moves{selected_.of(editing_.document()), by_s, 0, 1, false, rate};
  if (!(changes ? editing_.perform_with(moves) : editing_.perform(moves))) return;
  follow(by_s, 0, 1);
}

void Keys::follow(double by_s, double about_s, double scale) {
  const KeySelection before = std::exchange(selected_, {});
  for (const auto& [time_s, parameter] : before.keys())
    selected_.add(on_frame(about_s + (time_s - about_s) * scale + by_s, playback_.rate()), parameter);
  show_again();
}

void Keys::pull_handle(const KeySelection::Key& key, bool incoming, double slope, bool alone) {
  const document::Document& document = editing_.document();
  const auto place = document::key_at(*document.timeline, key.first);
  if (!place) return;
  document::SetKeySlopes command{key.first, document.model->rig->parameters()[key.second].name, slope, slope};
  if (alone) {
    const document::ControlKey was = document::with_slopes(*document.timeline, *place, key.second);
    (incoming ? command.out : command.in) = incoming ? was.out : was.in;
  }
  if (editing_.perform(command)) show_again();
}

void Keys::set_kind(document::KeyKind kind) {
  const document::PoseKey* from = going_on();
  if (selected_.empty() && from == nullptr)
    return notices_.tell("there is no key here or before: go to one, or select keys in the sheet");
  const bool last = selected_.empty() && from == &editing_.document().timeline->keys.back();
  const document::OfKeys keys = any_meant() ? meant() : document::OfKeys{{from->time_s}, {}};
  if (editing_.perform(document::SetKeyKind{keys, kind})) show_again();
  if (last) notices_.tell("Nothing follows this key: how the face comes here is set at the key before");
}

const document::PoseKey* Keys::going_on() const {
  if (const auto* here = find(playback_.time_s())) return here;
  const document::PoseKey* before = nullptr;
  for (const document::PoseKey& key : editing_.document().timeline->keys) {
    if (key.time_s < playback_.time_s()) before = &key;
  }
  return before;
}

std::vector<document::KeyKind> Keys::kinds() const {
  std::vector<document::KeyKind> kinds;
  const document::Document& document = editing_.document();
  const auto add = [&](document::KeyKind one) {
    if (one != document::KeyKind::none && std::find(kinds.begin(), kinds.end(), one) == kinds.end())
      kinds.push_back(one);
  };
  for (const auto& [time_s, parameter] : selected_.keys()) {
    if (const auto place = document::key_at(*document.timeline, time_s))
      add(document.timeline->keys[*place].controls[parameter].kind);
  }
  if (!selected_.empty()) return kinds;
  const auto* here = going_on();
  for (std::size_t i = 0; here != nullptr && i < document.pose.size(); ++i) add(here->controls[i].kind);
  return kinds;
}

std::string Keys::said() const {
  if (selected_.size() == 1) return "the selected key";
  if (!selected_.empty()) return "the " + std::to_string(selected_.size()) + " selected keys";
  const auto* here = going_on();
  return here == nullptr ? std::string() : "the key at frame " + frame_text(here->time_s, playback_.rate());
}

document::Tween Keys::breakdown(double share) {
  document::Tween command{on_frame(playback_.time_s(), playback_.rate()), share, {}};
  const auto parameters = editing_.document().model->rig->parameters();
  for (const auto& key : selected().keys()) {
    const std::string& name = parameters[key.second].name;
    if (std::find(command.names.begin(), command.names.end(), name) == command.names.end())
      command.names.push_back(name);
  }
  return command;
}

void Keys::tween(double share) {
  const document::Tween command = breakdown(share);
  editing_.shown().preview(std::nullopt);
  if (!editing_.perform(command)) return;
  playback_.place_cursor(command.time_s);
  land(command.time_s);
  notices_.tell("keyed at frame " + frame_text(command.time_s, playback_.rate()) + ": " +
                std::to_string(static_cast<int>(std::lround(100 * share))) + " % of the way to the key after");
}

std::string Keys::tween_lacks() {
  const auto& keys = editing_.document().timeline->keys;
  const double now_s = playback_.time_s();
  const auto is_before = [&](const document::PoseKey& key) { return key.time_s < now_s - k_same_key_s; };
  const auto is_after = [&](const document::PoseKey& key) { return key.time_s > now_s + k_same_key_s; };
  const bool before = std::any_of(keys.begin(), keys.end(), is_before);
  const bool after = std::any_of(keys.begin(), keys.end(), is_after);
  if (!before && !after) return "Between needs two keys: key a pose, go to a later frame and key another one";
  if (!before) return "there is no key before this frame: go to a frame between two keys";
  if (!after) return "there is no key after this frame: go to a frame between two keys, or key a pose later";
  const auto made = editing_.after(breakdown(0.5));
  return made ? std::string() : made.error().line();
}

void Keys::preview_tween(double share) {
  if (auto after = editing_.after(breakdown(share))) editing_.shown().preview(after->pose);
}

bool Keys::at_cursor() const {
  const auto& keys = editing_.document().timeline->keys;
  return std::any_of(keys.begin(), keys.end(), [&](const document::PoseKey& key) {
    return std::abs(key.time_s - playback_.time_s()) < k_at_cursor_s;
  });
}

void Keys::copy() {
  clipboard_ = copied_pose(editing_.document(), playback_.time_s());
  carried_.emplace(editing_);
  notices_.tell("the pose is copied: go to another frame and paste");
}

void Keys::paste() {
  if (!clipboard_) return notices_.tell("there is no pose to paste: copy one first");
  if (carried_ && !carried_->fits(editing_.document()))
    return carried_->paste(editing_, notices_, clipboard_->name, playback_.time_s());
  paste_pose(editing_, *clipboard_, playback_.time_s());
}

void Keys::paste_mirrored() {
  if (!clipboard_) return notices_.tell("there is no pose to paste: copy one first");
  paste_pose(editing_, mirrored(editing_.document(), *clipboard_), playback_.time_s());
}

void Keys::mirror() {
  const document::Document& document = editing_.document();
  const auto exchanged = mirrored_keys(document, any_meant() ? meant() : document::OfKeys{});
  if (exchanged.empty()) return notices_.tell("both sides are the same: there is nothing to flip");
  bool first = true;
  for (const document::Command& one : exchanged) {
    if (!(first ? editing_.perform(one) : editing_.perform_with(one))) return;
    first = false;
  }
  show_again();
}

const document::PoseKey* Keys::find(double time_s) const {
  for (const auto& key : editing_.document().timeline->keys) {
    if (std::abs(key.time_s - time_s) < k_same_key_s) return &key;
  }
  return nullptr;
}

std::string Keys::name_at(double time_s) const {
  const auto* key = find(time_s);
  return key != nullptr ? key->name : std::string();
}

void Keys::name(const std::string& name) {
  const auto* key = find(playback_.time_s());
  if (key == nullptr) return;
  const document::SetKey named{key->time_s, name};
  // A key takes the pose as it is, and the name shall not change the pose.
  if (key->pose != document::SharedPose(editing_.document().pose)) editing_.perform(document::GoToTime{named.time_s});
  editing_.perform(named);
}

void Keys::move(double from_s, double to_s) {
  to_s = std::clamp(to_s, 0.0, document::k_latest_key_s);
  if (std::abs(from_s - to_s) < k_same_key_s) return;
  const auto rate = static_cast<std::uint32_t>(playback_.rate());
  if (!editing_.perform(document::MoveKeys{{{from_s}, {}}, to_s - from_s, 0, 1, false, rate})) return;
  playback_.place_cursor(to_s);
  editing_.shown().preview(std::nullopt);
  editing_.perform(document::GoToTime{to_s});
}

}  // namespace penpose::app
