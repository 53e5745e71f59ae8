#include "core/document/words/joint_words.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "core/document/humanoid_rest.h"
#include "core/document/words/body_names.h"

namespace penpose::document {
namespace {

using geometry::ModelVector;

/// "upper arm", "thumb tip": the bone's own name in words.
NamedJoint of_bone(HumanBone bone) {
  ReadableName name = readable_name(name_of(bone));
  NamedJoint out{std::move(name), JointKind::limb};
  const auto ends = [&](std::string_view end, const char* by) {
    if (out.what.ends_with(end)) out.what.replace(out.what.size() - end.size(), end.size(), by);
  };
  if (bone <= HumanBone::neck) out.kind = JointKind::middle;
  if (bone == HumanBone::head || bone == HumanBone::neck) out.kind = JointKind::head;
  if (bone == HumanBone::left_eye || bone == HumanBone::right_eye) out.kind = JointKind::eye;
  if (bone == HumanBone::jaw) out.kind = JointKind::jaw;
  if (bone < HumanBone::left_thumb_metacarpal) return out;
  out.kind = JointKind::finger;
  const bool thumb = out.what.starts_with("thumb");
  if (!thumb) out.what.insert(out.what.find(' '), " finger");
  ends("metacarpal", "base");
  ends("proximal", thumb ? "middle" : "base");
  ends("intermediate", "middle");
  ends("distal", "tip");
  return out;
}

/// Whether a joint's own name says which part of the trunk it is.
bool says_trunk(std::string_view what) {
  constexpr std::array<std::string_view, 10> k_trunk{"hip",   "pelvis", "spine",   "chest",  "torso",
                                                     "waist", "root",   "abdomen", "breast", "body"};
  return std::any_of(k_trunk.begin(), k_trunk.end(),
                     [&](std::string_view word) { return what.find(word) != std::string_view::npos; });
}

/// What the places of a face tell of a joint that turns them.
class FaceJoint {
 public:
  FaceJoint(const Model& model, const intent::WholeModel& whole, FaceMarks& face)
      : whole_(whole), face_(face), rest_(rig::rest_pose(*model.rig)) {}

  /// `first`: the first parameter of the joint.
  [[nodiscard]] JointKind kind(std::size_t first) {
    if (moves_eye(first)) return JointKind::eye;
    if (!face_.moves(first)) return JointKind::other;
    double brow = 0, lid = 0, ball = 0, upper = 0, lower = 0, chin = 0;
    side_ = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      rig::Pose pose = rest_;
      pose[first + k] += k_turn;
      const FaceMoves moves = face_.moves(pose);
      const auto sum = [&](Mark mark) {
        return geometry::length(moves.half[0][mark]) + geometry::length(moves.half[1][mark]);
      };
      brow += sum(Mark::brow_middle);
      lid += sum(Mark::lid_upper);
      ball += sum(Mark::ball);
      upper += sum(Mark::lip_upper_border) + sum(Mark::lip_upper_middle);
      lower += sum(Mark::lip_lower_middle);
      chin += sum(Mark::chin);
      side_ += geometry::length(moves.half[0][Mark::ball]) - geometry::length(moves.half[1][Mark::ball]);
    }
    const double most = std::max({brow, lid, upper, lower, chin});
    if (ball > k_still && ball > 4.0 * most) return JointKind::eye;
    if (most < k_still) return JointKind::other;
    if (std::min({brow, lower, chin}) > 0.3 * most) return JointKind::head;
    if (std::min(chin, lower) > 0.5 * most && brow < 0.1 * most && upper < 0.9 * lower) return JointKind::jaw;
    return JointKind::face;
  }
  [[nodiscard]] FaceSide side() const { return side_ > 0 ? FaceSide::left : FaceSide::right; }

 private:
  /// Whether what it moves lies about one eye.
  bool moves_eye(std::size_t first) {
    geometry::ModelPoint middle(0);
    double square = 0;
    double weights = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const intent::ControlField field = whole_.fields->field(first + k);
      for (std::size_t s = 0; s < field.samples.size(); ++s) {
        const geometry::ModelPoint p = face_.frame().local(whole_.fields->places()[field.samples[s]]);
        const double weight = geometry::length(field.ways[s]);
        middle += p * weight;
        square += glm::dot(p, p) * weight;
        weights += weight;
      }
    }
    if (!(weights > 0.0)) return false;
    middle /= weights;
    const double spread = std::sqrt(std::max(0.0, square / weights - glm::dot(middle, middle)));
    for (std::size_t side = 0; side < 2; ++side) {
      const geometry::ModelPoint& eye = face_.eye(side);
      side_ = side == 0 ? 1 : -1;
      const bool near =
          std::abs(middle.x - eye.x) < k_at_eye * face_.unit() && std::abs(middle.y - eye.y) < k_at_eye * face_.unit();
      if (near && spread < 2.0 * k_at_eye * face_.unit()) return true;
    }
    return false;
  }

