#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace penpose::cli {

/// A file that grows: whatever ends the program, the file holds the pieces appended so far. Until the first piece is on
/// the disk a file that was there before stays as it was.
class AppendFile {
 public:
  /// Errors: the folder cannot be written to.
  [[nodiscard]] static base::Result<AppendFile> create(const std::string& name, std::string_view first_piece);

  /// The same with nothing in it yet, and never in place of a file that is there, which is an error.
  [[nodiscard]] static base::Result<AppendFile> create_new(const std::string& path);

  /// The session that is there, to add to it. What a crash cut off in its last line goes, unless it is a whole report,
  /// which a replay counts. Errors: it is not there or cannot be written to.
  [[nodiscard]] static base::Result<AppendFile> go_on(const std::string& path);

  AppendFile(AppendFile&& other) noexcept;
  AppendFile& operator=(AppendFile&& other) noexcept;
  ~AppendFile();

  /// `sync`: and flush. Errors: the disk is full.
  base::Status append(std::string_view piece, bool sync = false);
  /// Waits until the disk has what was appended.
  base::Status flush();

 private:
  explicit AppendFile(int file) : file_(file) {}

  int file_;
};

}  // namespace penpose::cli
