#include "ui/files/append_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "replay/trace/trace_reader.h"
#include "ui/files/files.h"

namespace penpose::files {
namespace {

base::Error append_error(const char* what) {
  return {std::string(what) + " (" + std::generic_category().message(errno) + ")", "",
          "check the folder, its permissions and the free space"};
}

}  // namespace

base::Result<AppendFile> AppendFile::create(const std::string& path, std::string_view first_piece) {
  // What is no plain file, a pipe or a device, is written to as it is.
  struct stat there {};
  if (::stat(path.c_str(), &there) == 0 && !S_ISREG(there.st_mode)) {
    AppendFile existing(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NOCTTY));
    if (existing.file_ < 0) return append_error("cannot be written");
    if (const auto status = existing.append(first_piece); !status) return status.error();
    return existing;
  }
  auto made = create_new(path);
  if (!made) return made;
  auto status = made->append(first_piece);
  if (status) status = made->flush();
  if (!status) {
    std::remove(path.c_str());
    return status.error();
  }
  return made;
}

base::Result<AppendFile> AppendFile::create_new(const std::string& path) {
  AppendFile made(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666));
  if (made.file_ < 0 && errno == EEXIST) {
    return base::Error{"exists already and is not written over", "", "choose another name or move it away"};
  }
  if (made.file_ < 0) return append_error("cannot be written");
  flush_folder_of(path);
  return made;
}

base::Result<AppendFile> AppendFile::go_on(const std::string& path) {
  AppendFile there(::open(path.c_str(), O_RDWR | O_APPEND | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  struct stat facts {};
  if (there.file_ < 0 || ::fstat(there.file_, &facts) != 0 || !S_ISREG(facts.st_mode))
    return append_error("cannot be written");
  off_t end = facts.st_size;
  char last = 0;
  std::string tail;
  while (end > 0 && ::pread(there.file_, &last, 1, end - 1) == 1 && last != '\n') {
    if (tail.size() <= replay::TraceReader::k_longest_line) tail += last;
    --end;
  }
  if (end == facts.st_size) return there;
  // A report that is all there was replayed, though its line never ended; anything else was not.
  std::reverse(tail.begin(), tail.end());
  std::vector<std::uint8_t> bytes;
  if (replay::parse_trace_line(tail, bytes).kind == replay::TraceLineKind::report) {
    if (const auto ended = there.append("\n"); !ended) return ended.error();
  } else if (::ftruncate(there.file_, end) != 0) {
    return append_error("cannot be written");
  }
  return there;
}

AppendFile::AppendFile(AppendFile&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
AppendFile& AppendFile::operator=(AppendFile&& other) noexcept {
  std::swap(file_, other.file_);
  return *this;
}
AppendFile::~AppendFile() {
  if (file_ >= 0) ::close(file_);
}

void AppendFile::take_back(off_t end) {
  if (end >= 0 && ::ftruncate(file_, end) == 0) return;
  ::close(file_);
  file_ = -1;
}

base::Status AppendFile::append(std::string_view piece, bool sync) {
  const off_t end = ::lseek(file_, 0, SEEK_END);
  while (!piece.empty()) {
    const ssize_t written = ::write(file_, piece.data(), piece.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      auto problem = append_error("cannot be written");
      take_back(end);
      return problem;
    }
    piece.remove_prefix(static_cast<std::size_t>(written));
  }
  if (!sync) return base::Done{};
  auto flushed = flush();
  if (!flushed) take_back(end);
  return flushed;
}

base::Status AppendFile::flush() {
  // Pipes and such have no disk.
  if (::fdatasync(file_) != 0 && errno != EINVAL && errno != EROFS) return append_error("cannot be written");
  return base::Done{};
}

}  // namespace penpose::files
