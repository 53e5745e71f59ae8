#include "ui/film/read_film.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <string_view>

#include "core/base/numbers.h"
#include "ui/files/folder_files.h"

namespace penpose::film {
namespace {

namespace fs = std::filesystem;

/// The name of a file for ffmpeg, in which % is a number.
std::string pattern_in(const std::string& folder) {
  std::string pattern;
  for (const char c : folder) pattern.append(c == '%' ? 2 : 1, c);
  return pattern + "/%06d.jpg";
}

base::Result<std::vector<std::string>> pictures_in(const std::string& folder) {
  const auto all = files::folder_files(folder, [](const fs::path& one) { return one.extension() == ".jpg"; });
  if (!all) return all.error();
  return *all ? **all : std::vector<std::string>();
}

/// Looks, while ffmpeg works, whether it is to stop.
class Bounded {
 public:
  Bounded(const std::string& folder, const FilmBounds& bounds, const Stop& stop, std::atomic<std::size_t>& done)
      : folder_(folder), bounds_(bounds), stop_(stop), done_(done) {}

  bool operator()() {
    if (stop_ && stop_()) return true;
    // Asked fifty times a second; a folder is looked at less often.
    constexpr int k_every = 25;
    if (++asked_ % k_every != 0) return false;
    look();
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - began_;
    beyond_ = bytes_ > bounds_.bytes || passed.count() > bounds_.seconds;
    return beyond_;
  }
  [[nodiscard]] bool beyond() const { return beyond_; }

 private:
  void look() {
    std::error_code code;
    std::size_t count = 0;
    bytes_ = 0;
    for (fs::directory_iterator at(folder_, code), end; !code && at != end; at.increment(code)) {
      std::error_code gone;
      const auto size = at->file_size(gone);
      if (!gone) bytes_ += size;
      ++count;
    }
    done_ = count;
  }

  const std::string& folder_;
  const FilmBounds& bounds_;
  const Stop& stop_;
  std::atomic<std::size_t>& done_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  std::uint64_t bytes_ = 0;
  int asked_ = 0;
  bool beyond_ = false;
};

std::vector<std::string> words_for(const std::string& path, double rate, const std::string& folder,
                                   const FilmBounds& bounds) {
  std::error_code code;
  const std::string side = std::to_string(bounds.side_px);
  const std::string fitted = "fps=" + base::format_double(rate) + ",scale=w='min(" + side + ",iw)':h='min(" + side +
                             ",ih)':force_original_aspect_ratio=decrease";
  // A file of the disk alone, whatever a film names.
  return {"-protocol_whitelist",
          "file",
          "-i",
          "file:" + fs::absolute(path, code).string(),
          "-map",
          "0:v:0",
          "-vf",
          fitted,
          "-q:v",
          "3",
          "-frames:v",
          std::to_string(bounds.pictures),
          "-f",
          "image2",
          pattern_in(folder)};
}

}  // namespace

bool is_film(base::Bytes bytes) {
  const auto has = [&](std::size_t at, std::string_view text) {
    return bytes.size() >= at + text.size() &&
           std::equal(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                      [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
  };
  return has(4, "ftyp") || has(4, "moov") || has(0, "\x1A\x45\xDF\xA3") || has(0, "GIF8") ||
         (has(0, "RIFF") && has(8, "AVI "));
}

base::Result<FilmPictures> read_film(const std::string& path, double rate, const std::string& folder,
                                     const FilmBounds& bounds, const Stop& stop, std::atomic<std::size_t>& done) {
  std::error_code code;
  fs::create_directories(folder, code);
  if (code) return base::Error{"there is no place for the pictures of the film", "", "make room for " + folder};
  auto ffmpeg = Ffmpeg::start(words_for(path, rate, folder, bounds), {});
  if (!ffmpeg) {
    if (has_ffmpeg()) return ffmpeg.error();
    return base::Error{"films need ffmpeg, which is not installed", "",
                       "install the package ffmpeg, or open numbered pictures"};
  }
  Bounded bounded(folder, bounds, stop, done);
  const auto read = ffmpeg->finish([&] { return bounded(); });
  if (!read && !bounded.beyond()) {
    if (stop && stop()) return given_up();
    return base::Error{"the film cannot be read: " + read.error().what, "",
                       "write it as .mp4, or as numbered pictures"};
  }
  FilmPictures pictures;
  auto files = pictures_in(folder);
  if (!files) return files.error();
  pictures.files = std::move(*files);
  // Of the last one nobody knows whether it is whole.
  if (bounded.beyond() && !pictures.files.empty()) pictures.files.pop_back();
  pictures.cut = bounded.beyond() || pictures.files.size() >= bounds.pictures;
  done = pictures.files.size();
  if (pictures.files.empty()) return base::Error{"the film has no pictures", "", "open another one"};
  return pictures;
}

}  // namespace penpose::film
