#include "core/inference/weights.h"

namespace penpose::inference {

std::span<const Scale> scales() {
  static constexpr std::array k_scales{Scale{"reach", &Weights::reach},
                                       Scale{"asks_from", &Weights::asks_from},
                                       Scale{"carried_from", &Weights::carried_from},
                                       Scale{"settled_share", &Weights::settled_share},
                                       Scale{"crosses_from", &Weights::crosses_from},
                                       Scale{"same", &Weights::same},
                                       Scale{"near", &Weights::near},
                                       Scale{"far", &Weights::far},
                                       Scale{"together", &Weights::together},
                                       Scale{"spans", &Weights::spans},
                                       Scale{"carries_more", &Weights::carries_more},
                                       Scale{"follows", &Weights::follows},
                                       Scale{"borne", &Weights::borne},
                                       Scale{"gives_up", &Weights::gives_up},
                                       Scale{"rivals", &Weights::rivals},
                                       Scale{"window", &Weights::window},
                                       Scale{"offered", &Weights::offered},
                                       Scale{"alike", &Weights::alike},
                                       Scale{"taught_margin", &Weights::taught_margin},
                                       Scale{"slide", &Weights::slide}};
  return k_scales;
}

}  // namespace penpose::inference
