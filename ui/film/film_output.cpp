#include "ui/film/film_output.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "ui/files/files.h"

namespace penpose::film {
namespace {

namespace fs = std::filesystem;

base::Error not_written(const std::string& why) {
  return {"cannot be written (" + why + ")", "", "check the folder, its permissions and the free space"};
}

}  // namespace

base::Result<FilmOutput> FilmOutput::begin(const std::string& path) {
  std::error_code code;
  if (fs::is_directory(path, code)) return base::Error{"is a folder", "", "name a file in it"};
  if (fs::exists(path, code) && !fs::is_regular_file(path, code)) {
    return base::Error{"is no plain file", "", "name a file"};
  }
  FilmOutput output;
  output.path_ = files::link_target(path);
  output.file_ = std::make_unique<files::FreshFile>(output.path_, 0666);
  if (output.descriptor() < 0) return not_written(std::generic_category().message(errno));
  return output;
}

base::Status FilmOutput::place() {
  if (::fsync(descriptor()) != 0 || !file_->place()) return not_written(std::generic_category().message(errno));
  files::flush_folder_of(path_);
  return base::Done{};
}

base::Result<PictureFolder> PictureFolder::begin(const std::string& output) {
  PictureFolder pictures;
  const fs::path folder = fs::path(output).parent_path();
  pictures.folder_ = folder.empty() ? "." : folder.string();
  std::error_code code;
  pictures.made_ = fs::create_directories(pictures.folder_, code);
  if (code) return base::Error{"its folder cannot be made (" + code.message() + ")", "", "name another folder"};
  std::string unfinished = pictures.folder_ + "/.penpose-film-XXXXXX";
  if (::mkdtemp(unfinished.data()) == nullptr) return not_written(std::generic_category().message(errno));
  pictures.unfinished_ = unfinished;
  return pictures;
}

PictureFolder::PictureFolder(PictureFolder&& other) noexcept
    : folder_(std::move(other.folder_)),
      unfinished_(std::exchange(other.unfinished_, {})),
      made_(std::exchange(other.made_, false)),
      names_(std::move(other.names_)) {}

PictureFolder::~PictureFolder() {
  std::error_code code;
  if (!unfinished_.empty()) fs::remove_all(unfinished_, code);
  // Only where it is empty.
  if (made_) ::rmdir(folder_.c_str());
}

base::Status PictureFolder::write(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  names_.push_back(fs::path(path).filename().string());
  return files::write_file(unfinished_ + "/" + names_.back(), bytes);
}

base::Status PictureFolder::place() {
  for (const std::string& name : names_) {
    std::error_code code;
    fs::rename(unfinished_ + "/" + name, folder_ + "/" + name, code);
    if (code) return not_written(code.message());
  }
  return base::Done{};
}

}  // namespace penpose::film
