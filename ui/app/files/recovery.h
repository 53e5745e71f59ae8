#pragma once

#include <string>
#include <vector>

#include "ui/app/actions.h"
#include "ui/app/files/files.h"

namespace penpose::app {

/// Sessions that a crash has ended, offered one by one at the start.
class Recovery {
 public:
  /// `folder`: of sessions; empty: there are none.
  Recovery(const std::string& folder, Files& files, Notices& notices, Actions& actions);

  /// Those that are still to be asked about, the newest first.
  [[nodiscard]] const std::vector<std::string>& abandoned() const { return abandoned_; }
  /// Goes on from the first of them, or lets it be.
  void recover(bool yes);

 private:
  Files& files_;
  Notices& notices_;
  Actions& actions_;
  std::vector<std::string> abandoned_;
};

}  // namespace penpose::app
