#pragma once

#include <cstdint>
#include <vector>

#include "core/io/fbx/fbx_scene.h"

namespace penpose::io {

/// FBX counts time in these parts of a second.
inline constexpr double k_fbx_ticks = 46186158000.0;

/// A curve of keys: straight, stepped, or splines by the slopes and weights that the file gives or leaves to the
/// reader. Before and after its keys it stays, goes on straight, or repeats them.
class FbxCurve {
 public:
  /// Nothing to use where the record's arrays do not fit each other or times do not ascend.
  explicit FbxCurve(const FbxObject& object);

  [[nodiscard]] bool usable() const { return !keys_.empty(); }
  [[nodiscard]] double first_s() const { return keys_.front().time_s; }
  [[nodiscard]] double last_s() const { return keys_.back().time_s; }
  void add_times(std::vector<double>& times) const;
  /// The moments at which its value jumps.
  void add_jumps(std::vector<double>& times) const;
  [[nodiscard]] double at(double time_s) const;
  /// How it goes between two moments with no key in between.
  enum class Way { still, straight, bent };
  [[nodiscard]] Way way_between(double from_s, double to_s) const;
  /// Returns true if every key holds its value until the next one.
  [[nodiscard]] bool steps() const;
  /// Returns true if the curve moves after its last key or before its first one.
  [[nodiscard]] bool goes_on() const { return before_.form != 'C' || after_.form != 'C'; }
  /// Returns true if a key has another value than this.
  [[nodiscard]] bool leaves(double value) const;
  [[nodiscard]] double least() const;
  [[nodiscard]] double greatest() const;

 private:
  enum class Form : std::uint8_t { step, step_to_next, line, spline };
  struct Key {
    double time_s = 0, value = 0;
    Form form = Form::line;
    float leaves = 0, arrives = 0;  ///< slopes a second, behind this key and before the next one
    float leaves_weight = 1.F / 3, arrives_weight = 1.F / 3;  ///< lengths of both, as shares of the time between
  };
  struct Beyond {
    char form = 'C';  ///< C stays, K straight on, R repeats, A repeats from where it ends, M mirrors
    std::int64_t times = -1;
  };
  static Beyond beyond_of(const FbxRecord& record, const char* name);
  void take_slopes(const FbxRecord& record);
  [[nodiscard]] double between(std::size_t key, double time_s) const;
  [[nodiscard]] double within(double time_s) const;
  [[nodiscard]] double outside(double time_s, const Beyond& beyond, bool before) const;

  std::vector<Key> keys_;
  Beyond before_, after_;
};

}  // namespace penpose::io