  static constexpr double k_at_eye = 0.2;  ///< of the distance between the eyes
  static constexpr double k_turn = 0.3;    ///< radians
  static constexpr double k_still = 1e-3;  ///< of the distance between the eyes

  const intent::WholeModel& whole_;
  FaceMarks& face_;
  rig::Pose rest_;
  double side_ = 0;
};

/// Names of the joints of a skeleton: by its humanoid, else by what they do to the face, else their own.
class JointNames {
 public:
  JointNames(const Model& model, const intent::WholeModel& whole, const portrait::FaceFrame& front, FaceMarks* face)
      : model_(model), whole_(whole), face_(face), names_(model.skeleton->joints().size()) {
    const Humanoid humanoid = humanoid_of(model);
    std::vector<bool> named(names_.size());
    for (std::size_t b = 0; b < k_human_bones; ++b) {
      const auto joint = humanoid.joint(static_cast<HumanBone>(b));
      if (!joint) continue;
      names_[*joint] = of_bone(static_cast<HumanBone>(b));
      named[*joint] = true;
    }
    const auto shaped = names_by_shape(whole, front);
    for (std::size_t j = 0; j < names_.size(); ++j) {
      if (named[j]) continue;
      names_[j] = {readable_name(model.skeleton->joints()[j].name), JointKind::other};
      if (shaped[j]) names_[j] = *shaped[j];
    }
    if (face != nullptr) name_by_face(named);
    name_ends();
    number();
  }
  [[nodiscard]] const NamedJoint& operator[](std::size_t joint) const { return names_[joint]; }

 private:
  void name_by_face(std::vector<bool>& named) {
    FaceJoint of_face(model_, whole_, *face_);
    std::int32_t head = -1;
    for (std::size_t i = 0; i < whole_.joint.size(); ++i) {
      const std::size_t j = whole_.joint[i];
      if (j == intent::k_no_partner || whole_.group[i] != i || named[j]) continue;
      const JointKind kind = of_face.kind(i);
      if (kind == JointKind::eye) name_eye(j, of_face.side());
      if (kind == JointKind::jaw) names_[j] = {{"jaw"}, kind};
      if (kind == JointKind::face) names_[j].kind = kind;
      if (kind == JointKind::head) head = static_cast<std::int32_t>(j);  // the last one is the deepest
    }
    if (head < 0) return;
    const auto joints = model_.skeleton->joints();
    const char* what = "head";
    for (std::int32_t j = head; j >= 0 && !named[static_cast<std::size_t>(j)];
         j = joints[static_cast<std::size_t>(j)].parent) {
      if (!joints[static_cast<std::size_t>(j)].posable) continue;
      NamedJoint& name = names_[static_cast<std::size_t>(j)];
      if (*what != 's') name = {{what}, JointKind::head};
      if (*what == 's' && name.kind == JointKind::other) {
        if (!says_trunk(name.what)) name.what = what;
        name.kind = JointKind::middle;
      }
      what = *what == 'h' ? "neck" : "spine";
    }
  }

  /// A joint that carries the eye's own joint alone keeps its name.
  void name_eye(std::size_t joint, FaceSide side) {
    const std::int32_t above = model_.skeleton->joints()[joint].parent;
    if (above >= 0) {
      NamedJoint& carrier = names_[static_cast<std::size_t>(above)];
      const std::string& own = model_.skeleton->joints()[static_cast<std::size_t>(above)].name;
      if (carrier.kind == JointKind::eye) carrier = {readable_name(own), JointKind::eye};
    }
    names_[joint] = {{"eye", side}, JointKind::eye};
  }

  /// What carries nothing and ends a limb is called by that.
  void name_ends() {
    const joints::Body& body = *whole_.body;
    for (std::size_t j = 0; j < names_.size(); ++j) {
      if (names_[j].kind != JointKind::other || body.parent(j) < 0 || !body.branches(j).empty()) continue;
      const NamedJoint& above = names_[static_cast<std::size_t>(body.parent(j))];
      if (above.kind == JointKind::other || above.kind == JointKind::face || whole_.joint_extents[j] > 0.0) continue;
      names_[j] = {{above.what + " end", above.side}, JointKind::other};
    }
  }

