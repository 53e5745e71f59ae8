#pragma once

#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

#include "core/base/result.h"

namespace penpose::app {

/// A command of this program at work in a process of its own, with a folder for what it reads and writes, which goes
/// with it.
class ProgramRun {
 public:
  /// Errors: there is no place for the folder.
  static base::Result<ProgramRun> prepare();
  ProgramRun(ProgramRun&& other) noexcept;
  ProgramRun& operator=(ProgramRun&&) = delete;
  /// What is not done is given up.
  ~ProgramRun();

  [[nodiscard]] const std::string& folder() const { return folder_; }
  /// Errors: the program does not start.
  [[nodiscard]] base::Status start(const std::vector<std::string>& words);
  /// Done: it has ended well; an error: the last line that it said; nothing yet otherwise.
  [[nodiscard]] std::optional<base::Status> ended();
  /// What it printed.
  [[nodiscard]] std::string said() const;

 private:
  ProgramRun() = default;

  std::string folder_;
  pid_t process_ = -1;
};

}  // namespace penpose::app
