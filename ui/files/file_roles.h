#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace penpose::files {

/// Which files a command reads and which it writes, so that no model is lost by being written over: an output that is
/// an input or another output is refused before anything is read. Files are told apart by what they are, not by name.
class FileRoles {
 public:
  /// `prints`: the command prints something on standard output, which can be no file of it then.
  enum class Output : bool { silent, prints };
  explicit FileRoles(Output output = Output::prints) : prints_(output == Output::prints) {}

  /// Empty and built-in names are no files.
  void reads(const std::string& path);
  /// `option` as the user writes it, for the error. Errors: the name is empty, or the file is read or written already.
  [[nodiscard]] base::Status writes(const std::string& path, std::string_view option);
  /// Whether the command reads that file.
  [[nodiscard]] bool is_read(const std::string& path) const;

 private:
  std::vector<std::string> read_;
  std::vector<std::string> written_;
  bool prints_;
};

/// Whether two paths are the same file, or will be once they are there. What is no plain file is nobody's.
[[nodiscard]] bool same_file(const std::string& a, const std::string& b);

}  // namespace penpose::files
