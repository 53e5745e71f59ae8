// Poses from contour lines alone: how far the model is off, and how long it takes.
//
//   silhouette_bench FOLDER [--held-out] [-v] [--model NAME]
//                                  FOLDER: of the models, ict_face.glb, ict_avatar.glb, cesium_man.glb; NAME: of one
//
// Each scene is a known pose seen from one side. Its contours of a twentieth of the picture or more are lines by a hand
// that strays 2.5 px of a picture of 1000 px, once all of them and once only what moved, with a few px beside it; once
// laid where the picture is and once a little larger, turned and shifted. Errors are |found - true| / |true| over all
// vertices; of bodies also what shared/checks/body_gap.py judges: the root mean square and how far what should stay
// strays, in per cent of the height. Scenes that are held out were not looked at while constants were set.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/curve/polyline.h"
#include "core/geometry/bvh.h"
#include "core/geometry/rotation.h"
#include "core/joints/body.h"
#include "core/portrait/contour/pose_from_contours.h"
#include "core/portrait/silhouette.h"
#include "tests/support/hands/tremor.h"
#include "tests/support/random.h"
#include "ui/files/load_model.h"
#include "ui/render/framing.h"

namespace penpose {
namespace {

using geometry::ModelPoint;
using geometry::ModelVector;
using geometry::PxPoint;

/// A control at a value, or a joint that turns about axes of the world (degrees).
struct Move {
  const char* name;
  double value;
  ModelVector degrees{0};
};
struct Scene {
  const char* model;
  const char* name;
  double yaw;
  std::vector<Move> moves;
  bool held_out = false;
};

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> k_scenes{
      {"ict_face.glb", "jaw 0.25", 90, {{"jawOpen", 0.25}}},
      {"ict_face.glb", "jaw 0.5", 90, {{"jawOpen", 0.5}}},
      {"ict_face.glb", "jaw 0.9", 90, {{"jawOpen", 0.9}}},
      {"builtin:demo", "jaw 0.5", 90, {{"jaw", 0.5}}},
      {"cesium_man.glb", "arm raised", 90, {{"joint13", 0, {-50, 0, 0}}}},
      {"cesium_man.glb", "elbow bent", 90, {{"joint17", 0, {60, 0, 0}}}},
      {"cesium_man.glb", "leg lifted", 0, {{"joint3", 0, {0, 0, 40}}}},
      {"cesium_man.glb", "knee bent", 180, {{"joint7", 0, {0, 0, 35}}, {"joint8", 0, {0, 0, -50}}}},
      {"cesium_man.glb", "bow", 0, {{"joint11", 0, {0, 0, -30}}}},
      {"cesium_man.glb", "nod", 0, {{"joint19", 0, {0, 0, -25}}}},
      {"cesium_man.glb", "leg to the eye", 90, {{"joint3", 0, {0, 0, 45}}}},
      {"ict_face.glb", "jaw 0.4", 75, {{"jawOpen", 0.4}}, true},
      {"ict_face.glb", "jaw 0.7", 90, {{"jawOpen", 0.7}}, true},
      {"ict_face.glb", "cheeks", 0, {{"cheekPuff_L", 0.8}, {"cheekPuff_R", 0.8}}, true},
      {"ict_avatar.glb", "jaw 0.4", 90, {{"jawOpen", 0.4}}, true},
      {"ict_avatar.glb", "jaw 0.8", 90, {{"jawOpen", 0.8}}, true},
      {"ict_avatar.glb", "arm raised 35", 0, {{"LeftArm", 0, {0, 0, 35}}}, true},
      {"ict_avatar.glb", "arm raised 80", 0, {{"LeftArm", 0, {0, 0, 80}}}, true},
      {"builtin:demo", "jaw 0.8", 90, {{"jaw", 0.8}}, true},
      {"cesium_man.glb", "arm raised 30", 90, {{"joint16", 0, {30, 0, 0}}}, true},
      {"cesium_man.glb", "arm raised 80", 90, {{"joint16", 0, {80, 0, 0}}}, true},
      {"cesium_man.glb", "both arms", 90, {{"joint13", 0, {-35, 0, 0}}, {"joint16", 0, {60, 0, 0}}}, true},
      {"cesium_man.glb", "leg aside", 90, {{"joint7", 0, {25, 0, 0}}}, true},
  };
  return k_scenes;
}

class Stage {
 public:
  Stage(const document::Model& model, const Scene& scene)
      : model_(model), rig_(*model.rig), rest_(rig::rest_pose(rig_)), meant_(rest_) {
    for (const Move& move : scene.moves) add(move);
    at_rest_ = places(rest_);
    true_ = places(meant_);
    const render::Viewpoint from{scene.yaw, 0};
    const std::vector<glm::vec3> points(at_rest_.begin(), at_rest_.end());
    camera_.push_back(render::frame_points(points, {1000, 1000}, from));
  }

