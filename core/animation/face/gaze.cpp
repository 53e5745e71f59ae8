#include "core/animation/face/gaze.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>

#include "core/animation/signal/denoise.h"
#include "core/animation/signal/statistics.h"
#include "core/base/math.h"
#include "core/rig/control_names.h"

namespace penpose::animation {
namespace {

using geometry::ModelPoint;
using geometry::ModelVector;

/// The turn about its middle that best carries points to others, as an axis times an angle (small enough to add up), or
/// nothing where they do not go round together. Gauss-Newton on the turn, from none.
std::optional<glm::dvec3> turn_between(std::span<const glm::dvec3> from, std::span<const glm::dvec3> to) {
  glm::dvec3 middle_from(0);
  glm::dvec3 middle_to(0);
  const auto n = static_cast<double>(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    middle_from += from[i] / n;
    middle_to += to[i] / n;
  }
  glm::dmat3 squares(0);
  glm::dvec3 along(0);
  double way = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    // Half-way between both, the chord of a turn is the turn's own direction, times twice the tangent of half of it.
    const glm::dvec3 x = (from[i] - middle_from + to[i] - middle_to) * 0.5;
    const glm::dvec3 d = (to[i] - middle_to) - (from[i] - middle_from);
    squares += glm::dmat3(glm::dot(x, x)) - glm::outerProduct(x, x);
    along += glm::cross(x, d);
    way += glm::dot(d, d);
  }
  if (!(std::abs(glm::determinant(squares)) > 0) || !(way > 0)) return std::nullopt;
  const glm::dvec3 turn = glm::inverse(squares) * along;
  double left = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const glm::dvec3 x = (from[i] - middle_from + to[i] - middle_to) * 0.5;
    const glm::dvec3 d = (to[i] - middle_to) - (from[i] - middle_from) - glm::cross(turn, x);
    left += glm::dot(d, d);
  }
  constexpr double k_together = 0.05;  // of the squares
  if (left > k_together * way) return std::nullopt;
  const double length = std::sqrt(glm::dot(turn, turn));
  const double angle = 2 * base::atan2(0.5 * length, 1.0);
  return length > 0 ? std::optional(turn * (angle / length)) : std::nullopt;
}

/// The pieces of the mesh that may be eyeballs: small, of some vertices, near the lids of an eye.
std::vector<std::vector<std::uint32_t>> pieces_near(const std::vector<ModelPoint>& still,
                                                    std::span<const std::uint32_t> components, const ModelPoint& eye,
                                                    double width) {
  std::vector<std::vector<std::uint32_t>> all;
  for (std::uint32_t v = 0; v < components.size(); ++v) {
    if (components[v] >= all.size()) all.resize(components[v] + 1U);
    all[components[v]].push_back(v);
  }
  constexpr std::size_t k_least_vertices = 8;
  constexpr double k_widest = 2;  // of the lids' own width
  std::erase_if(all, [&](const std::vector<std::uint32_t>& piece) {
    if (piece.size() < k_least_vertices) return true;
    return std::any_of(piece.begin(), piece.end(),
                       [&](std::uint32_t v) { return geometry::distance(still[v], eye) > k_widest * width; });
  });
  return all;
}

/// ARKit's shapes of looks, by their names: on heads whose eyeballs they do not turn, or that have none.
std::vector<GazeControl> named_controls(const rig::Rig& rig, bool persons_left) {
  constexpr double k_full = 30 * base::k_pi / 180;  // as far as eyes go without the head
  struct Named {
    const char* left;
    const char* right;
    Gaze way;
  };
  constexpr std::array<Named, 4> k_names{{{"eyeLookOut_L", "eyeLookIn_R", {k_full, 0}},
                                          {"eyeLookIn_L", "eyeLookOut_R", {-k_full, 0}},
                                          {"eyeLookDown_L", "eyeLookDown_R", {0, k_full}},
                                          {"eyeLookUp_L", "eyeLookUp_R", {0, -k_full}}}};
  std::vector<GazeControl> controls;
  for (const Named& one : k_names) {
    for (const std::size_t p : rig::controls_named(rig.parameters(), persons_left ? one.left : one.right)) {
      controls.push_back({p, one.way});
    }
  }
  return controls;
}

