#pragma once

#include <string>
#include <string_view>
#include <sys/types.h>
#include <utility>

namespace penpose::files {

/// A file that takes its name only when it is whole. Until then it has none where the file system can do that, else a
/// random one that nobody can have taken before; a killed program leaves next to nothing, and the next one that writes
/// into the folder takes that away.
class FreshFile {
 public:
  /// -1 in `descriptor()` with errno where the folder cannot be written to.
  FreshFile(const std::string& path, mode_t mode);
  FreshFile(const FreshFile&) = delete;
  FreshFile& operator=(const FreshFile&) = delete;
  /// What was not placed is gone.
  ~FreshFile();

  [[nodiscard]] int descriptor() const { return file_; }
  /// Gives it its name, in place of what has that. False with errno; then all is as it was.
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
