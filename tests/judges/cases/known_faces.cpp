#include "tests/judges/cases/known_faces.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

#include "tests/judges/cases/picture.h"
#include "tests/judges/hands/hand.h"

namespace penpose::judges {
namespace {

/// A line that moves less is not drawn anew, px of a face of 800.
constexpr double k_moves_px = 6;
constexpr std::size_t k_most_lines = 6;
constexpr std::array<const char*, 8> k_drawn{"lip_upper",      "lip_lower",      "brow_L",         "brow_R",
                                             "eyelid_upper_L", "eyelid_upper_R", "eyelid_lower_L", "eyelid_lower_R"};

double farthest(const std::vector<PxPoint>& a, const std::vector<PxPoint>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, geometry::distance(a[i], b[i]));
  return most;
}

struct Artist {
  const Rig& rig;
  std::vector<ModelPoint> rest;
  double size;

  explicit Artist(const Rig& of)
      : rig(of), rest(posed(of.model, rig::rest_pose(*of.model.rig))), size(size_of(rest, of.lines)) {}

  /// The names of the lines that a pose moves.
  [[nodiscard]] std::vector<std::string> moved(const std::vector<ModelPoint>& places, const Picture& picture) const {
    std::vector<std::pair<double, std::string>> found;
    for (const char* name : k_drawn) {
      const FaceLine* line = rig.line(name);
      if (!line) continue;
      const double way = farthest(picture.flat(rest, line->vertices), picture.flat(places, line->vertices));
      if (way >= k_moves_px) found.emplace_back(way, name);
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<std::string> names;
    for (const auto& [way, name] : found) {
      if (names.size() < k_most_lines) names.push_back(name);
    }
    return names;
  }

  /// The values of a pose that some line shows: who cannot see what a control does cannot mean it.
  [[nodiscard]] std::vector<std::pair<std::string, double>> shown(const KnownPose& pose, const Picture& picture) const {
    std::vector<std::pair<std::string, double>> values;
    for (const auto& value : pose.values) {
      const auto places = posed(rig.model, pose_of(*rig.model.rig, {value}));
      const bool seen = std::any_of(k_drawn.begin(), k_drawn.end(), [&](const char* name) {
        const FaceLine* line = rig.line(name);
        return line &&
               farthest(picture.flat(rest, line->vertices), picture.flat(places, line->vertices)) >= 0.5 * k_moves_px;
      });
      if (seen) values.push_back(value);
    }
    return values;
  }

  [[nodiscard]] KnownFace draw(const std::string& name, const std::vector<std::string>& lines, const Hand& hand,
                               const rig::Pose& truth, double yaw) const {
    const Picture picture(yaw, size);
    const auto places = posed(rig.model, truth);
    KnownFace face;
    face.asked.name = name + "/" + hand.name;
    face.asked.view_yaw_degrees = yaw;
    face.hand = hand.name;
    face.truth = truth;
    for (const std::string& called : lines) {
      const FaceLine& line = *rig.line(called);
      const auto drawn =
          drawn_by(hand, picture.flat(places, line.vertices), seed_of(rig.name, face.asked.name + called));
      face.asked.references.push_back({called, line.vertices, picture.in_space(drawn, places, line.vertices), {}});
    }
    return face;
  }
};

/// The hands that draw a case, most of them only when there is time.
std::vector<Hand> hands_for(std::size_t number, Extent extent) {
  const auto all = all_hands();
  if (extent == Extent::whole) return {all.begin(), all.end()};
  return {all[number % all.size()], all[(number + 3) % all.size()]};
}

}  // namespace

rig::Pose pose_of(const rig::Rig& rig, const std::vector<std::pair<std::string, double>>& values) {
  rig::Pose pose = rig::rest_pose(rig);
  for (const auto& [name, value] : values) {
    const auto i = rig::find_parameter(rig.parameters(), name);
    if (!i) {
      std::fprintf(stderr, "tests/judges/cases: no control is called %s\n", name.c_str());
      std::abort();
    }
    pose[*i] = value;
  }
  return pose;
}

std::vector<KnownFace> known_faces(const Rig& rig, Extent extent) {
  const Artist artist(rig);
  const double front = rig.model.front_yaw_degrees;
  std::vector<KnownFace> faces;
  std::size_t number = 0;
  for (const KnownPose& pose : rig.poses) {
    constexpr std::array<double, 6> k_yaws{0, 0, 20, 0, -15, 30};
    const double yaw = front + k_yaws[seed_of(rig.name, pose.name) % k_yaws.size()];
    const auto values = artist.shown(pose, Picture(yaw, artist.size));
    const rig::Pose truth = pose_of(*rig.model.rig, values);
    const auto lines = artist.moved(posed(rig.model, truth), Picture(yaw, artist.size));
    ++number;
    if (lines.empty()) continue;
    for (const Hand& hand : hands_for(number, extent)) {
      faces.push_back(artist.draw(pose.name, lines, hand, truth, yaw));
      faces.back().true_controls = static_cast<double>(values.size());
    }
  }
  const std::array<std::vector<std::string>, 3> still{{{"lip_upper", "lip_lower"}, {"brow_R"}, {"eyelid_upper_L"}}};
  for (const auto& lines : still) {
    for (const char* hand : {"tremor_1", "tremor_2", "uneven", "backwards"}) {
      if (extent == Extent::brief && (hand[0] == 'u' || hand[7] == '2')) continue;
      faces.push_back(
          artist.draw("still_" + lines.front(), lines, hand_named(hand), rig::rest_pose(*rig.model.rig), front));
    }
  }
  return faces;
}

}  // namespace penpose::judges
