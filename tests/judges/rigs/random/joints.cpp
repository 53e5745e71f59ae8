#include "tests/judges/rigs/random/joints.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/math.h"
#include "core/geometry/rotation.h"
#include "tests/judges/rigs/sculpt.h"
#include "tests/judges/rigs/sets.h"

namespace penpose::judges {
namespace {

/// A joint of a face, which moves what some muscles move.
struct Carrier {
  std::string word;
  std::string parent;
  std::vector<std::string> shares;  ///< muscles whose reach is its skin
  std::vector<Means> turns;         ///< it does each of these: muscles that move its middle alike
  double behind = 0;                ///< how far its own place lies behind its skin
};

class FaceJoints {
 public:
  FaceJoints(FaceBuilder& face, const Parts& plain, Names& names, const Dice& dice,
             const std::function<ModelPoint(const ModelPoint&)>& placed,
             const std::function<ModelVector(const ModelVector&)>& turn)
      : face_(face), plain_(plain), names_(names), frames_(dice.about("frames")), placed_(placed), turn_(turn) {
    own_frames_ = frames_.chance(0.75);
  }

  std::size_t add(const std::string& word, const std::string& parent, const ModelPoint& at, double degrees) {
    const std::size_t joint = face_.joint(names_.joint(word), parent.empty() ? -1 : number(parent), placed_(at),
                                          degrees, own_frames_ ? any_frame() : glm::dquat{1, 0, 0, 0});
    known_.push_back({word, joint, at});
    return joint;
  }

  /// Its values for a place of its skin that goes somewhere.
  [[nodiscard]] Values turned(std::size_t joint, const ModelPoint& center, const ModelPoint& from,
                              const ModelVector& way) const {
    const geometry::Turn turn = geometry::turn_between(from - center, from + way - center);
    return face_.turned_about(joint, turn_(turn.axis), turn.angle);
  }

  void add(const Carrier& carrier) {
    std::vector<double> share(plain_.rest().size(), 0.0);
    for (const std::string& muscle : carrier.shares) {
      const auto own = share_of_skin(plain_.field(muscle));
      for (std::size_t v = 0; v < own.size(); ++v) share[v] = std::max(share[v], own[v]);
    }
    const auto end = share.begin() + static_cast<std::ptrdiff_t>(skin());
    const auto peak = static_cast<std::size_t>(std::max_element(share.begin(), end) - share.begin());
    const ModelPoint from = plain_.rest()[peak];
    const ModelPoint center = from - ModelVector{0, 0, carrier.behind};
    const std::size_t joint = add(carrier.word, carrier.parent, center, 70);
    face_.carry(joint, share);
    for (const Means& muscles : carrier.turns) {
      ModelVector way{0};
      for (const std::string& muscle : muscles) {
        const ModelVector d = plain_.field(muscle)[peak];
        if (geometry::length(d) > geometry::length(way)) way = d;
      }
      Values values = turned(joint, center, from, way);
      if (!values.empty()) face_.turns_mean(std::move(values), muscles);
    }
    peaks_.push_back({carrier.word, joint, center, from, peak});
  }

  /// Joints that do a muscle together.
  void together(const std::string& muscle, const std::vector<std::string>& words) {
    Values all;
    for (const auto& peak : peaks_) {
      if (std::find(words.begin(), words.end(), peak.word) == words.end()) continue;
      const Values values = turned(peak.joint, peak.center, peak.from, plain_.field(muscle)[peak.vertex]);
      all.insert(all.end(), values.begin(), values.end());
    }
    if (!all.empty()) face_.turns_mean(std::move(all), {muscle});
  }

  [[nodiscard]] bool has_joint(const std::string& word) const {
    return std::any_of(known_.begin(), known_.end(), [&](const Known& k) { return k.word == word; });
  }

 private:
  struct Known {
    std::string word;
    std::size_t joint;
    ModelPoint at;
  };
  struct Peak {
    std::string word;
    std::size_t joint;
    ModelPoint center, from;
    std::size_t vertex;
  };
  /// Pieces that hang on the skin may go farther than it does, and do not say where a joint is.
  [[nodiscard]] std::size_t skin() const { return plain_.skin == 0 ? plain_.rest().size() : plain_.skin; }
  [[nodiscard]] std::vector<double> share_of_skin(const Field& field) const {
    double most = 0;
    for (std::size_t v = 0; v < skin(); ++v) most = std::max(most, geometry::length(field[v]));
    std::vector<double> share;
    for (const ModelVector& d : field) share.push_back(most > 0 ? std::min(1.0, geometry::length(d) / most) : 0);
    return share;
  }
  [[nodiscard]] std::int32_t number(const std::string& word) const {
    return static_cast<std::int32_t>(
        std::find_if(known_.begin(), known_.end(), [&](const Known& k) { return k.word == word; })->joint);
  }
  glm::dquat any_frame() {
    const ModelVector axis{frames_.real(-1, 1), frames_.real(-1, 1), frames_.real(-1, 1)};
    const double half = frames_.real(0, base::k_pi);
    const ModelVector v = geometry::normalized(axis) * base::sin(half);
    return {base::cos(half), v.x, v.y, v.z};
  }

