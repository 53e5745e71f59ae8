#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace penpose::decode {

/// A finger on the tablet. `id` stays the same from touch to lift and is not reused for a long time.
struct TouchContact {
  std::uint32_t id = 0;
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend bool operator==(const TouchContact&, const TouchContact&) = default;
};

/// A finger in a described report.
struct ReportedFinger {
  std::int32_t id = 0;
  std::int32_t x = 0;
  std::int32_t y = 0;
  bool tip = false;
  bool in_range = false;
  bool confident = true;
};

/// Follows fingers from frame to frame as Linux does (input-mt.c): a finger keeps its slot, and a slot keeps its last
/// values. A frame may span several reports; `publish` makes it visible. Never allocates after construction.
class TouchSlots {
 public:
  explicit TouchSlots(std::size_t count) : slots_(count) { visible_.reserve(count); }

  /// The slot of the finger with the device's number `key`: its current one, or else a free one. Nothing if all are
  /// taken.
  [[nodiscard]] std::optional<std::size_t> slot_of(std::int32_t key);
  [[nodiscard]] std::size_t size() const { return slots_.size(); }
  [[nodiscard]] bool is_active(std::size_t slot) const { return slots_[slot].active; }
  /// Whether this frame has set the slot already.
  [[nodiscard]] bool is_used(std::size_t slot) const { return slots_[slot].frame == frame_; }
  [[nodiscard]] bool any_active() const;

  void set(std::size_t slot, bool active);
  void move(std::size_t slot, std::int32_t x, std::int32_t y);
  /// Ends a frame; with `drop_unused`, slots that it has not set become free.
  void end_frame(bool drop_unused = false);
  /// Makes the present state visible.
  void publish();
  /// Whether anything was set since the last time.
  [[nodiscard]] bool has_news() const { return news_; }
  void clear();

  /// The fingers as last published, in order of their slots.
  [[nodiscard]] std::span<const TouchContact> contacts() const { return visible_; }

 private:
  struct Slot {
    bool active = false;
    std::int32_t key = 0;
    std::uint32_t frame = 0;
    TouchContact contact;
  };
  std::vector<Slot> slots_;
  std::vector<TouchContact> visible_;
  bool news_ = false;
  std::uint32_t frame_ = 1;
  std::uint32_t next_id_ = 1;
};

}  // namespace penpose::decode
