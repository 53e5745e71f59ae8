#pragma once

#include <string>
#include <string_view>
#include <sys/types.h>

#include "core/base/result.h"

namespace penpose::files {

/// A file that grows: whatever ends the program, the file holds the pieces appended so far. A file that was there
/// before is never written over.
class AppendFile {
 public:
  /// A new file, or a pipe or device that is there. Errors: there is a file of that name; the folder cannot be written
  /// to, or has no room for the first piece.
  [[nodiscard]] static base::Result<AppendFile> create(const std::string& path, std::string_view first_piece);

  /// A new file with nothing in it yet. Errors: there is anything of that name.
  [[nodiscard]] static base::Result<AppendFile> create_new(const std::string& path);

  /// The session that is there, to add to it. What a crash cut off in its last line goes, unless it is a whole report,
  /// which a replay counts. Errors: it is not there or cannot be written to.
  [[nodiscard]] static base::Result<AppendFile> go_on(const std::string& path);

  AppendFile(AppendFile&& other) noexcept;
  AppendFile& operator=(AppendFile&& other) noexcept;
  ~AppendFile();

  /// `sync`: and flush. Errors: the disk is full; then the file holds nothing of the piece, so that it can be tried
  /// again. What cannot be taken back, as from a pipe, ends the file: all later pieces are errors.
  base::Status append(std::string_view piece, bool sync = false);
  /// Waits until the disk has what was appended.
  base::Status flush();

 private:
  explicit AppendFile(int file) : file_(file) {}
  /// The file as it was before a piece that failed.
  void take_back(off_t end);

  int file_;
};

}  // namespace penpose::files
