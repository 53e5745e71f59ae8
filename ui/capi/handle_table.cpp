#include "ui/capi/handle_table.h"

#include <limits>
#include <new>
#include <utility>

namespace penpose::capi {
namespace {

constexpr unsigned k_place_bits = 24;
constexpr unsigned k_generation_bits = 32;
constexpr std::uint64_t k_most_places = std::uint64_t{1} << k_place_bits;

std::uint64_t handle_of(Kind kind, std::uint32_t generation, std::uint32_t place) {
  return (static_cast<std::uint64_t>(kind) << (k_place_bits + k_generation_bits)) |
         (std::uint64_t{generation} << k_place_bits) | place;
}
std::uint32_t place_of(std::uint64_t handle) { return static_cast<std::uint32_t>(handle & (k_most_places - 1)); }

}  // namespace

std::uint64_t HandleTable::add(std::shared_ptr<Object> object) {
  const std::unique_lock guard(lock_);
  if (unused_.empty()) {
    if (places_.size() == k_most_places) throw std::bad_alloc();
    // Room first, so that neither this nor a later removal can fail half-way.
    if (unused_.capacity() <= places_.size()) unused_.reserve(2 * places_.size() + 16);
    places_.emplace_back();
    unused_.push_back(static_cast<std::uint32_t>(places_.size() - 1));
  }
  const std::uint32_t number = unused_.back();
  unused_.pop_back();
  Place& place = places_[number];
  const std::uint64_t handle = handle_of(object->kind, place.generation, number);
  place.object = std::move(object);
  return handle;
}

std::shared_ptr<Object> HandleTable::find(std::uint64_t handle) const {
  const std::shared_lock guard(lock_);
  const std::uint32_t number = place_of(handle);
  if (number >= places_.size()) return nullptr;
  const Place& place = places_[number];
  if (!place.object || handle_of(place.object->kind, place.generation, number) != handle) return nullptr;
  return place.object;
}

bool HandleTable::remove(std::uint64_t handle) {
  std::shared_ptr<Object> gone;
  {
    const std::unique_lock guard(lock_);
    const std::uint32_t number = place_of(handle);
    if (number >= places_.size()) return false;
    Place& place = places_[number];
    if (!place.object || handle_of(place.object->kind, place.generation, number) != handle) return false;
    gone = std::move(place.object);
    place.object = nullptr;
    // A place whose numbers are used up is never used again.
    if (place.generation < std::numeric_limits<std::uint32_t>::max()) {
      ++place.generation;
      unused_.push_back(number);
    }
  }
  // A call that has it ends first. Freeing it takes a while, and holds up no other handle.
  { const std::lock_guard wait(gone->busy); }
  return true;
}

std::size_t HandleTable::size() const {
  const std::shared_lock guard(lock_);
  std::size_t count = 0;
  for (const Place& place : places_) count += place.object != nullptr;
  return count;
}

}  // namespace penpose::capi
