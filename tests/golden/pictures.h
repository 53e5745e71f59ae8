#pragma once

#include <map>
#include <string>

namespace penpose::tests {

/// Hashes of the px of twelve scenes as the processor draws them, by names that begin with "picture-".
std::map<std::string, std::string> picture_hashes();

}  // namespace penpose::tests
