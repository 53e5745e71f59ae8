#include "ui/program/window.h"

#include "ui/app/window/run_app.h"

namespace penpose::program {

files::OpenWindow window() { return app::run_app; }

}  // namespace penpose::program
