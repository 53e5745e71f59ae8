#include "tests/judges/drawing/known/known_judge.h"

#include <algorithm>
#include <cmath>

#include "tests/judges/drawing/curve_places.h"

namespace penpose::judges::drawn {

KnownVerdict judged(const JudgedFace& face, const rig::Pose& meant, const rig::Pose& found,
                    const KnownDrawing& drawing, std::span<const portrait::LineRead> lines) {
  // What moves by less of the farthest movement should not move.
  constexpr double k_moves = 0.02;
  const auto truth = positions_of(face.rig(), meant), got = positions_of(face.rig(), found);
  geometry::Box marks;
  for (const auto& line : places_of(face.marks, face.rest)) {
    for (const auto& p : line) marks.add(p);
  }
  const double most = largest_move(face.rest, truth), size = marks.diagonal();
  const bool still = most <= 1e-9 * size;
  double off = 0, way = 0;
  KnownVerdict out;
  for (std::size_t v = 0; v < truth.size(); ++v) {
    const double should = geometry::distance(truth[v], face.rest[v]), miss = geometry::distance(truth[v], got[v]);
    off += miss * miss;
    way += should * should;
    if (still || should <= k_moves * most)
      out.stray_percent = std::max(out.stray_percent, 100 * geometry::distance(got[v], face.rest[v]) / size);
  }
  if (!still) out.error_percent = 100 * std::sqrt(off / way);
  out.of = drawing.lines.size();
  for (std::size_t i = 0; i < std::min(out.of, lines.size()); ++i) {
    const auto& right = drawing.lines[i].right;
    if (lines[i].curve && std::find(right.begin(), right.end(), *lines[i].curve) != right.end()) ++out.right;
  }
  return out;
}

}  // namespace penpose::judges::drawn
