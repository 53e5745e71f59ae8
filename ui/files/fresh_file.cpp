#include "ui/files/fresh_file.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <dirent.h>
#include <fcntl.h>
#include <mutex>
#include <set>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

namespace penpose::files {
namespace {

// Short and the same for every file, so that a name of 255 letters can be written, too.
constexpr std::string_view k_head = ".penpose-";
constexpr std::string_view k_tail = ".part";
constexpr int k_tries = 100;

std::string random_name() {
  std::array<std::uint8_t, 8> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) return {};
  std::string name(k_head);
  for (const std::uint8_t byte : bytes) {
    char digits[3];
    std::snprintf(digits, sizeof digits, "%02x", byte);
    name += digits;
  }
  return name += k_tail;
}

bool is_leftover_name(std::string_view name) {
  return name.size() == k_head.size() + 16 + k_tail.size() && name.starts_with(k_head) && name.ends_with(k_tail);
}

/// Once a folder: a sequence of pictures writes into one of many files.
void remove_leftovers_once(int folder) {
  static std::mutex mutex;
  static std::set<std::pair<dev_t, ino_t>> done;
  struct stat facts {};
  if (::fstat(folder, &facts) != 0) return;
  const std::scoped_lock lock(mutex);
  if (done.emplace(facts.st_dev, facts.st_ino).second) remove_leftovers(folder);
}

}  // namespace

void remove_leftovers(int folder) {
  const int again = ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  DIR* entries = again < 0 ? nullptr : ::fdopendir(again);
  if (entries == nullptr) {
    if (again >= 0) ::close(again);
    return;
  }
  while (const dirent* entry = ::readdir(entries)) {
    if (!is_leftover_name(entry->d_name)) continue;
    const int file = ::openat(folder, entry->d_name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    struct stat facts {};
    // Whoever still writes it holds its lock.
    if (file >= 0 && ::fstat(file, &facts) == 0 && S_ISREG(facts.st_mode) && facts.st_uid == ::geteuid() &&
        ::flock(file, LOCK_EX | LOCK_NB) == 0) {
      ::unlinkat(folder, entry->d_name, 0);
    }
    if (file >= 0) ::close(file);
  }
  ::closedir(entries);
}

FreshFile::FreshFile(const std::string& path, mode_t mode) {
  const std::size_t slash = path.rfind('/');
  folder_ = slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
  name_ = slash == std::string::npos ? path : path.substr(slash + 1);
  folder_file_ = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder_file_ < 0 && errno == EACCES) folder_file_ = ::open(folder_.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
  if (folder_file_ < 0) return;
  remove_leftovers_once(folder_file_);
  // A file without a name gets one through /proc.
  errno = ENOENT;
  const bool can_link = ::access("/proc/self/fd", X_OK) == 0;
  if (can_link) file_ = ::openat(folder_file_, ".", O_TMPFILE | O_WRONLY | O_CLOEXEC, mode);
  if (file_ >= 0) {
    ::flock(file_, LOCK_EX | LOCK_NB);
  } else if (errno != ENOSPC && errno != EDQUOT && errno != EACCES && errno != EROFS) {
    static_cast<void>(make_named(mode));
  }
}

bool FreshFile::make_named(mode_t mode) {
  for (int i = 0; i < k_tries; ++i) {
    temporary_ = random_name();
    if (temporary_.empty()) break;
    file_ = ::openat(folder_file_, temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
    if (file_ < 0 && errno == EEXIST) continue;
    if (file_ < 0) break;
    // One that tidies up may have had it first.
    struct stat facts {};
    ::flock(file_, LOCK_EX);
    if (::fstat(file_, &facts) == 0 && facts.st_nlink > 0) return true;
    ::close(std::exchange(file_, -1));
  }
  temporary_.clear();
  return false;
}

bool FreshFile::link_as(const std::string& name) const {
  const std::string itself = "/proc/self/fd/" + std::to_string(file_);
  return ::linkat(AT_FDCWD, itself.c_str(), folder_file_, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

bool FreshFile::place() {
  if (temporary_.empty()) {
    if (link_as(name_)) return true;
    if (errno != EEXIST) return false;
    for (int i = 0; i < k_tries && temporary_.empty(); ++i) {
      std::string name = random_name();
      // From here to the end nothing may need memory, or the name would stay.
      if (!name.empty() && link_as(name)) temporary_ = std::move(name);
      if (temporary_.empty() && errno != EEXIST) return false;
    }
  }
  if (::renameat(folder_file_, temporary_.c_str(), folder_file_, name_.c_str()) != 0) return false;
  temporary_.clear();
  return true;
}

FreshFile::~FreshFile() {
  const int error = errno;
  if (!temporary_.empty()) ::unlinkat(folder_file_, temporary_.c_str(), 0);
  if (file_ >= 0) ::close(file_);
  if (folder_file_ >= 0) ::close(folder_file_);
  errno = error;
}

}  // namespace penpose::files
