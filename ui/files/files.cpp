#include "ui/files/files.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <iostream>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include "ui/files/fresh_file.h"
#include "ui/files/open_file.h"
#include "ui/files/process/exit_status.h"

namespace penpose::files {
namespace {

constexpr const char* k_check_disk = "check the folder, its permissions and the free space";

base::Error system_error(std::string what, std::string remedy) {
  return {what + " (" + std::generic_category().message(errno) + ")", "", std::move(remedy)};
}

base::Result<std::vector<std::uint8_t>> read_all(const base::Result<File>& file, std::uint64_t most) {
  if (!file) return file.error();
  const auto too_large = [&] {
    return base::Error{"is larger than " + std::to_string(most >> 20) + " MiB, the most that is read of such a file",
                       "", "name another file, or make this one smaller"};
  };
  struct stat facts {};
  if (::fstat(::fileno(file->get()), &facts) != 0) return system_error("cannot be read", "check the disk");
  const auto size = S_ISREG(facts.st_mode) ? static_cast<std::uint64_t>(facts.st_size) : 0;
  if (size > most) return too_large();
  // What is no file on a disk says no size, and a file may grow.
  std::vector<std::uint8_t> bytes(size + 1);
  std::size_t held = 0;
  for (;;) {
    if (held == bytes.size()) bytes.resize(std::max<std::size_t>(2 * held, std::size_t{1} << 16));
    const std::size_t got = std::fread(bytes.data() + held, 1, bytes.size() - held, file->get());
    held += got;
    if (held > most) return too_large();
    if (got == 0) break;
  }
  if (std::ferror(file->get()) != 0) return system_error("cannot be read", "check the disk");
  bytes.resize(held);
  return bytes;
}

base::Status write_all(int file, base::Bytes bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return system_error("cannot be written", k_check_disk);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return base::Done{};
}

/// What is no plain file, a pipe or a device, is written to and never replaced.
base::Status write_through(const std::string& path, base::Bytes bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  if (file < 0) return system_error("cannot be written", k_check_disk);
  auto status = write_all(file, bytes);
  if (::close(file) != 0 && status) status = system_error("cannot be written", k_check_disk);
  return status;
}

/// A link that somebody else has put there may lead to anything that this user may write.
bool is_trusted_link(const std::string& path) {
  struct stat link {};
  return ::lstat(path.c_str(), &link) == 0 && (link.st_uid == ::geteuid() || link.st_uid == 0);
}

}  // namespace

base::Result<std::vector<std::uint8_t>> read_file(const std::string& path, std::uint64_t most) {
  return read_all(open_input(path), most);
}

base::Result<std::vector<std::uint8_t>> read_plain_file(const std::string& path, std::uint64_t most) {
  return read_all(open_plain(path), most);
}

base::Result<std::vector<std::uint8_t>> read_beside(const std::string& folder, const std::string& name,
                                                    std::uint64_t most) {
  return read_all(open_beside(folder, name), most);
}

std::string link_target(std::string path) {
  std::error_code code;
  constexpr int k_most_links = 40;  // as many as the kernel follows
  for (int i = 0; i < k_most_links && std::filesystem::is_symlink(path, code) && is_trusted_link(path); ++i) {
    const auto next = std::filesystem::read_symlink(path, code);
    if (code) break;
    path = (std::filesystem::path(path).parent_path() / next).string();
  }
  return path;
}

base::Status write_file(const std::string& name, base::Bytes bytes) {
  if (name == k_standard_stream) {
    std::cout.flush();
    return write_all(STDOUT_FILENO, bytes);
  }
  struct stat there {};
  const bool exists = ::stat(name.c_str(), &there) == 0;
  if (exists && !S_ISREG(there.st_mode) && !S_ISDIR(there.st_mode)) return write_through(name, bytes);
  const std::string path = link_target(name);
  std::error_code code;
  if (std::filesystem::is_symlink(path, code)) {
    return is_trusted_link(path) ? base::Error{"is a link that leads in a circle", "", "name the file itself"}
                                 : base::Error{"is a link of another user", "", "name the file itself"};
  }
  const auto failed = [](const char* what = "cannot be written") { return system_error(what, k_check_disk); };
  if (exists && S_ISDIR(there.st_mode)) return base::Error{"is a folder", "", "name a file in it"};
  if (path.empty() || path.back() == '/') return base::Error{"is no name of a file", "", "name a file"};
  FreshFile file(path, exists ? 0600 : 0666);
  if (file.descriptor() < 0) return failed();
  if (exists) {
    // Whoever could read it before can, and nobody else. Only some may give files away.
    static_cast<void>(::fchown(file.descriptor(), there.st_uid, there.st_gid) == 0);
    static_cast<void>(::fchmod(file.descriptor(), there.st_mode & 0777U) == 0);
  }
  if (auto written = write_all(file.descriptor(), bytes); !written) return written;
  if (::fsync(file.descriptor()) != 0) return failed();
  if (!file.place()) return failed("cannot be replaced");
  flush_folder_of(path);
  return base::Done{};
}

void flush_folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

int report(const base::Error& error, const std::string& file) {
  std::cerr << "penpose: " << error.line(file) << '\n';
  return k_failure;
}

void warn(const std::string& note, const std::string& file) {
  std::cerr << "penpose: " << base::Error{note, "", ""}.line(file) << '\n';
}

}  // namespace penpose::files
