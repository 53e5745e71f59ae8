#include <array>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <iterator>

#include "core/intent/reading/reader.h"
#include "core/rig/character_rig.h"

// Joints of both sides of a face.

namespace penpose::intent {

/// Joints of the two sides of a face turn as mirror images do: along the line between them alike, across it against
/// each other.
void Reader::make_joint_pairs() {
  if (turns_.empty()) return;
  const auto& character = dynamic_cast<const rig::CharacterRig&>(rig_);
  const std::size_t first = character.first_parameter(character.layers().size());
  const auto places = joints::places_of(*character.skeleton(), std::span(problem_.start).subspan(first));
  const auto partner_of = [&](const joints::Turn& turn) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t partner = whole_.partner[turn.first + k];
      if (partner == k_no_partner || whole_.joint[partner] == k_no_partner) continue;
      for (std::size_t t = 0; t < turns_.size(); ++t) {
        if (turns_[t].joint == whole_.joint[partner]) return t;
      }
    }
    return k_no_partner;
  };
  for (std::size_t a = 0; a < turns_.size(); ++a) {
    const std::size_t b = partner_of(turns_[a]);
    if (b == k_no_partner || b <= a) continue;
    const ModelVector apart = places[turns_[a].joint].at - places[turns_[b].joint].at;
    const ModelVector across = geometry::normalized(apart, ModelVector{1, 0, 0});
    std::array<RunVariable, 3> made;
    for (int k = 0; k < 3; ++k) {
      ModelVector axis{0};
      axis[k] = 1.0;
      // A turn is mirrored as an axial vector.
      const std::array<ModelVector, 2> axes{axis, across * (2.0 * glm::dot(across, axis)) - axis};
      RunVariable& one = made[static_cast<std::size_t>(k)];
      one.joints = 2;
      for (std::size_t side = 0; side < 2; ++side) {
        const std::size_t t = side == 0 ? a : b;
        const glm::dmat3 to_own =
            glm::inverse(turns_[t].axes) * glm::mat3_cast(glm::conjugate(places[turns_[t].joint].turn));
        const glm::dvec3 own = to_own * axes[side];
        for (std::size_t v = 0; v < parameters_.size(); ++v) {
          if (turn_of_[v] == t) one.parts.push_back({v, own[static_cast<int>(axis_of_[v])]});
        }
      }
    }
    if (made[0].parts.size() != 6) continue;
    std::move(made.begin(), made.end(), std::back_inserter(run_variables_));
  }
}

void Reader::add_joint_pair(std::size_t first) {
  Unit unit;
  unit.members = {first, first + 1, first + 2};
  unit.count = 3;
  charge_face(unit, true);
  choices_.units.push_back(unit);
}

}  // namespace penpose::intent
