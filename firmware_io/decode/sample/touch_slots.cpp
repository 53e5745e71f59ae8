#include "firmware_io/decode/sample/touch_slots.h"

#include <algorithm>

namespace penpose::decode {

std::optional<std::size_t> TouchSlots::slot_of(std::int32_t key) {
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (slots_[i].active && slots_[i].key == key) return i;
  }
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (slots_[i].active || is_used(i)) continue;
    slots_[i].key = key;
    return i;
  }
  return std::nullopt;
}

bool TouchSlots::any_active() const {
  return std::any_of(slots_.begin(), slots_.end(), [](const Slot& slot) { return slot.active; });
}

void TouchSlots::set(std::size_t slot, bool active) {
  Slot& one = slots_[slot];
  one.frame = frame_;
  if (active && !one.active) one.contact.id = next_id_++;
  one.active = active;
  news_ = true;
}

void TouchSlots::move(std::size_t slot, std::int32_t x, std::int32_t y) {
  slots_[slot].contact.x = x;
  slots_[slot].contact.y = y;
  news_ = true;
}

void TouchSlots::end_frame(bool drop_unused) {
  if (drop_unused) {
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      if (!is_used(i)) slots_[i].active = false;
    }
  }
  ++frame_;
}

void TouchSlots::publish() {
  news_ = false;
  visible_.clear();
  for (const Slot& slot : slots_) {
    if (slot.active) visible_.push_back(slot.contact);
  }
}

void TouchSlots::clear() {
  std::fill(slots_.begin(), slots_.end(), Slot{});
  visible_.clear();
  news_ = false;
  frame_ = 1;
  next_id_ = 1;
}

}  // namespace penpose::decode
