#include "ui/app/widgets/font_file.h"

#include <fontconfig/fontconfig.h>
#include <memory>
#include <string_view>

namespace penpose::app {
namespace {

struct Free {
  void operator()(FcConfig* config) const { FcConfigDestroy(config); }
  void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
};

const FcChar8* bytes(const char* text) { return reinterpret_cast<const FcChar8*>(text); }

/// The file that fontconfig gives for a family; empty where it gives another family's.
std::string file_of(FcConfig* config, const char* family) {
  const std::unique_ptr<FcPattern, Free> wanted(FcPatternCreate());
  if (!wanted) return {};
  FcPatternAddString(wanted.get(), FC_FAMILY, bytes(family));
  FcPatternAddInteger(wanted.get(), FC_WEIGHT, FC_WEIGHT_REGULAR);
  FcPatternAddInteger(wanted.get(), FC_SLANT, FC_SLANT_ROMAN);
  FcPatternAddBool(wanted.get(), FC_VARIABLE, FcFalse);
  FcConfigSubstitute(config, wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  const std::unique_ptr<FcPattern, Free> found(FcFontMatch(config, wanted.get(), &result));
  FcChar8* name = nullptr;
  FcChar8* file = nullptr;
  if (!found || FcPatternGetString(found.get(), FC_FAMILY, 0, &name) != FcResultMatch ||
      FcPatternGetString(found.get(), FC_FILE, 0, &file) != FcResultMatch) {
    return {};
  }
  const bool same = std::string_view(reinterpret_cast<const char*>(name)) == family;
  return same ? std::string(reinterpret_cast<const char*>(file)) : std::string();
}

}  // namespace

std::string font_file(std::span<const char* const> families) {
  std::string file;
  {
    const std::unique_ptr<FcConfig, Free> config(FcInitLoadConfigAndFonts());
    if (!config) return {};
    for (const char* family : families) {
      if (file.empty()) file = file_of(config.get(), family);
    }
  }
  return file;
}

}  // namespace penpose::app
