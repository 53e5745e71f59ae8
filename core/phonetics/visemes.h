#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/phonetics/nine_mouths.h"

namespace penpose::speech {

/// The mouth of a viseme of Amazon Polly ("p", "t", "S", "sil", ..., in their own case): its documentation, "Phoneme
/// and Viseme Tables for Supported Languages", says which phonemes each one stands for.
[[nodiscard]] std::optional<NineMouth> mouth_of_polly(std::string_view viseme);

/// The mouth of a viseme of Azure's speech service, 0 to 21: its documentation, "Get facial position with viseme", and
/// that of the Speech API's SPVISEMES, from which the numbers come, say which phonemes each one stands for.
[[nodiscard]] std::optional<NineMouth> mouth_of_azure(std::int64_t viseme);

/// The mouth of a viseme of Meta's and Ready Player Me's fifteen ("PP", "kk", "aa", ..., also as "viseme_PP"), in any
/// case: "Viseme Reference" of the Oculus Lipsync guide. Single letters are none, which others have as well.
[[nodiscard]] std::optional<NineMouth> mouth_of_oculus(std::string_view viseme);

}  // namespace penpose::speech
