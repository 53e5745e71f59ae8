#include "ui/program/window.h"

namespace penpose::program {

cli::OpenWindow window() { return {}; }

}  // namespace penpose::program