  /// The contours of the pose by a hand. `moved`: only what moved.
  [[nodiscard]] std::vector<std::vector<PxPoint>> lines(bool moved, tests::Random& random) const {
    const std::vector<glm::vec3> floats(true_.begin(), true_.end());
    const geometry::TriangleBvh tree(floats, model_.mesh->triangles());
    std::vector<std::vector<PxPoint>> out;
    for (const auto& contour : portrait::silhouette(camera(), *model_.mesh, true_, tree)) {
      std::vector<PxPoint> px;
      std::vector<bool> tells;
      for (const auto& point : contour) {
        const ModelPoint place = portrait::place_of(point, true_);
        px.push_back(camera().project(place).value());
        tells.push_back(geometry::distance(*camera().project(portrait::place_of(point, at_rest_)), px.back()) > 6.0);
      }
      if (curve::arc_length<PxPoint>(px) < 50.0) continue;
      if (!moved) {
        out.push_back(by_hand(px, random));
        continue;
      }
      // With two points beside what moved.
      for (std::size_t i = 0; i < px.size();) {
        std::vector<PxPoint> part;
        while (i < px.size() && !tells[i]) ++i;
        for (std::size_t k = i > 2 ? i - 2 : 0; k < i; ++k) part.push_back(px[k]);
        while (i < px.size() && tells[i]) part.push_back(px[i++]);
        for (std::size_t k = i; k < std::min(px.size(), i + 2); ++k) part.push_back(px[k]);
        if (part.size() > 2 && curve::arc_length<PxPoint>(part) >= 50.0) out.push_back(by_hand(part, random));
      }
    }
    return out;
  }
  struct Errors {
    double share, height, stray;  ///< per cent
  };
  [[nodiscard]] Errors errors(const rig::Pose& found) const {
    const auto got = places(found);
    geometry::Box box;
    double off = 0, way = 0, stray = 0;
    for (const ModelPoint& p : at_rest_) box.add(p);
    const double height = box.maximum.y - box.minimum.y;
    for (std::size_t v = 0; v < got.size(); ++v) {
      off += std::pow(geometry::distance(got[v], true_[v]), 2);
      way += std::pow(geometry::distance(at_rest_[v], true_[v]), 2);
      if (geometry::distance(at_rest_[v], true_[v]) < 0.005 * height)
        stray = std::max(stray, geometry::distance(got[v], at_rest_[v]));
    }
    return {100 * std::sqrt(off / way), 100 * std::sqrt(off / static_cast<double>(got.size())) / height,
            100 * stray / height};
  }
  [[nodiscard]] const geometry::Camera& camera() const { return camera_.front(); }
  [[nodiscard]] const rig::Pose& rest() const { return rest_; }
  [[nodiscard]] const rig::Pose& meant() const { return meant_; }

 private:
  void add(const Move& move) {
    const auto parameters = rig_.parameters();
    if (const auto p = rig::find_parameter(parameters, move.name)) {
      meant_[*p] = move.value;
      return;
    }
    const std::size_t first = rig::find_parameter(parameters, std::string(move.name) + ".rx").value();
    const rig::Skeleton& skeleton = *rig_.skeleton();
    const std::size_t start = rig_.first_parameter(rig_.layers().size());
    const auto at = joints::places_of(skeleton, std::span(meant_).subspan(start));
    const glm::dquat turned = at[skeleton.joint_of(first - start)].turn;
    const double angle = geometry::length(move.degrees);
    const glm::dquat by = glm::quat_cast(geometry::rotation_about(move.degrees / angle, base::radians(angle)));
    const glm::dquat now = geometry::quaternion_from_xyz({meant_[first], meant_[first + 1], meant_[first + 2]});
    const glm::dvec3 angles = geometry::xyz_from_quaternion(now * glm::conjugate(turned) * by * turned);
    for (int k = 0; k < 3; ++k) meant_[first + static_cast<std::size_t>(k)] = angles[k];
  }
  [[nodiscard]] std::vector<ModelPoint> places(const rig::Pose& pose) const {
    std::vector<ModelPoint> out(rig_.vertex_count());
    rig_.evaluate(pose, out);
    return out;
  }
  /// Points 8 px apart with a smooth tremor of 2.5 px.
  static std::vector<PxPoint> by_hand(const std::vector<PxPoint>& line, tests::Random& random) {
    const auto count = static_cast<std::size_t>(curve::arc_length<PxPoint>(line) / 8.0) + 2;
    return tests::with_tremor(curve::resample<PxPoint>(line, count).value(), random, 0.15, 0.4);
  }

