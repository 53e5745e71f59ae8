#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "replay/session_writer.h"

namespace penpose::cli {

/// A file that only grows: what has been appended is in it even if the program is killed, and after a synced piece even
/// if the power is cut.
class AppendFile {
 public:
  /// Makes the file. Errors: it exists already (nothing that was drawn is ever written over), the folder may not be
  /// written.
  static base::Result<std::unique_ptr<AppendFile>> create(const std::string& path);
  ~AppendFile();
  AppendFile(const AppendFile&) = delete;
  AppendFile& operator=(const AppendFile&) = delete;

  /// Errors: the disk is full, or went away. What was appended before stays.
  base::Status append(std::string_view text, bool sync);
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  AppendFile(int descriptor, std::string path) : descriptor_(descriptor), path_(std::move(path)) {}

  int descriptor_;
  std::string path_;
};

}  // namespace penpose::cli
