#pragma once

#include "ui/app/action.h"

namespace penpose::app {

class App;

/// Does an action that is a row of the table: what it does beside what it is. False: it is not in the table.
bool run_row(App& app, Action action);

}  // namespace penpose::app
