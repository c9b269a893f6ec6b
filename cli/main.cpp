#include <fcntl.h>

#include <csignal>
#include <new>
#include <stdexcept>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/interrupt.hpp"
#include "quadline/errors.hpp"

namespace quadline {

namespace {

/// A file that is opened while standard output or standard error is closed would take its number, and our words with
/// it. What stands in for them cannot be written, so that the output is missed as before.
void fill_closed_descriptors() {
  for (int i = 0; i <= 2; ++i)
    if (::fcntl(i, F_GETFD) < 0) ::open("/dev/null", O_RDONLY);
}

constexpr const char* kNoMemory = "not enough memory: a mesh with a larger size takes less";

int fail(const std::string& message, int exit_code) {
  // What a signal broke off, it broke off: the error that came of it is not the news.
  complain(is_interrupted() ? "interrupted" : message);
  return is_interrupted() ? kInterrupted : exit_code;
}

int run_command(int argc, const char* const* argv) {
  try {
    const auto arguments = parse_arguments(argc, argv);
    if (!arguments) return kDone;
    return std::visit([](const auto& command) { return run(command); }, *arguments);
  } catch (const Cancelled& error) {
    complain(error.what());
    return kInterrupted;
  } catch (const InputError& error) {
    return fail(error.what(), kWrongInput);
  } catch (const OutputError& error) {
    return fail(error.what(), kCannotWrite);
  } catch (const std::bad_alloc&) {
    return fail(kNoMemory, kBrokenPromise);
  } catch (const std::length_error&) {  // more than any memory can hold
    return fail(kNoMemory, kBrokenPromise);
  } catch (const std::exception& error) {
    return fail(std::string(error.what()) + ": a defect of Quadline, please report it", kBrokenPromise);
  }
}

}  // namespace

}  // namespace quadline

int main(int argc, char** argv) {
  quadline::fill_closed_descriptors();
  quadline::watch_for_interrupts();
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error of writing like any other
  std::signal(SIGXFSZ, SIG_IGN);  // and so is a file that may not grow further
  return quadline::run_command(argc, argv);
}
