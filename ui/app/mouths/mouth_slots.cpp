#include "ui/app/mouths/mouth_slots.h"

#include <algorithm>

namespace penpose::app {

using speech::NineMouth;

const std::array<MouthSlot, speech::k_nine> k_mouth_slots{{
    {NineMouth::closed, "m, b, p", "lips pressed together"},
    {NineMouth::a, "ah, I", "wide open, the jaw down"},
    {NineMouth::e, "eh, ee", "half open, the corners apart"},
    {NineMouth::o, "oh, aw", "open and a little round"},
    {NineMouth::f, "f, v", "the lower lip under the upper teeth"},
    {NineMouth::l, "l", "half open, the tongue up behind the teeth"},
    {NineMouth::consonants, "k, s, t, n", "hardly open, the teeth nearly together"},
    {NineMouth::u, "oo, w", "small and puckered"},
    {NineMouth::rest, "pauses", "at ease, closed or just parted"},
}};

const MouthSlot* next_slot(const document::Mouths& mouths) {
  const auto* next = std::find_if(k_mouth_slots.begin(), k_mouth_slots.end(), [&](const MouthSlot& slot) {
    return document::find_mouth(mouths, slot.name()) == nullptr;
  });
  return next == k_mouth_slots.end() ? nullptr : &*next;
}

}  // namespace penpose::app
