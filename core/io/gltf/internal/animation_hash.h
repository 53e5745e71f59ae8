#pragma once

#include <span>
#include <string>

#include "core/base/state_hash.h"
#include "core/document/model.h"

namespace penpose::io {

/// The hash of an animation's channels. `names`: of the weights that a key has. A weight that is 0 all the time counts
/// as one that is not there, so that controls may come and go where no key moves them.
[[nodiscard]] base::Hash128 hash_animation(const document::Animation& animation, std::span<const std::string> names);

}  // namespace penpose::io
