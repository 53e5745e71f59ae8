// A settings file of any content, bindings of keys and dials among it: what was read is what would be read of what
// would be written, and within its bounds. And the same as the resources of an X server.

#include <cstdint>
#include <cstdlib>

#include "ui/app/canvas/own_scale.h"
#include "ui/app/settings.h"

using namespace penpose;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const app::Settings settings = app::parse_settings(base::as_text(base::Bytes(data, size)));
  if (settings.pads.size() > app::k_most_pads || settings.recent.size() > app::k_most_recent) std::abort();
  for (const auto& [tablet, bindings] : settings.pads) {
    if (bindings.empty() || bindings.size() > app::k_most_bindings) std::abort();
    for (const auto& [control, binding] : bindings) {
      if (app::parse_binding(app::to_text(binding)) != binding || app::label_of(binding).empty()) std::abort();
    }
  }
  if (!(app::parse_settings(app::to_text(settings)) == settings)) std::abort();
  const auto dpi = app::xft_dpi(base::as_text(base::Bytes(data, size)));
  if (dpi && !(*dpi >= 24 && *dpi <= 768)) std::abort();
  return 0;
}
