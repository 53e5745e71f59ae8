#include <algorithm>

#include "tests/judges/drawing/drawing_measures.h"
#include "tests/judges/drawing/faces/drawing_sets.h"
#include "tests/judges/drawing/faces/face_reading.h"

namespace penpose::judges {
namespace {

using namespace drawn;

/// What of a set a measure looks at.
enum class Of : unsigned char { faces, faces_beside_rest, things };

bool is_of(Of of, const SharedDrawing& one) {
  if (of == Of::faces_beside_rest) return one.face && one.meant != Expression::rest;
  return one.face == (of == Of::faces);
}

Outcome outcome_of(FaceReading& reading, std::span<const SharedDrawing> set, const SharedDrawing& one, Of of) {
  auto drawing = one.drawing;
  const SharedDrawing* rest = of == Of::faces_beside_rest ? rest_by_the_same_hand(set, one) : nullptr;
  if (rest != nullptr) drawing.neutral = rest->drawing.lines;
  Outcome outcome = reading.outcome(drawing, one.meant, one.side);
  if (of == Of::things) outcome = as_thing(std::move(outcome));
  outcome.name = one.name;
  outcome.hand = one.folder;
  return outcome;
}

std::vector<Outcome> judge_set(const Rig& rig, Extent extent, Group group, Of of) {
  FaceReading& reading = reading_of(rig);
  const auto set = drawing_set(group);
  std::vector<const SharedDrawing*> looked_at;
  for (const SharedDrawing& one : set) {
    if (is_of(of, one)) looked_at.push_back(&one);
  }
  // A brief look takes four faces or one thing; which ones differs from rig to rig.
  const std::size_t apart = extent == Extent::whole ? 1 : looked_at.size() / (of == Of::things ? 1 : 4);
  std::vector<Outcome> out;
  for (std::size_t i = seed_of(rig.name, "set") % apart; i < looked_at.size(); i += apart) {
    Outcome outcome = outcome_of(reading, set, *looked_at[i], of);
    if (outcome.of > 0 || outcome.still) out.push_back(std::move(outcome));
  }
  return out;
}

/// One case in place of many, which nobody may look at one by one.
Outcome totals_of(std::span<const Outcome> outcomes) {
  Outcome total;
  total.name = total.hand = "held_out";
  const auto greater = [](std::optional<double>& most, const std::optional<double>& value) {
    if (value) most = std::max(most.value_or(0), *value);
  };
  for (const Outcome& one : outcomes) {
    total.right += one.right;
    total.nothing += one.nothing;
    total.of += one.of;
    total.ms += one.ms / static_cast<double>(outcomes.size());
    greater(total.stray, one.stray);
    greater(total.still, one.still);
  }
  return total;
}

template <Of of>
std::vector<Outcome> judge_people(const Rig& rig, Extent extent) {
  if (rig.group != Group::shared) return judge_set(rig, extent, rig.group, of);
  auto out = judge_set(rig, extent, Group::seen, of);
  out.push_back(totals_of(judge_set(rig, extent, Group::held_out, of)));
  return out;
}

}  // namespace

Measure people_measure() { return {"drawn_by_people", has_face, judge_people<Of::faces>}; }
Measure people_beside_rest_measure() { return {"drawn_by_people_rest", has_face, judge_people<Of::faces_beside_rest>}; }
Measure people_no_face_measure() { return {"no_faces_by_people", has_face, judge_people<Of::things>}; }

}  // namespace penpose::judges
