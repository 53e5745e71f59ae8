#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "ui/files/fresh_file.h"

namespace penpose::film {

/// A file that another program fills, and that takes its name once it is complete; the file that was there stays until
/// then.
class FilmOutput {
 public:
  /// Errors: it cannot be written.
  static base::Result<FilmOutput> begin(const std::string& path);
  [[nodiscard]] int descriptor() const { return file_->descriptor(); }
  [[nodiscard]] base::Status place();

 private:
  std::string path_;
  std::unique_ptr<files::FreshFile> file_;
};

/// Files that take their names together, from a folder beside them that is gone afterwards.
class PictureFolder {
 public:
  /// `output`: a path of which the folder counts; it is made where it is not there. Errors: it cannot be.
  static base::Result<PictureFolder> begin(const std::string& output);
  PictureFolder(PictureFolder&& other) noexcept;
  PictureFolder& operator=(PictureFolder&&) = delete;
  ~PictureFolder();

  /// Writes one of them. `path`: where it goes in the end. Errors of the file system.
  [[nodiscard]] base::Status write(const std::string& path, const std::vector<std::uint8_t>& bytes);
  [[nodiscard]] base::Status place();

 private:
  PictureFolder() = default;

  std::string folder_;      ///< where they go
  std::string unfinished_;  ///< where they are until then; empty: nowhere
  bool made_ = false;       ///< `folder_` was not there
  std::vector<std::string> names_;
};

}  // namespace penpose::film
