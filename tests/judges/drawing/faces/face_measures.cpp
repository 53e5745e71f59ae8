#include <cstdio>
#include <cstdlib>

#include "tests/judges/drawing/drawing_measures.h"
#include "tests/judges/drawing/faces/artist.h"
#include "tests/judges/drawing/faces/face_reading.h"
#include "tests/judges/drawing/faces/no_faces.h"
#include "tests/judges/drawing/faces/shared_drawings.h"
#include "tests/support/shared_data.h"

namespace penpose::judges {
namespace {

using namespace drawn;

/// An expression, of either side where it has one.
struct Meant {
  Expression expression;
  std::optional<Side> side;
};
std::vector<Meant> all_meant() {
  std::vector<Meant> all;
  for (std::size_t e = 0; e < k_expression_count; ++e) {
    const auto expression = static_cast<Expression>(e);
    if (!is_drawn(expression)) continue;
    if (has_side(expression)) {
      all.push_back({expression, Side::left});
      all.push_back({expression, Side::right});
    } else {
      all.push_back({expression, std::nullopt});
    }
  }
  return all;
}

std::vector<Outcome> judge_faces(const Rig& rig, Extent extent) {
  FaceReading& reading = reading_of(rig);
  const auto artists = artists_for(rig.group);
  const auto meant = all_meant();
  std::vector<Outcome> out;
  for (std::size_t m = 0; m < meant.size(); ++m) {
    for (std::size_t a = 0; a < artists.size(); ++a) {
      // A brief look takes every fifth, each by one artist; which ones differs from rig to rig.
      const std::size_t turn = seed_of(rig.name, "turn") % 64;
      if (extent == Extent::brief && ((m + turn) % 5 != 0 || a != (m / 5 + turn) % artists.size())) continue;
      std::string name = expression_name(meant[m].expression);
      if (meant[m].side) name += *meant[m].side == Side::left ? "_L" : "_R";
      const auto drawing = drawn_face(artists[a], meant[m].expression, meant[m].side,
                                      seed_of(artists[a].name, name, seed_of(rig.name, "")));
      Outcome one = reading.outcome(drawing, meant[m].expression, meant[m].side);
      one.name = name;
      one.hand = artists[a].name;
      if (one.of > 0 || one.still) out.push_back(std::move(one));
    }
  }
  return out;
}

std::vector<Outcome> judge_things(const Rig& rig, Extent extent) {
  FaceReading& reading = reading_of(rig);
  std::vector<Outcome> out;
  const std::size_t first = seed_of(rig.name, "things") % no_faces().size();
  for (std::size_t t = 0; t < no_faces().size(); ++t) {
    if (extent == Extent::brief && t != first) continue;
    const NoFace& thing = no_faces()[t];
    out.push_back(as_thing(reading.outcome(drawn_thing(thing, seed_of(rig.name, thing.name)), Expression::rest, {})));
    out.back().name = thing.name;
  }
  return out;
}

std::vector<Outcome> judge_shared(const Rig& rig, Extent) {
  FaceReading& reading = reading_of(rig);
  std::vector<Outcome> out;
  const auto drawings = shared_drawings(tests::shared_dir() / "drawings");
  if (!drawings) {
    std::fprintf(stderr, "%s\n", drawings.error().line().c_str());
    std::abort();
  }
  for (const SharedDrawing& one : *drawings) {
    Outcome outcome = reading.outcome(one.drawing, one.meant, one.side);
    if (!one.face) outcome = as_thing(std::move(outcome));
    outcome.name = one.name;
    outcome.hand = one.folder;
    if (outcome.of > 0 || outcome.still) out.push_back(std::move(outcome));
  }
  return out;
}

}  // namespace

Measure drawn_face_measure() { return {"drawn_faces", has_face, judge_faces}; }
Measure shared_drawing_measure() {
  return {"shared_drawings", [](const Rig& rig) { return rig.group == Group::shared && has_face(rig); }, judge_shared};
}
std::vector<Measure> drawing_measures() {
  auto all = known_drawing_measures();
  all.insert(all.end(), {drawn_face_measure(), no_face_measure(), people_measure(), people_beside_rest_measure(),
                         people_no_face_measure(), shared_drawing_measure()});
  return all;
}
Measure no_face_measure() { return {"no_faces", has_face, judge_things}; }

}  // namespace penpose::judges
