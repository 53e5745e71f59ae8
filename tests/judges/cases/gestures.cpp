#include "tests/judges/cases/gestures.h"

#include <algorithm>
#include <array>

#include "tests/judges/cases/gesture_list.h"
#include "tests/judges/rigs/control_words.h"

namespace penpose::judges {
namespace {

/// Muscles that are meant, as controls of the rig that do nothing beyond what is needed and accepted.
struct Meant {
  std::vector<std::vector<std::string>> needed;
  std::vector<std::string> accepted;
};

/// Muscles that a control moves beyond those that are needed.
std::size_t beyond(const Meaning& meaning, const GestureKind& kind) {
  return static_cast<std::size_t>(std::count_if(meaning.means.begin(), meaning.means.end(), [&](const std::string& m) {
    return std::none_of(kind.needed.begin(), kind.needed.end(), [&](const auto& group) { return has(group, m); });
  }));
}

/// Whether the rig has a control that does what is needed and nothing beside it, where this one does more: then that
/// one is meant.
bool has_purer(const Rig& rig, const Meaning& meaning, const GestureKind& kind, const std::vector<std::string>& group) {
  return beyond(meaning, kind) > 0 && std::any_of(rig.meanings.begin(), rig.meanings.end(), [&](const Meaning& other) {
           return beyond(other, kind) == 0 &&
                  std::any_of(other.means.begin(), other.means.end(), [&](const auto& m) { return has(group, m); });
         });
}

Meant meant_on(const Rig& rig, const GestureKind& kind) {
  std::vector<std::string> allowed = kind.accepted;
  for (const auto& group : kind.needed) allowed.insert(allowed.end(), group.begin(), group.end());
  Meant meant;
  meant.needed.resize(kind.needed.size());
  for (const Meaning& meaning : rig.meanings) {
    // What a joint does depends on which way it turns, so that one word that is meant is enough.
    const bool turns = rig::find_parameter(rig.model.rig->parameters(), meaning.control + ".rx").has_value();
    const bool fits = !meaning.means.empty() && (turns || std::all_of(meaning.means.begin(), meaning.means.end(),
                                                                      [&](const auto& m) { return has(allowed, m); }));
    if (!fits) continue;
    bool needed = false;
    for (std::size_t g = 0; g < kind.needed.size(); ++g) {
      const bool in = std::any_of(meaning.means.begin(), meaning.means.end(),
                                  [&](const auto& m) { return has(kind.needed[g], m); });
      if (in && (turns || !has_purer(rig, meaning, kind, kind.needed[g]))) meant.needed[g].push_back(meaning.control);
      needed = needed || in;
    }
    const bool helps =
        std::any_of(meaning.means.begin(), meaning.means.end(), [&](const auto& m) { return has(kind.accepted, m); });
    if (!needed && helps) meant.accepted.push_back(meaning.control);
  }
  return meant;
}

/// Whether some control of the rig moves this part of the face at all.
bool moves_brows(const Rig& rig) {
  return std::any_of(rig.meanings.begin(), rig.meanings.end(), [](const Meaning& meaning) {
    return std::any_of(meaning.means.begin(), meaning.means.end(),
                       [](const std::string& m) { return m.starts_with("brow_"); });
  });
}

std::vector<PxPoint> bent(const GestureKind::Line& line, const std::vector<PxPoint>& rest,
                          const std::vector<PxPoint>& towards, PxPoint middle, double half) {
  std::vector<PxPoint> out;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(rest.size() - 1);
    if (line.bend) {
      out.push_back(line.bend(rest[i], s, std::clamp((rest[i].x - middle.x) / half, -1.0, 1.0), half));
    } else {
      out.push_back(rest[i] + (towards[i] - rest[i]) * line.share);
    }
  }
  return out;
}

}  // namespace

GestureArtist::GestureArtist(const Rig& rig)
    : rig_(rig),
      rest_(posed(rig.model, rig::rest_pose(*rig.model.rig))),
      picture_(rig.model.front_yaw_degrees, size_of(rest_, rig.lines)),
      moves_brows_(moves_brows(rig)) {
  const auto lip = picture_.flat(rest_, rig.line("lip_upper")->vertices);
  middle_ = (lip.front() + lip.back()) * 0.5;
  half_ = 0.5 * geometry::distance(lip.front(), lip.back());
}

std::optional<Gesture> GestureArtist::meant(const GestureKind& kind) const {
  Meant meant = meant_on(rig_, kind);
  const bool can = std::none_of(meant.needed.begin(), meant.needed.end(), [](const auto& g) { return g.empty(); });
  const bool cannot = kind.lines.front().name.starts_with("brow") && !moves_brows_;
  if (!can && !cannot) return {};
  Gesture gesture;
  gesture.needed = std::move(meant.needed);
  gesture.accepted = std::move(meant.accepted);
  gesture.still_is_right = cannot;
  if (cannot) gesture.needed.clear();
  return gesture;
}

void GestureArtist::draw(Gesture& gesture, const GestureKind& kind, const Hand& hand, std::string name) const {
  const auto flat = [&](const std::string& line) { return picture_.flat(rest_, rig_.line(line)->vertices); };
  gesture.asked.name = std::move(name);
  gesture.asked.view_yaw_degrees = rig_.model.front_yaw_degrees;
  gesture.hand = hand.name;
  for (const GestureKind::Line& line : kind.lines) {
    const auto& vertices = rig_.line(line.name)->vertices;
    std::vector<PxPoint> towards;
    if (!line.towards.empty()) towards = resampled(flat(line.towards), vertices.size());
    const auto drawn = drawn_by(hand, bent(line, flat(line.name), towards, middle_, half_),
                                seed_of(rig_.name, gesture.asked.name + line.name));
    gesture.asked.references.push_back({line.name, vertices, picture_.in_space(drawn, rest_, vertices), {}});
  }
}

std::vector<Gesture> gestures(const Rig& rig, Extent extent) {
  const GestureArtist artist(rig);
  std::vector<Gesture> all;
  std::size_t number = 0;
  for (const GestureKind& kind : gesture_kinds()) {
    const auto meant = artist.meant(kind);
    if (!meant) continue;
    ++number;
    std::vector<const char*> hands{"tremor_1", "tremor_2", "uneven", "ends", "backwards"};
    if (extent == Extent::brief) hands = {hands[number % hands.size()]};
    for (const char* called : hands) {
      Gesture gesture = *meant;
      artist.draw(gesture, kind, hand_named(called), kind.name + "/" + called);
      all.push_back(std::move(gesture));
    }
  }
  return all;
}

}  // namespace penpose::judges
