#include "ui/app/window/input_nodes.h"

#include <algorithm>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace penpose::app {

InputNodes::InputNodes(std::string folder) : folder_(std::move(folder)), known_(readable()) {}

bool InputNodes::has_new() {
  std::set<Node> now = readable();
  const bool all_known = std::includes(known_.begin(), known_.end(), now.begin(), now.end());
  known_ = std::move(now);
  return !all_known;
}

std::set<InputNodes::Node> InputNodes::readable() const {
  std::set<Node> nodes;
  std::error_code none;
  for (auto at = std::filesystem::directory_iterator(folder_, none); at != std::filesystem::directory_iterator();
       at.increment(none)) {
    const std::string path = at->path().string();
    struct stat facts {};
    if (!at->path().filename().string().starts_with("event") || ::access(path.c_str(), R_OK) != 0) continue;
    if (::stat(path.c_str(), &facts) != 0) continue;
    nodes.emplace(path, std::int64_t{facts.st_ctim.tv_sec} * 1'000'000'000 + facts.st_ctim.tv_nsec);
  }
  return nodes;
}

}  // namespace penpose::app