struct Iris {
  std::size_t centre, one_corner, other_corner;
};
/// Of MediaPipe's mesh, the picture's left eye first.
constexpr std::array<Iris, 2> k_irises{{{468, 33, 133}, {473, 362, 263}}};
constexpr std::size_t k_points_with_irises = 478;

/// Where an iris looks on a head that stands so. Proportions of a grown person's eye: the ball is 24 mm wide, its
/// middle lies 5 mm behind the line between the corners, which are 29 mm apart.
std::optional<Gaze> gaze_of_iris(const TrackFrame& frame, const HeadTurn& turn, const Iris& iris) {
  const auto& p = frame.points;
  const PxPoint corners = p[iris.other_corner] - p[iris.one_corner];
  const auto& r = turn.rotation;
  // The line between the corners runs across the face.
  const double shown = std::sqrt(r[0][0] * r[0][0] + r[0][1] * r[0][1]);
  const double width = std::sqrt(corners.x * corners.x + corners.y * corners.y) / std::max(shown, 0.3);
  if (!(width > 0)) return std::nullopt;
  const double radius = 12.0 / 29.0 * width;
  const double behind = 5.0 / 29.0 * width;
  const PxPoint apart = p[iris.centre] - (p[iris.one_corner] + p[iris.other_corner]) * 0.5;
  const double x = (apart.x - r[2][0] * behind) / radius;
  const double y = (apart.y - r[2][1] * behind) / radius;
  const double square = x * x + y * y;
  constexpr double k_most = 0.9;
  const double shrink = square > k_most ? std::sqrt(k_most / square) : 1.0;
  const glm::dvec3 seen(x * shrink, y * shrink, -std::sqrt(1 - square * shrink * shrink));
  const glm::dvec3 own = glm::transpose(r) * seen;
  return Gaze{base::atan2(own.x, -own.z), base::atan2(own.y, -own.z)};
}

}  // namespace

std::vector<std::vector<GazeControl>> find_gaze_controls(const rig::Rig& rig, std::span<const double> rest,
                                                         std::span<const std::uint32_t> components,
                                                         const Transfer& transfer, std::span<const EyeCurves> eyes) {
  std::vector<std::vector<GazeControl>> controls(eyes.size());
  if (components.size() != rig.vertex_count()) return controls;
  std::vector<ModelPoint> still(rig.vertex_count());
  std::vector<ModelPoint> moved(rig.vertex_count());
  rig.evaluate(rest, still);
  geometry::Box box;
  for (const ModelPoint& p : still) box.add(p);
  std::vector<std::vector<std::vector<std::uint32_t>>> pieces;
  std::vector<double> places;
  for (const EyeCurves& eye : eyes) {
    geometry::Box lids;
    for (std::size_t i = 0; i < transfer.points.size(); ++i) {
      if (transfer.curve[i] != eye.one && transfer.curve[i] != eye.other) continue;
      ModelPoint p(0);
      for (std::size_t k = 0; k < 3; ++k) p += still[transfer.points[i].vertex[k]] * transfer.points[i].weight[k];
      lids.add(p);
    }
    places.push_back(lids.center().x);
    pieces.push_back(pieces_near(still, components, lids.center(), lids.diagonal()));
  }
  rig::Pose pose(rest.begin(), rest.end());
  for (std::size_t p = 0; p < pose.size(); ++p) {
    const rig::Parameter& range = rig.parameters()[p];
    // A joint is turned by a part of what it can: its angles add up only so far.
    constexpr double k_step = 0.5;
    const bool up = range.maximum - rest[p] >= rest[p] - range.minimum;
    const double step =
        up ? std::min(range.maximum - rest[p], 2 * k_step) : -std::min(rest[p] - range.minimum, 2 * k_step);
    if (step == 0) continue;
    pose[p] = rest[p] + step;
    rig.evaluate(pose, moved);
    pose[p] = rest[p];
    std::size_t away = 0;
    const double least = 1e-4 * box.diagonal();
    for (std::size_t v = 0; v < still.size(); ++v) away += geometry::distance(still[v], moved[v]) > least ? 1 : 0;
    constexpr double k_most_of_model = 0.4;
    if (away == 0 || static_cast<double>(away) > k_most_of_model * static_cast<double>(still.size())) continue;
    for (std::size_t e = 0; e < eyes.size(); ++e) {
      for (const auto& piece : pieces[e]) {
        std::vector<glm::dvec3> from;
        std::vector<glm::dvec3> to;
        for (const std::uint32_t v : piece) {
          from.emplace_back(still[v].x, still[v].y, still[v].z);
          to.emplace_back(moved[v].x, moved[v].y, moved[v].z);
        }
        const auto turn = turn_between(from, to);
        constexpr double k_least_turn = 0.03;  // radians
        if (!turn || !(std::sqrt(glm::dot(*turn, *turn)) > k_least_turn)) continue;
        // The eye looks along the model's z: a turn about y takes that to the picture's right, one about x down.
        controls[e].push_back({p, {turn->y / step, turn->x / step}});
        break;
      }
    }
  }
  for (std::size_t e = 0; e < eyes.size(); ++e) {
    const bool persons_left = std::all_of(places.begin(), places.end(), [&](double x) { return places[e] >= x; });
    if (controls[e].empty()) controls[e] = named_controls(rig, persons_left);
  }
  return controls;
}

