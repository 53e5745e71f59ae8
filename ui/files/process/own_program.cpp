#include "ui/files/process/own_program.h"

#include <filesystem>
#include <system_error>

namespace penpose::files {

std::string own_program() {
  std::error_code code;
  const auto path = std::filesystem::read_symlink("/proc/self/exe", code);
  return code ? "penpose" : path.string();
}

}  // namespace penpose::files