  FaceBuilder& face_;
  const Parts& plain_;
  Names& names_;
  Dice frames_;
  bool own_frames_ = true;
  const std::function<ModelPoint(const ModelPoint&)>& placed_;
  const std::function<ModelVector(const ModelVector&)>& turn_;
  std::vector<Known> known_;
  std::vector<Peak> peaks_;
};

void add_skull(FaceJoints& joints, FaceBuilder& face, const Parts& plain, const Landmarks& marks,
               std::span<const BodyPiece> body, const JointPlan& plan, Dice& own) {
  const double h = marks.high - marks.low;
  const ModelPoint base{0, marks.low, marks.mouth.z - 0.4 * h};
  std::string root;
  if (body.empty() && own.chance(0.6)) {
    joints.add("root", "", base - ModelVector{0, own.real(0.2, 3) * h, 0}, 60);
    root = "root";
  }
  std::vector<std::pair<std::size_t, const BodyPiece*>> carriers;
  for (const BodyPiece& piece : body) {
    carriers.emplace_back(joints.add(piece.name, piece.above, piece.at, 90), &piece);
    if (piece.name == "chest") root = "chest";
  }
  std::vector<double> all(plain.rest().size(), 1.0);
  const std::size_t neck = joints.add("neck", root, base, 60);
  face.carry(neck, all);
  std::vector<double> above;
  for (const ModelPoint& p : plain.rest())
    above.push_back(smooth_step(marks.low + 0.04 * h, marks.low + 0.22 * h, p.y));
  face.carry(joints.add("head", "neck", base + ModelVector{0, 0.15 * h, 0}, 60), above);
  for (const auto& [joint, piece] : carriers) {
    std::vector<double> share(plain.rest().size(), 0.0);
    for (const std::uint32_t v : piece->vertices) share[v] = 1;
    face.carry(joint, share);
  }
  for (const auto& [side, ball] : plain.eyes) {
    if (!own.chance(0.9)) continue;
    std::vector<double> share(plain.rest().size(), 0.0);
    geometry::Box box;
    for (const std::uint32_t v : ball) {
      share[v] = 1;
      box.add(plain.rest()[v]);
    }
    face.carry(joints.add("eye_" + side, "head", box.center(), 35), share);
  }
  if (plan.jaw) {
    const auto& field = plain.field("jaw_open");
    const auto longest = std::max_element(field.begin(), field.end(), [](const ModelVector& a, const ModelVector& b) {
      return geometry::length(a) < geometry::length(b);
    });
    const auto peak = static_cast<std::size_t>(longest - field.begin());
    const ModelPoint from = plain.rest()[peak];
    const ModelPoint center{0, marks.mouth.y + own.real(0.3, 1.2) * marks.mouth_w,
                            marks.mouth.z - own.real(1.8, 3) * marks.mouth_w};
    const std::size_t jaw = joints.add("jaw", "head", center, 60);
    face.carry(jaw, plain.jaw_share);
    face.turns_mean(joints.turned(jaw, center, {0, from.y, from.z}, {0, longest->y, longest->z}), {"jaw_open"});
  }
}

void add_upper_face(FaceJoints& joints, const Landmarks& marks, const JointPlan& plan, Dice& own) {
  const double w = marks.mouth_w;
  const bool whole_brows = own.chance(0.35);
  const double behind_brows = own.real(1.2, 3) * w;
  const double behind_lids = own.real(0.8, 1.1) * marks.eye;
  for (const char* side : {"L", "R"}) {
    const std::string end = side;
    if (plan.brows && whole_brows) {
      joints.add({"brow_" + end,
                  "head",
                  {"brow_inner_up_" + end, "brow_outer_up_" + end},
                  {{"brow_inner_up_" + end, "brow_outer_up_" + end}, {"brow_down_" + end}},
                  behind_brows});
    } else if (plan.brows) {
      joints.add({"brow_inner_" + end,
                  "head",
                  {"brow_inner_up_" + end},
                  {{"brow_inner_up_" + end}, {"brow_down_" + end}},
                  behind_brows});
      joints.add({"brow_outer_" + end, "head", {"brow_outer_up_" + end}, {{"brow_outer_up_" + end}}, behind_brows});
    }
    if (plan.lids) {
      joints.add({"lid_upper_" + end, "head", {"blink_" + end}, {{"blink_" + end}, {"wide_" + end}}, behind_lids});
      joints.add({"lid_lower_" + end, "head", {"squint_" + end}, {{"squint_" + end}}, behind_lids});
    }
  }
}

void add_mouth_joints(FaceJoints& joints, const Landmarks& marks, bool has_jaw, Dice& own) {
  const double w = marks.mouth_w;
  const double behind = own.real(1.5, 3) * w;
  const bool lips_by_side = own.chance(0.4);
  const std::string lower = has_jaw ? "jaw" : "head";
  for (const char* side : {"L", "R"}) {
    const std::string end = side;
    if (own.chance(0.35)) joints.add({"cheek_" + end, "head", {"cheek_" + end}, {{"cheek_" + end}}, behind});
    if (own.chance(0.3)) joints.add({"nostril_" + end, "head", {"sneer_" + end}, {{"sneer_" + end}}, behind});
    if (!lips_by_side) continue;
    joints.add({"lip_upper_" + end, "head", {"upper_up_" + end}, {{"upper_up_" + end}}, behind});
    joints.add({"lip_lower_" + end, lower, {"lower_down_" + end}, {{"lower_down_" + end}}, behind});
  }
  if (!lips_by_side) {
    joints.add({"lip_upper", "head", {"upper_up_L", "upper_up_R"}, {{"upper_up_L", "upper_up_R"}}, behind});
    joints.add({"lip_lower", lower, {"lower_down_L", "lower_down_R"}, {{"lower_down_L", "lower_down_R"}}, behind});
  }
  for (const char* side : {"L", "R"}) {
    const std::string end = side;
    joints.add({"lip_corner_" + end,
                "head",
                {"smile_" + end},
                {{"smile_" + end}, {"frown_" + end}, {"stretch_" + end}},
                behind});
  }
  joints.together("pucker", {"lip_corner_L", "lip_corner_R"});
}

/// Joints that no line speaks of: at the temples and in the hair, which carry a bit of the skin by the brows, and of a
/// figure its fingers, toes and cloth, most of which carry nothing of this mesh.
void add_others(FaceJoints& joints, FaceBuilder& face, const Parts& plain, const Landmarks& marks,
                std::span<const BodyPiece> body, Dice own) {
  const double w = marks.mouth_w;
  const double share = own.real(0.15, 0.8);
  const double reach = own.real(0.3, 0.8) * w;
  const bool temples = own.chance(0.6);
  const bool hair = own.chance(0.6);
  for (const std::size_t i : {0U, 1U}) {
    const std::string end = i == 0 ? "_L" : "_R";
    const double out = i == 0 ? 1 : -1;
    const ModelPoint brow = plain.rest()[plain.line("brow" + end).back()];
    const auto carry = [&](std::size_t joint, const ModelPoint& at) {
      auto skin = around(plain.rest(), at, ModelVector{1, 1, 1.5} * reach);
      for (double& one : skin) one *= share;
      face.carry(joint, skin);
    };
    if (temples) {
      const ModelPoint at = brow + ModelVector{out * 0.35, 0.2, -0.2} * w;
      carry(joints.add("temple" + end, "head", at, 40), at);
    }
    if (hair) {
      const ModelPoint at = marks.brows[i] + ModelVector{out * 0.1, 0.9, 0} * w;
      carry(joints.add("hair_front" + end, "head", at, 60), at);
      joints.add("hair_tip" + end, "hair_front" + end, at + ModelVector{0, -0.4 * w, 0.5 * w}, 60);
    }
  }
  if (body.empty()) return;
  const double many = own.real(0, 1);
  const auto count = static_cast<std::size_t>(6 + 120 * many * many * many);
  constexpr std::array<const char*, 8> k_chains{"finger", "toe", "twist", "cloth", "tail", "strap", "weapon", "helper"};
  for (std::size_t made = 0; made < count;) {
    const std::string chain = std::string(own.one_of(k_chains)) + std::to_string(made) + "_";
    const BodyPiece& piece = own.one_of(body);
    std::string above = piece.name;
    ModelPoint at = piece.at;
    const std::size_t length = own.count(1, 4);
    for (std::size_t k = 0; k < length; ++k, ++made) {
      at += ModelVector{own.real(-1, 1), own.real(-1, 0.5), own.real(-1, 1)} * w;
      const std::string word = chain + std::to_string(k);
      joints.add(word, above, at, 60);
      above = word;
    }
  }
}

}  // namespace

JointPlan random_joint_plan(const Dice& dice) {
  Dice own = dice.about("joints");
  JointPlan plan;
  const double kind = own.real(0, 1);
  if (kind < 0.25) return plan;
  plan.head = true;
  plan.body = own.chance(0.6);
  plan.jaw = own.chance(0.6);
  if (kind > 0.85) {
    plan.jaw = plan.brows = plan.lids = plan.mouth = true;
  } else if (kind > 0.72) {
    plan.brows = own.chance(0.5);
    plan.lids = own.chance(0.5);
    plan.mouth = own.chance(0.4);
  }
  return plan;
}

void add_random_joints(FaceBuilder& face, const Parts& plain, const Landmarks& marks, std::span<const BodyPiece> body,
                       const JointPlan& plan, Names& names, const Dice& dice,
                       const std::function<ModelPoint(const ModelPoint&)>& placed,
                       const std::function<ModelVector(const ModelVector&)>& turn) {
  Dice own = dice.about("skeleton");
  FaceJoints joints(face, plain, names, dice, placed, turn);
  add_skull(joints, face, plain, marks, body, plan, own);
  add_upper_face(joints, marks, plan, own);
  if (plan.mouth) add_mouth_joints(joints, marks, plan.jaw, own);
  if (Dice(dice.about("has other joints")).chance(plan.body ? 0.75 : 0.2))
    add_others(joints, face, plain, marks, body, dice.about("other joints"));
}

}  // namespace penpose::judges
