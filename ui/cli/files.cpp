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

base::Status write_file(const std::string& path, base::Bytes bytes) {
  const std::string temporary = path + ".part-" + std::to_string(::getpid());
  const auto give_up = [&](const char* what) -> base::Status {
    const auto error = system_error(what, "check the folder, its permissions and the free space");
    std::remove(temporary.c_str());
    return error;
  };
  File file(std::fopen(temporary.c_str(), "wb"), &std::fclose);
  if (!file) return give_up("cannot be written");
  if (!bytes.empty() && std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) {
    return give_up("cannot be written");
  }
  if (std::fflush(file.get()) != 0 || ::fsync(::fileno(file.get())) != 0) return give_up("cannot be written");
  if (std::fclose(file.release()) != 0) return give_up("cannot be written");
  if (std::rename(temporary.c_str(), path.c_str()) != 0) return give_up("cannot be replaced");
  // The new name is in the folder only once the folder is on the disk too; some file systems cannot say.
  const std::string folder = std::filesystem::path(path).parent_path().string();
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0) {
    ::fsync(descriptor);
    ::close(descriptor);
  }
  return base::Done{};
}

int report(const base::Error& error, const std::string& file) {
  std::cerr << "penpose: " << error.line(file) << '\n';
  return k_failure;
}

void warn(const std::string& note, const std::string& file) {
  std::cerr << "penpose: " << base::Error{note, "", ""}.line(file) << '\n';
}

}  // namespace penpose::cli
