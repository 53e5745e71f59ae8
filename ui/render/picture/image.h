#pragma once

#include "core/picture/image.h"

namespace penpose::render {

using picture::decode_png;
using picture::encode_png;
using picture::Image;

}  // namespace penpose::render
