#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"
#include "core/document/sound/mouths.h"

namespace penpose::speech {

/// The nine mouths as a model's own controls make them, where their names tell (tracking::driven_controls of Rhubarb's
/// cues): something to begin with. Empty: no control does.
[[nodiscard]] std::vector<document::Mouth> usual_mouths(const document::Model& model);

/// The keys with the mouth that is most like it in place of one of the nine that is not drawn. Errors: a name that
/// nothing stands for.
[[nodiscard]] base::Result<document::SpokenMouths> with_drawn(const document::SpokenMouths& keys,
                                                              const document::Mouths& mouths);

}  // namespace penpose::speech
