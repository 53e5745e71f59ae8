#pragma once

#include "tests/judges/rigs/rig.h"

namespace penpose::judges {

[[nodiscard]] Rig make_split();
[[nodiscard]] Rig make_summed();
[[nodiscard]] Rig make_one_sided();
[[nodiscard]] Rig make_weak();
[[nodiscard]] Rig make_no_brows();
[[nodiscard]] Rig make_emotes();
[[nodiscard]] Rig make_toon();
[[nodiscard]] Rig make_arkit();
[[nodiscard]] Rig make_visemes();
[[nodiscard]] Rig make_many();
[[nodiscard]] Rig make_jaw_bone();
[[nodiscard]] Rig make_walker();
[[nodiscard]] Rig make_trunk();

}  // namespace penpose::judges
