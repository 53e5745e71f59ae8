#include "ui/app/run_app.h"
#include "ui/cli/command_line.h"

int main(int argc, char** argv) { return penpose::cli::run(argc, argv, penpose::app::run_app); }
