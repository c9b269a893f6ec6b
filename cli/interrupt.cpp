#include "cli/interrupt.hpp"

#include <signal.h>
#include <unistd.h>

#include <atomic>

namespace quadline {

namespace {

// A signal handler can reach nothing but a global.
std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch nothing else");

// The signal may come just before a call that waits, for a pipe that never speaks: the alarm comes again and again and
// ends that call too.
void remember(int) {
  interrupted = true;
  ::alarm(1);
}

}  // namespace

void watch_for_interrupts() {
  struct sigaction action{};
  action.sa_handler = remember;  // without SA_RESTART: reading from a pipe that never speaks shall end too
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGALRM, &action, nullptr);
}

bool is_interrupted() { return interrupted; }

}  // namespace quadline
