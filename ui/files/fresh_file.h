#pragma once

#include <string>
#include <string_view>
#include <sys/types.h>
#include <utility>

#include "core/base/interface.h"

namespace penpose::files {

/// A file that appears under its name only when it is complete. Until then it is unnamed where the file system allows
/// that, else it has an unpredictable temporary name. A program that is killed meanwhile may leave such a file behind;
/// the next one to write into the folder removes it.
class FreshFile : base::Fixed {
 public:
  /// -1 in `descriptor()` with errno where the folder cannot be written to.
  FreshFile(const std::string& path, mode_t mode);
  /// Removes the file unless place() succeeded.
  ~FreshFile();

  [[nodiscard]] int descriptor() const { return file_; }
  /// Gives the file its name, replacing any file of that name. Returns false with errno set; then nothing has changed.
  [[nodiscard]] bool place();

 private:
  [[nodiscard]] bool link_as(const std::string& name) const;
  [[nodiscard]] bool make_named(mode_t mode);

  std::string folder_;
  std::string name_;
  std::string temporary_;  ///< the name that it has for now; empty: none
  int folder_file_ = -1;
  int file_ = -1;
};

/// Takes away what programs that were killed have left in a folder.
void remove_leftovers(int folder);

}  // namespace penpose::files
