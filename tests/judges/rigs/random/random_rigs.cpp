#include "tests/judges/rigs/random/random_rigs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/math.h"
#include "core/geometry/rotation.h"
#include "tests/judges/rigs/control_words.h"
#include "tests/judges/rigs/random/faces.h"
#include "tests/judges/rigs/random/joints.h"
#include "tests/judges/rigs/random/random_parts.h"
#include "tests/judges/rigs/random/shapes.h"
#include "tests/judges/rigs/random/taste.h"

namespace penpose::judges {
namespace {

/// Where a file has its model: in another unit, elsewhere, a little turned.
struct Placement {
  double scale = 1;
  glm::dquat turn{1, 0, 0, 0};
  ModelVector shift{0};
  double front_yaw_degrees = 0;

  Placement(const Parts& parts, Dice dice) {
    const double size = dice.real(0, 1);
    if (size > 0.8) scale = base::pow(10, dice.real(-2, 2));
    if (size > 0.65 && size <= 0.8) scale = 100;
    if (size > 0.6 && size <= 0.65) scale = 0.01;
    if (dice.chance(0.3)) {
      const glm::dvec3 degrees{dice.real(-8, 8), dice.real(-12, 12), dice.real(-7, 7)};
      turn = geometry::quaternion_from_xyz(degrees * (base::k_pi / 180));
    }
    if (dice.chance(0.1)) {
      front_yaw_degrees = dice.one_of(std::vector<double>{90, -90, 180});
      turn = geometry::quaternion_from_xyz({0, base::radians(front_yaw_degrees), 0}) * turn;
    }
    const double w = parts.mouth;
    if (dice.chance(0.5)) shift = {0, dice.real(0, 60) * w * scale, dice.real(-4, 4) * w * scale};
  }
  [[nodiscard]] ModelPoint place(const ModelPoint& p) const { return turn * (p * scale) + shift; }
  [[nodiscard]] ModelVector way(const ModelVector& d) const { return turn * d; }
};

/// Muscles that a rig lacks: nothing moves them, or joints do.
Means lacking(const JointPlan& plan, const Parts& parts, const Dice& dice) {
  Dice own = dice.about("lacks");
  const auto without = [&](double share, bool joints) { return own.chance(share) || (joints && own.chance(0.8)); };
  const bool all = plan.brows && plan.lids && plan.mouth;
  // Figures are often made to speak, not to frown.
  const bool speaks_only = Dice(dice.about("speaks only")).chance(plan.body ? 0.7 : 0.1);
  const bool no_brows = without(0.25, plan.brows) || all || (speaks_only && !plan.brows);
  const bool no_lids = without(0.08, plan.lids) || all;
  const bool no_mouth = without(0.02, plan.mouth) || all;
  const bool no_frown = own.chance(0.15);
  const bool no_cheeks = own.chance(0.3);
  const bool no_jaw = own.chance(0.03) || (plan.jaw && own.chance(0.75));
  const bool no_nose = own.chance(0.25);
  const bool no_gaze = plan.head && own.chance(0.7);
  Means lacks;
  for (const auto& [muscle, field] : parts.fields) {
    const auto starts = [&, &called = muscle](auto... words) { return (called.starts_with(words) || ...); };
    const bool useless = starts("nothing", "all", "hair", "ears", "teeth", "tongue", "fix_");
    const bool brow = starts("brow_");
    const bool eye = starts("blink_", "wide_", "squint_", "lid_");
    const bool gaze = starts("look_");
    const bool cheek = starts("cheek_", "puff_");
    const bool nose = starts("sneer_");
    const bool jaw = starts("jaw_", "lips_close");
    const bool mouth = !useless && !brow && !eye && !gaze && !cheek && !nose && !jaw;
    if ((brow && no_brows) || (eye && no_lids) || (mouth && no_mouth) || (starts("frown_") && no_frown) ||
        (cheek && (no_cheeks || all)) || (jaw && no_jaw) || (nose && (no_nose || all)) || (gaze && no_gaze))
      lacks.push_back(muscle);
  }
  return lacks;
}

std::string kind_of(const JointPlan& plan, const std::string& shapes) {
  if (!plan.any()) return shapes;
  std::string joints = plan.body ? "joints of body, head" : "joints of head";
  if (plan.jaw) joints += ", jaw";
  if (plan.brows) joints += ", brows";
  if (plan.lids) joints += ", lids";
  if (plan.mouth) joints += ", lips";
  return joints + "; " + shapes;
}

}  // namespace

Rig random_rig(std::uint64_t seed) {
  const Dice dice(seed);
  Parts plain = random_parts(dice);
  add_corrections(plain, corrections_of(dice), dice.about("corrections"));
  const Landmarks marks = landmarks_of(plain);
  const JointPlan plan = random_joint_plan(dice);
  std::vector<BodyPiece> body;
  if (plan.body) body = add_body(plain, dice.about("body"));
  const Placement placement(plain, dice.about("placement"));
  const auto placed = [&](const ModelPoint& p) { return placement.place(p); };
  const Parts parts = reshaped(plain, placed);

  Names names(dice.about("names"));
  FaceBuilder face("random_" + std::to_string(seed), "", Group::seen, parts);
  const Taste taste(parts, dice);
  const Means lacks = lacking(plan, parts, dice);
  face.made_by([&](std::string& name, Recipe& recipe, Means& means) {
    const auto strongest = std::max_element(recipe.begin(), recipe.end(), [](const auto& a, const auto& b) {
      return std::abs(a.second) < std::abs(b.second);
    });
    if (strongest == recipe.end() || has(lacks, strongest->first)) return false;
    if (!taste.make(recipe)) return false;
    std::erase_if(recipe, [&](const auto& part) { return has(lacks, part.first); });
    std::erase_if(means, [&](const std::string& muscle) { return has(lacks, muscle); });
    name = names.unique(name);
    return true;
  });
  if (plan.any()) {
    add_random_joints(face, plain, marks, body, plan, names, dice, placed,
                      [&](const ModelVector& d) { return placement.way(d); });
  }
  const std::size_t turns = face.acts().size();
  std::string shapes = add_random_shapes(face, parts, names, dice);
  if (face.acts().size() == turns) shapes = "no shapes";
  face.also_known(more_expressions());
  Dice poses = dice.about("poses");
  add_random_poses(face, poses, poses.count(10, 15));
  Rig rig = face.build();
  rig.kind = kind_of(plan, shapes);
  rig.model.front_yaw_degrees = placement.front_yaw_degrees;
  return rig;
}

}  // namespace penpose::judges
