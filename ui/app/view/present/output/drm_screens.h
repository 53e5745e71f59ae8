#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace penpose::app {

/// A screen that is connected to a card of this machine.
struct DrmScreen {
  int card = 0;                 ///< /dev/dri/cardN
  int of_card = 0;              ///< its place among the screens of that card
  std::uint32_t connector = 0;  ///< the kernel's id
  double dpi = 0;               ///< of its best mode by the size that it tells (EDID); 0: it tells none

  [[nodiscard]] std::string device() const { return "/dev/dri/card" + std::to_string(card); }
};

/// The screens that are connected, by card and as the card counts them, and the first card that may not be opened.
struct DrmScreens {
  std::vector<DrmScreen> all;
  std::string forbidden;
};
[[nodiscard]] DrmScreens find_drm_screens();

}  // namespace penpose::app