  /// Those that would be called the same are counted.
  void number() {
    std::map<std::pair<std::string, FaceSide>, int> counts;
    for (NamedJoint& one : names_) {
      const int count = ++counts[{one.what, one.side}];
      if (count > 1) one.what += " " + std::to_string(count);
    }
  }

  const Model& model_;
  const intent::WholeModel& whole_;
  FaceMarks* face_;
  std::vector<NamedJoint> names_;
};

/// " turns" of one, " turn" of several.
std::string said_of(std::string_view what, std::string_view deed) {
  std::string out(deed);
  const std::size_t end = out.find(' ', 1);
  if (what.ends_with("s")) out.erase(end == std::string::npos ? out.size() - 1 : end - 1, 1);
  return out;
}

/// Which of three numbers is the largest.
int largest(const ModelVector& v) {
  const ModelVector a(std::abs(v.x), std::abs(v.y), std::abs(v.z));
  return a.y >= a.x && a.y >= a.z ? 1 : a.x >= a.z ? 0 : 2;
}

/// Rows of a matrix, one a parameter of a joint, and its columns joined one to one so that their sum is largest.
using Three = std::array<std::array<double, 3>, 3>;
std::array<std::size_t, 3> join(const Three& values) {
  constexpr std::array<std::array<std::size_t, 3>, 6> k_orders{
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  const auto sum = [&](const auto& order) { return values[0][order[0]] + values[1][order[1]] + values[2][order[2]]; };
  return *std::max_element(k_orders.begin(), k_orders.end(),
                           [&](const auto& a, const auto& b) { return sum(a) < sum(b) - 1e-9; });
}

/// What turns about a joint's own axes do, each in another way. All in the face's directions: left, up, front.
std::array<std::string_view, 3> deeds_of_turns(JointKind kind, const std::array<ModelVector, 3>& axes,
                                               const ModelVector& bone) {
  using Deeds = std::array<std::string_view, 3>;
  const bool limb = kind == JointKind::limb || kind == JointKind::finger || kind == JointKind::other;
  Three values{};
  for (std::size_t k = 0; k < 3; ++k) {
    const ModelVector way = limb ? glm::cross(axes[k], bone) : axes[k];
    for (int d = 0; d < 3; ++d) values[k][static_cast<std::size_t>(d)] = std::abs(way[d]);
    if (!limb) continue;
    // The bone's own direction stands for the twist.
    const auto along = static_cast<std::size_t>(largest(bone));
    values[k][along] = 2.0 * std::abs(glm::dot(axes[k], bone));
  }
  Deeds about{" nods", " turns", " tilts"};
  if (kind == JointKind::middle) about = {" bends", " turns", " leans"};
  if (kind == JointKind::eye) about = {" looks up and down", " looks left and right", " rolls"};
  if (kind == JointKind::jaw) about = {" opens", " goes sideways", " tilts"};
  if (limb) {
    about = {" goes sideways", " raises", " swings forward"};
    if (kind == JointKind::finger) about = {" spreads", " curls", " spreads"};
    if (kind == JointKind::finger && largest(bone) == 1) about = {" curls", " twists", " spreads"};
    about[static_cast<std::size_t>(largest(bone))] = " twists";
  }
  const auto order = join(values);
  return {about[order[0]], about[order[1]], about[order[2]]};
}

}  // namespace

std::vector<std::optional<JointWords>> joint_words(const Model& model, const intent::WholeModel& whole,
                                                   FaceMarks* face) {
  std::vector<std::optional<JointWords>> out(whole.joint.size());
  if (!model.skeleton || !whole.body) return out;
  const portrait::FaceFrame frame = front_of(model);
  const JointNames names(model, whole, frame, face);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::size_t j = whole.joint[i];
    if (j == intent::k_no_partner || whole.group[i] != i || names[j].kind == JointKind::face) continue;
    std::array<ModelVector, 3> axes{};
    for (int k = 0; k < 3; ++k) {
      ModelVector own(0);
      own[k] = 1;
      axes[static_cast<std::size_t>(k)] = frame.turned(whole.body->rest()[j].turn * own);
    }
    const auto deeds = deeds_of_turns(names[j].kind, axes, frame.turned(whole.body->bone(j, {})));
    for (std::size_t k = 0; k < 3; ++k)
      out[i + k] = JointWords{names[j].what + said_of(names[j].what, deeds[k]), names[j].side};
  }
  return out;
}

}  // namespace penpose::document
