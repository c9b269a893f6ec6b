#include "trial.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <stdexcept>

#include "quadline/generate.hpp"

namespace quadline {

namespace {

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Without quoted names and numbers, so that failures of one cause have one text.
std::string without_details(const std::string& text) {
  std::string out;
  bool quoted = false;
  for (const char c : text.substr(0, text.find(" at ("))) {
    if (c == '\'') quoted = !quoted;
    const bool is_detail = quoted ? c != '\'' : (c >= '0' && c <= '9');
    if (!is_detail) out += c;
  }
  return out;
}

/// One line for the pipe: the attempts, then the kind.
std::string mesh(const Model& model) {
  int attempts = 0;
  std::string kind;
  try {
    Context context;
    const MeshResult result = generate(model, {}, context);
    for (const StageTime& time : result.report.stages) attempts += time.stage == "sizing";
    if (result.failure) kind = result.failure->stage + ": " + without_details(result.failure->reason);
  } catch (const InputError& error) {
    kind = "input: " + without_details(error.what());
  } catch (const std::exception& error) {
    kind = "exception: " + without_details(error.what());
  }
  return std::to_string(attempts) + " " + kind;
}

std::string read_all(int fd) {
  std::string text;
  char buffer[512];
  for (ssize_t n; (n = read(fd, buffer, sizeof buffer)) > 0;) text.append(buffer, static_cast<std::size_t>(n));
  return text;
}

}  // namespace

Trial::Trial(const Model& model, double limit_s) : start_s_(now_s()), limit_s_(limit_s) {
  int ends[2];
  if (pipe(ends) != 0 || (pid_ = fork()) < 0) throw std::runtime_error("no process can be started");
  if (pid_ == 0) {
    close(ends[0]);
    const std::string line = mesh(model);
    _exit(write(ends[1], line.data(), line.size()) == static_cast<ssize_t>(line.size()) ? 0 : 1);
  }
  close(ends[1]);
  fd_ = ends[0];
}

double Trial::left_s() const { return std::max(0.0, start_s_ + limit_s_ - now_s()); }

Outcome Trial::finish() {
  pollfd wait{fd_, POLLIN, 0};
  const bool is_hang = poll(&wait, 1, static_cast<int>(1000 * left_s())) == 0;
  if (is_hang) kill(pid_, SIGKILL);
  const std::string line = read_all(fd_);
  close(fd_);
  int status = 0;
  waitpid(pid_, &status, 0);
  Outcome out{.kind = {}, .attempts = 0, .elapsed_s = now_s() - start_s_};
  if (is_hang) {
    out.kind = "hang";
  } else if (WIFSIGNALED(status)) {
    out.kind = std::string("crash: ") + strsignal(WTERMSIG(status));
  } else if (const std::size_t space = line.find(' '); WEXITSTATUS(status) != 0 || space == line.npos) {
    out.kind = "crash: exit code " + std::to_string(WEXITSTATUS(status));
  } else {
    out.attempts = std::stoi(line.substr(0, space));
    out.kind = line.substr(space + 1);
  }
  return out;
}

}  // namespace quadline
