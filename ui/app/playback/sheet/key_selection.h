#pragma once

#include <cstddef>
#include <set>
#include <utility>

#include "core/document/commands/list/time_commands.h"
#include "core/document/document.h"

namespace penpose::app {

/// Keys that are selected, each of one control at one moment.
class KeySelection {
 public:
  using Key = std::pair<double, std::size_t>;  ///< moment in seconds, parameter

  [[nodiscard]] bool empty() const { return keys_.empty(); }
  [[nodiscard]] std::size_t size() const { return keys_.size(); }
  [[nodiscard]] const std::set<Key>& keys() const { return keys_; }
  [[nodiscard]] bool has(double time_s, std::size_t parameter) const { return keys_.count({time_s, parameter}) > 0; }
  void add(double time_s, std::size_t parameter) { keys_.emplace(time_s, parameter); }
  void remove(double time_s, std::size_t parameter) { keys_.erase({time_s, parameter}); }
  void clear() { keys_.clear(); }
  /// Of the first key and of the last one. Precondition: not empty.
  [[nodiscard]] double first_s() const { return keys_.begin()->first; }
  [[nodiscard]] double last_s() const { return keys_.rbegin()->first; }

  /// Forgets keys that the document does not have (any more).
  void keep_known(const document::Document& document);
  /// As commands want them. Precondition: keys of the document.
  [[nodiscard]] document::OfKeys of(const document::Document& document) const;

 private:
  std::set<Key> keys_;
};

}  // namespace penpose::app
