#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <list>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace penpose::app {

/// Small pictures of files, made by a thread of its own that nobody waits for.
class Thumbnails {
 public:
  static constexpr int k_px = 96;
  /// RGBA, k_px by k_px; empty: the file has none.
  using Pixels = std::vector<std::uint8_t>;

  Thumbnails() = default;
  /// Waits for the picture that is being made, at most.
  ~Thumbnails();
  Thumbnails(const Thumbnails&) = delete;
  Thumbnails& operator=(const Thumbnails&) = delete;

  /// Whether files of that name may have one: models, projects and pictures.
  [[nodiscard]] static bool may_have(const std::string& name);
  /// The picture of a file; null while there is none yet, which is then made, the last asked for first. `stamp`: when
  /// it was changed; another one makes it anew. It stays until k_kept others were asked for.
  [[nodiscard]] const Pixels* of(const std::string& path, std::int64_t stamp);
  /// Some are still to be made.
  [[nodiscard]] bool waits() const;

 private:
  static constexpr std::size_t k_kept = 200;
  static constexpr std::size_t k_most_asked = 60;
  using Key = std::pair<std::string, std::int64_t>;
  void work();

  std::map<Key, Pixels> made_;
  std::list<Key> order_;  ///< of `made_`, the oldest first

  mutable std::mutex guard_;
  std::condition_variable asked_;
  std::deque<Key> wanted_;                       // guarded, the next one last
  std::vector<std::pair<Key, Pixels>> arrived_;  // guarded
  std::optional<Key> making_;                    // guarded
  bool ends_ = false;                            // guarded
  std::thread thread_;
};

/// The picture of a file, in a square, of what is in it: a picture made smaller, a model at rest from the front. Empty
/// where it is none that can be read, or so large that it would take long.
[[nodiscard]] Thumbnails::Pixels thumbnail_of(const std::string& path);

}  // namespace penpose::app
