#include "core/portrait/sketch/habits.h"

#include <array>

namespace penpose::portrait {

std::span<const PartHabit> part_habits() {
  static constexpr std::array k_habits{
      PartHabit{FacePart::eye, true, 0.5, 0.10, 0.0, 0.10, 0.5, 0.45, 0.25, 1.0, 0.0},
      PartHabit{FacePart::eye, true, 0.5, 0.08, 0.0, 0.12, 0.85, 0.2, 1.2, 0.35, 1.0},
      PartHabit{FacePart::pupil, true, 0.5, 0.12, 0.02, 0.12, 0.15, 0.6, 0.16, 0.6, 0.3},
      PartHabit{FacePart::pupil, true, 0.5, 0.12, 0.0, 0.1, 0.02, 0.5, 0.25, 0.5, 0.4},
      PartHabit{FacePart::pupil, true, 0.5, 0.1, 0.0, 0.08, 0.06, 0.5, 0.06, 0.5, 0.5},
      PartHabit{FacePart::pupil, true, 0.46, 0.12, 0.1, 0.2, 0.3, 0.35, 0.45, 0.4, 0.8},
      PartHabit{FacePart::fold, true, 0.5, 0.15, -0.17, 0.1, 0.45, 0.5, 0.08, 1.0, 1.2},
      PartHabit{FacePart::fold, true, 0.5, 0.15, 0.22, 0.1, 0.4, 0.5, 0.06, 1.0, 1.5},
      PartHabit{FacePart::brow, true, 0.52, 0.14, -0.45, 0.17, 0.5, 0.4, 0.12, 0.65, 0.0, LineForm::open},
      PartHabit{FacePart::brow, true, 0.52, 0.14, -0.45, 0.17, 0.55, 0.4, 0.14, 0.45, 0.2, LineForm::closed},
      PartHabit{FacePart::brow, true, 0.52, 0.18, -0.42, 0.12, 0.1, 0.6, 0.08, 0.6, 0.8},
      PartHabit{FacePart::brow, true, 0.55, 0.15, -0.9, 0.2, 0.7, 0.35, 0.2, 0.6, 0.8, LineForm::open},
      PartHabit{FacePart::nose, false, 0.0, 0.12, 0.48, 0.22, 0.15, 0.8, 0.25, 0.9, 0.3},
      PartHabit{FacePart::nose, false, 0.0, 0.12, 0.5, 0.25, 0.7, 0.35, 1.1, 0.35, 0.8},
      PartHabit{FacePart::nose, true, 0.15, 0.08, 0.6, 0.15, 0.1, 0.6, 0.1, 0.8, 0.8},
      PartHabit{FacePart::mouth, false, 0.0, 0.14, 1.12, 0.25, 0.8, 0.45, 0.15, 1.1, 0.0},
      PartHabit{FacePart::mouth, false, 0.0, 0.12, 0.9, 0.25, 0.35, 0.5, 0.12, 1.1, 0.4},
      PartHabit{FacePart::corner, true, 0.5, 0.15, 1.1, 0.22, 0.1, 0.6, 0.1, 0.6, 1.0},
      PartHabit{FacePart::cheek, true, 0.7, 0.2, 0.65, 0.25, 0.25, 0.6, 0.2, 0.8, 1.5},
      PartHabit{FacePart::outline, false, 0.0, 0.25, 0.5, 0.45, 2.4, 0.3, 2.7, 0.4, 0.0},
      PartHabit{FacePart::outline, true, 0.58, 0.2, 0.6, 0.3, 1.1, 0.3, 2.2, 0.35, 0.6, LineForm::open},
      PartHabit{FacePart::outline, false, 0.0, 0.25, 1.2, 0.4, 2.0, 0.3, 1.3, 0.5, 0.3, LineForm::open},
      PartHabit{FacePart::outline, false, 0.0, 0.2, 1.6, 0.2, 1.4, 0.3, 0.4, 0.6, 0.6, LineForm::open},
      PartHabit{FacePart::around, true, 1.35, 0.25, 0.3, 0.3, 0.3, 0.5, 0.6, 0.5, 0.8},
      PartHabit{FacePart::around, false, 0.0, 0.4, -0.9, 0.35, 1.8, 0.5, 0.8, 0.8, 0.8},
      PartHabit{FacePart::around, true, 0.5, 0.25, 2.2, 0.35, 0.15, 0.9, 0.6, 0.6, 0.8},
  };
  return k_habits;
}

}  // namespace penpose::portrait
