#include "ui/program/window.h"

#include "ui/app/run_app.h"

namespace penpose::program {

cli::OpenWindow window() { return app::run_app; }

}  // namespace penpose::program
