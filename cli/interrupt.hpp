#pragma once

namespace quadline {

/// From here on SIGINT and SIGTERM do not end the program, but are remembered.
void watch_for_interrupts();

bool is_interrupted();

}  // namespace quadline
