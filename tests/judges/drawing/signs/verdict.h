#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tests/judges/drawing/judged_face.h"
#include "tests/judges/drawing/signs/expression.h"

namespace penpose::judges::drawn {

/// recognised: all signs of what is meant. partly: half of them or more. wrong: fewer, or a sign of something else.
/// nothing: nothing moves that a person would see. left_out: the rig can show no sign of it.
/// Of a face at rest: still or moved.
enum class Verdict : unsigned char { recognised, partly, wrong, nothing, left_out, still, moved };
[[nodiscard]] const char* verdict_name(Verdict verdict);

/// Movements below this are not seen, per cent of the face's height.
inline constexpr double k_seen_percent = 1.0;
/// Beyond this turn the pose of the head is what is seen.
inline constexpr double k_head_degrees = 12.0;

struct Seen {
  Verdict verdict = Verdict::nothing;
  double moved_percent = 0;  ///< the farthest vertex, of the face's height
  bool torn = false;         ///< lips or lids run through one another as far as a person sees it
  double torn_percent = 0;   ///< how far they do, of the face's height
  double head_degrees = 0;
  Signs signs;
  std::vector<std::string> missing, other, cannot;  ///< signs: not there; of something else; that the rig cannot show
};

/// Looks at poses of one face as a person does, who knows no names of controls.
class FaceJudge {
 public:
  /// Errors: those of FaceSigns::make. Precondition: `face` outlives this.
  static base::Result<FaceJudge> make(const JudgedFace& face);

  /// What is seen of an expression (of a side, where one is meant) in a pose.
  [[nodiscard]] Seen look(const rig::Pose& pose, Expression meant, std::optional<Side> side);
  /// Whether a single control of the rig at an end of its range shows a sign, or two of them together do. Rigs of
  /// joints alone are taken for able.
  [[nodiscard]] bool can_show(const AnyOf& sign, std::optional<Side> side);

 private:
  FaceJudge(const JudgedFace& face, FaceSigns signs) : face_(&face), signs_(std::move(signs)) {}
  void find_ways();
  [[nodiscard]] bool turns_joints(const rig::Pose& pose) const;

  const JudgedFace* face_;
  FaceSigns signs_;
  CurvePlaces rest_;
  std::vector<CurvePlaces> ways_;  ///< the marks with one control at an end of its range, others at rest
  std::map<std::pair<const AnyOf*, int>, bool> known_;
};

}  // namespace penpose::judges::drawn