std::vector<std::vector<Gaze>> gaze_of(const PointTrack& track, const StillTrack& still,
                                       std::span<const std::vector<double>> closed) {
  constexpr std::size_t k_eyes = 2;
  const std::size_t frames = track.frames.size();
  const bool irises = track.point_count == k_points_with_irises;
  std::vector<std::vector<double>> rows;
  std::vector<double> trust;
  std::size_t known = 0;
  std::vector<double> last(2 * k_eyes, 0.0);
  for (std::size_t f = 0; f < frames; ++f) {
    const TrackFrame& frame = track.frames[f];
    bool here = still.confidence[f] > 0;
    if (here && frame.says.gaze.size() == k_eyes) {
      for (std::size_t e = 0; e < k_eyes; ++e) {
        last[2 * e] = frame.says.gaze[e].right;
        last[2 * e + 1] = frame.says.gaze[e].down;
      }
    } else if (here && irises) {
      // Both eyes look alike; what each of them has of its own is its corners'.
      Gaze mean;
      for (const Iris& iris : k_irises) {
        const auto one = gaze_of_iris(frame, still.turns[f], iris);
        if (!one) continue;
        mean.right += one->right / k_eyes;
        mean.down += one->down / k_eyes;
      }
      last = {mean.right, mean.down, mean.right, mean.down};
    } else {
      here = false;
    }
    known += here ? 1 : 0;
    double most = 0;
    for (const auto& eye : closed) most = std::max(most, eye[f]);
    constexpr double k_hidden = 0.5;  // closed so far, an eye shows no gaze
    trust.push_back(here && most < k_hidden ? 1.0 : 0.0);
    rows.push_back(last);
  }
  if (2 * known < frames || frames < 3) return {};
  constexpr double k_strength = 2;
  std::vector<double> bends;
  for (std::size_t f = 1; f + 1 < frames; ++f) bends.push_back(rows[f - 1][0] - 2 * rows[f][0] + rows[f + 1][0]);
  const double tremor = spread(bends) / std::sqrt(6.0);
  denoise_rows(trust, k_strength * std::max(tremor, 1e-4), rows);
  std::vector<std::vector<Gaze>> gaze(k_eyes);
  for (const auto& row : rows) {
    for (std::size_t e = 0; e < k_eyes; ++e) gaze[e].push_back({row[2 * e], row[2 * e + 1]});
  }
  return gaze;
}

void look(const rig::Rig& rig, std::span<const double> rest, std::span<const GazeControl> controls, const Gaze& gaze,
          std::span<double> pose) {
  constexpr int k_sweeps = 50;
  for (const GazeControl& one : controls) pose[one.parameter] = rest[one.parameter];
  double right = gaze.right;
  double down = gaze.down;
  for (int sweep = 0; sweep < k_sweeps; ++sweep) {
    for (const GazeControl& one : controls) {
      const Gaze& unit = one.a_unit;
      const double square = unit.right * unit.right + unit.down * unit.down;
      const rig::Parameter& range = rig.parameters()[one.parameter];
      double& value = pose[one.parameter];
      const double to =
          std::clamp(value + (unit.right * right + unit.down * down) / square, range.minimum, range.maximum);
      right -= (to - value) * unit.right;
      down -= (to - value) * unit.down;
      value = to;
    }
  }
}

}  // namespace penpose::animation