  const document::Model& model_;
  const rig::CharacterRig& rig_;
  rig::Pose rest_, meant_;
  std::vector<ModelPoint> at_rest_, true_;
  std::vector<geometry::Camera> camera_;  ///< one
};

int measure(const std::string& folder, const std::string& only, bool held_out, bool loud) {
  std::vector<double> errors, times;
  for (const Scene& scene : scenes()) {
    if (scene.held_out != held_out || (!only.empty() && only != scene.model)) continue;
    const std::string path = std::strchr(scene.model, ':') != nullptr ? scene.model : folder + "/" + scene.model;
    const auto model = files::load_model(path);
    if (!model) return std::fprintf(stderr, "%s\n", model.error().line(path).c_str()), 1;
    const auto whole = intent::measure_whole_model(*model->rig);
    const Stage stage(*model, scene);
    std::vector<std::size_t> free(model->rig->parameters().size());
    for (std::size_t i = 0; i < free.size(); ++i) free[i] = i;
    for (int kind = 0; kind < 4; ++kind) {
      tests::Random random(static_cast<std::uint64_t>(kind + 1));
      portrait::ContourDrawing drawing{stage.lines(kind % 2 == 1, random), 1000, 1000, {}, {}};
      if (drawing.lines.empty()) continue;  // nothing moves by 6 px over 50 px
      if (kind >= 2) {
        const double grown = 1.0 + random(-0.01, 0.01), turn = random(-0.01, 0.01);
        const PxPoint shift{random(-8, 8), random(-8, 8)};
        for (auto& line : drawing.lines) {
          for (PxPoint& p : line) {
            const PxPoint d = (p - PxPoint{500, 500}) * grown;
            p = PxPoint{500, 500} + shift + PxPoint{d.x - turn * d.y, d.y + turn * d.x};
          }
        }
      }
      const auto begin = std::chrono::steady_clock::now();
      const auto posed = portrait::pose_from_contours(*model->rig, *model->mesh, whole, drawing,
                                                      std::span(&stage.camera(), 1), stage.rest(), free);
      times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
      if (!posed) return std::fprintf(stderr, "%s\n", posed.error().line(path).c_str()), 1;
      const auto off = stage.errors(posed->pose);
      errors.push_back(off.share);
      std::printf("%-16s %-14s %-5s %-6s %6.1f %%   of the height %5.2f %%, stray %5.2f %%   %5.2f s\n", scene.model,
                  scene.name, kind % 2 == 1 ? "moved" : "all", kind >= 2 ? "beside" : "there", off.share, off.height,
                  off.stray, times.back());
      if (!loud) continue;
      for (std::size_t p = 0; p < posed->pose.size(); ++p) {
        if (posed->pose[p] != stage.rest()[p] || stage.meant()[p] != stage.rest()[p])
          std::printf("    %s %.3f of %.3f\n", model->rig->parameters()[p].name.c_str(), posed->pose[p],
                      stage.meant()[p]);
      }
    }
  }
  std::stable_sort(errors.begin(), errors.end());
  std::stable_sort(times.begin(), times.end());
  if (errors.empty()) return 1;
  const auto good = std::count_if(errors.begin(), errors.end(), [](double e) { return e <= 10.0; });
  std::printf("median %.1f %%, worst %.1f %%, %ld of %zu at most 10 %%; median %.2f s, longest %.2f s\n",
              errors[errors.size() / 2], errors.back(), static_cast<long>(good), errors.size(), times[times.size() / 2],
              times.back());
  return 0;
}

}  // namespace
}  // namespace penpose

int main(int count, char** arguments) {
  std::string folder = ".", only;
  bool held_out = false, loud = false;
  for (int i = 1; i < count; ++i) {
    const std::string one = arguments[i];
    if (one == "--held-out") {
      held_out = true;
    } else if (one == "--model" && i + 1 < count) {
      only = arguments[++i];
    } else if (one == "-v") {
      loud = true;
    } else {
      folder = one;
    }
  }
  return penpose::measure(folder, only, held_out, loud);
}
