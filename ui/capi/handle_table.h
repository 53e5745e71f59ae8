#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <shared_mutex>
#include <vector>

#include "core/base/interface.h"

namespace penpose::capi {

enum class Kind : std::uint8_t { character = 1, live = 2, tablet = 3, animation = 4 };

/// What a handle names. Calls with one handle wait for each other.
struct Object : base::Interface {
  explicit Object(Kind of) : kind(of) {}

  const Kind kind;
  std::mutex busy;
};

/// Objects by numbers that are never given out twice: the kind, how often the place was used before, the place. May be
/// used by several threads.
class HandleTable {
 public:
  /// Throws std::bad_alloc, and then nothing has changed.
  std::uint64_t add(std::shared_ptr<Object> object);
  /// Null where the handle was freed or never given out.
  [[nodiscard]] std::shared_ptr<Object> find(std::uint64_t handle) const;
  /// False where there was nothing to free.
  bool remove(std::uint64_t handle);
  [[nodiscard]] std::size_t size() const;

 private:
  struct Place {
    std::uint32_t generation = 1;
    std::shared_ptr<Object> object;
  };
  mutable std::shared_mutex lock_;
  std::vector<Place> places_;
  std::vector<std::uint32_t> unused_;  ///< always has room for every place
};

}  // namespace penpose::capi
