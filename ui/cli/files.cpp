#include "ui/cli/files.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include "ui/cli/commands.h"

namespace penpose::cli {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

base::Error system_error(std::string what, std::string remedy) {
  return {what + " (" + std::generic_category().message(errno) + ")", "", std::move(remedy)};
}

}  // namespace

base::Result<std::vector<std::uint8_t>> read_file(const std::string& path) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) return base::Error{"is a folder", "", "name a file in it"};
  const File file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) return system_error("cannot be opened", "check the name and the permissions");
  std::vector<std::uint8_t> bytes;
  if (const auto size = std::filesystem::file_size(path, code); !code) bytes.reserve(size);
  std::uint8_t buffer[1 << 16];
  for (std::size_t got = 0; (got = std::fread(buffer, 1, sizeof buffer, file.get())) > 0;) {
    bytes.insert(bytes.end(), buffer, buffer + got);
  }
  if (std::ferror(file.get()) != 0) return system_error("cannot be read", "check the disk");
  return bytes;
}

std::string link_target(std::string path) {
  std::error_code code;
  constexpr int k_most_links = 40;  // as many as the kernel follows
  for (int i = 0; i < k_most_links && std::filesystem::is_symlink(path, code); ++i) {
    const auto next = std::filesystem::read_symlink(path, code);
    if (code) break;
    path = (std::filesystem::path(path).parent_path() / next).string();
  }
  return path;
}

base::Status write_file(const std::string& name, base::Bytes bytes) {
  const std::string path = link_target(name);
  std::error_code code;
  if (std::filesystem::is_symlink(path, code)) {
    return base::Error{"is a link that leads in a circle", "", "name the file itself"};
  }
  struct stat there {};
  const bool exists = ::stat(path.c_str(), &there) == 0;
  // What is no plain file, a pipe or a device, is written to and never replaced.
  const bool replaces = !exists || S_ISREG(there.st_mode) || S_ISDIR(there.st_mode);
  const std::string written = replaces ? path + ".part-" + std::to_string(::getpid()) : path;
  const auto give_up = [&](const char* what) -> base::Status {
    const auto error = system_error(what, "check the folder, its permissions and the free space");
    if (replaces) std::remove(written.c_str());
    return error;
  };
  const mode_t mode = exists ? 0600 : 0666;
  const int descriptor = ::open(written.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, mode);
  if (descriptor < 0) return give_up("cannot be written");
  File file(::fdopen(descriptor, "wb"), &std::fclose);
  if (!file) return give_up("cannot be written");
  if (replaces && exists) {
    // Whoever could read it before can, and nobody else. Only some may give files away.
    static_cast<void>(::fchown(::fileno(file.get()), there.st_uid, there.st_gid) == 0);
    static_cast<void>(::fchmod(::fileno(file.get()), there.st_mode & 07777U) == 0);
  }
  if (!bytes.empty() && std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) {
    return give_up("cannot be written");
  }
  if (std::fflush(file.get()) != 0) return give_up("cannot be written");
  // Pipes and such have no disk.
  if (::fsync(::fileno(file.get())) != 0 && replaces) return give_up("cannot be written");
  if (std::fclose(file.release()) != 0) return give_up("cannot be written");
  if (!replaces) return base::Done{};
  if (std::rename(written.c_str(), path.c_str()) != 0) return give_up("cannot be replaced");
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

}  // namespace penpose::cli
