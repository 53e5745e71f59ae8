#include "ui/cli/progress.h"

#include <iostream>
#include <unistd.h>
#include <utility>

namespace penpose::cli {

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)), total_(total), visible_(::isatty(STDERR_FILENO) == 1) {}

void Progress::advance(std::size_t steps) {
  done_ += steps;
  const int percent = total_ == 0 ? 100 : static_cast<int>(100 * done_ / total_);
  if (!visible_ || percent == shown_percent_) return;
  shown_percent_ = percent;
  std::cerr << "\r" << what_ << " " << percent << " %" << std::flush;
}

void Progress::finish() {
  if (visible_ && shown_percent_ >= 0) std::cerr << "\r\033[K" << std::flush;
  shown_percent_ = -1;
}

}  // namespace penpose::cli
