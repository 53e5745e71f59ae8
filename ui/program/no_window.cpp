#include "ui/program/window.h"

namespace penpose::program {

files::OpenWindow window() { return {}; }

}  // namespace penpose::program
