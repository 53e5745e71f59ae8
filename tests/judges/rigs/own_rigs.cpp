#include <array>

#include "tests/judges/rigs/held_out/held_out_rigs.h"
#include "tests/judges/rigs/seen/seen_rigs.h"

namespace penpose::judges {

std::span<const RigMaker> own_rigs() {
  static constexpr std::array<RigMaker, 20> makers{{
      {"split", Group::seen, make_split},
      {"summed", Group::seen, make_summed},
      {"one_sided", Group::seen, make_one_sided},
      {"weak", Group::seen, make_weak},
      {"no_brows", Group::seen, make_no_brows},
      {"emotes", Group::seen, make_emotes},
      {"toon", Group::seen, make_toon},
      {"arkit", Group::seen, make_arkit},
      {"visemes", Group::seen, make_visemes},
      {"many", Group::seen, make_many},
      {"jaw_bone", Group::seen, make_jaw_bone},
      {"walker", Group::seen, make_walker},
      {"trunk", Group::seen, make_trunk},
      {"facs", Group::held_out, make_facs},
      {"creature", Group::held_out, make_creature},
      {"doubles", Group::held_out, make_doubles},
      {"correctives", Group::held_out, make_correctives},
      {"face_bones", Group::held_out, make_face_bones},
      {"expressions", Group::held_out, make_expressions},
      {"quadruped", Group::held_out, make_quadruped},
  }};
  return makers;
}

}  // namespace penpose::judges
