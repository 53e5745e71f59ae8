#include "ui/cli/trace_file.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace penpose::cli {

base::Result<File> open_trace(const std::string& path) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) return base::Error{"is a folder", "", "name a trace in it"};
  File file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) {
    return base::Error{"cannot be opened (" + std::generic_category().message(errno) + ")", "",
                       "check the name and the permissions"};
  }
  return file;
}

replay::ReadBytes read_from_file(std::FILE* file) {
  return [file](std::span<std::uint8_t> into) -> base::Result<std::size_t> {
    const std::size_t got = std::fread(into.data(), 1, into.size(), file);
    if (got == 0 && std::ferror(file) != 0) return base::Error{"cannot be read", "", "check the disk"};
    return got;
  };
}

}  // namespace penpose::cli
