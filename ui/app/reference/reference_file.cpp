#include "ui/app/reference/reference_file.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <utility>

#include "ui/app/view/backdrop.h"
#include "ui/files/files.h"
#include "ui/files/folder_files.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_kept_films = 8;
/// In a folder whose film was longer than what was taken of it.
constexpr const char* k_cut_mark = "cut";

/// The films that were used last are kept.
void forget_old_films(const std::string& cache) {
  std::error_code code;
  std::vector<std::pair<fs::file_time_type, fs::path>> films;
  for (fs::directory_iterator at(cache, code), end; !code && at != end; at.increment(code)) {
    std::error_code gone;
    films.emplace_back(at->last_write_time(gone), at->path());
  }
  std::sort(films.begin(), films.end());
  for (std::size_t i = 0; i + k_kept_films <= films.size(); ++i) fs::remove_all(films[i].second, code);
}

base::Result<ReferenceFile> pictures_of(ReferenceFile file, const std::string& folder) {
  auto found = files::folder_files(folder, [](const fs::path& one) { return one.extension() == ".jpg"; });
  if (!found) return found.error();
  if (*found) file.frames = std::move(**found);
  std::error_code code;
  file.cut = fs::exists(fs::path(folder) / k_cut_mark, code);
  // Used again, it is kept for longer.
  fs::last_write_time(folder, fs::file_time_type::clock::now(), code);
  return file;
}

base::Result<ReferenceFile> read_film_file(const std::string& path, int rate, const std::string& cache,
                                           const film::Stop& stop, std::atomic<std::size_t>& done) {
  ReferenceFile file;
  {
    const auto bytes = files::read_plain_file(path, k_most_film_bytes);
    if (!bytes) return bytes.error();
    file.content = base::hash_bytes(*bytes);
  }
  const std::string folder = (fs::path(cache) / (file.content.hex() + "-" + std::to_string(rate))).string();
  std::error_code code;
  if (fs::is_directory(folder, code)) return pictures_of(std::move(file), folder);
  fs::create_directories(cache, code);
  forget_old_films(cache);
  // It has its name when it is complete.
  std::string part = folder + ".part-XXXXXX";
  if (::mkdtemp(part.data()) == nullptr)
    return base::Error{"there is no place for the pictures of the film", "", "make room for " + cache};
  const auto read = film::read_film(path, rate, part, {}, stop, done);
  if (!read) {
    fs::remove_all(part, code);
    return read.error();
  }
  if (read->cut) std::ofstream(fs::path(part) / k_cut_mark) << "\n";
  fs::rename(part, folder, code);
  return pictures_of(std::move(file), code ? part : folder);
}

}  // namespace

base::Result<ReferenceFile> open_reference_picture(const std::string& path) {
  const auto bytes = files::read_plain_file(path, files::k_most_picture_bytes);
  if (!bytes) return bytes.error();
  return ReferenceFile{base::hash_bytes(*bytes), frames_beside(path), false};
}

bool is_film_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<char> head(16);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  const std::vector<std::uint8_t> bytes(head.begin(), head.begin() + file.gcount());
  return film::is_film(bytes);
}

FilmReader::FilmReader(const std::string& path, int rate, const std::string& cache) : path_(path) {
  read_ = std::async(std::launch::async, [this, rate, cache] {
    return read_film_file(
        path_, rate, cache, [this] { return stops_.load(); }, done_);
  });
}

FilmReader::~FilmReader() {
  cancel();
  if (read_.valid()) read_.wait();
}

bool FilmReader::ready() const {
  return read_.valid() && read_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace penpose::app
