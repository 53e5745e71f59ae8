#include "ui/cli/append_file.h"

#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

namespace penpose::cli {
namespace {

base::Error system_error(const std::string& what, const char* remedy) {
  return {what + " (" + std::generic_category().message(errno) + ")", "", remedy};
}

}  // namespace

base::Result<std::unique_ptr<AppendFile>> AppendFile::create(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0644);
  if (descriptor < 0 && errno == EEXIST) {
    return base::Error{"exists already and is not written over", "", "choose another name or move it away"};
  }
  if (descriptor < 0) return system_error("cannot be made", "check the folder and its permissions");
  return std::unique_ptr<AppendFile>(new AppendFile(descriptor, path));
}

AppendFile::~AppendFile() { ::close(descriptor_); }

base::Status AppendFile::append(std::string_view text, bool sync) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return system_error("cannot be written on", "free some space; the document is still in memory");
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  if (sync && ::fdatasync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) {
    return system_error("cannot be written through to the disk", "check the disk; the document is still in memory");
  }
  return base::Done{};
}

}  // namespace penpose::cli
