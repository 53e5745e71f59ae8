#include "firmware_io/device/source/built_in.h"

namespace penpose::device {

bool reads_through(Transport) { return true; }

}  // namespace penpose::device
