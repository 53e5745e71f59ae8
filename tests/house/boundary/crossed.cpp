#include "core/rig/rig.h"

int parameters_of(const penpose::rig::Rig& rig) { return static_cast<int>(rig.parameters().size()); }
