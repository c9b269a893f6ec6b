#include "cli/console.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include "io/text/names.hpp"
#include "quadline/errors.hpp"

namespace quadline {

namespace {

constexpr std::size_t kMostFindings = 20;

std::string printed(const char* format, int digits, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, digits, value);
  return text;
}

}  // namespace

void print(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return;
  throw OutputError("standard output cannot be written: " + std::generic_category().message(errno));
}

void complain(std::string_view text) {
  const std::string line = "quadline: " + std::string(text) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

void print_findings(const std::vector<Finding>& findings, const std::string& file, bool only_losses) {
  for (const bool is_loss : {true, false}) {  // many notes shall not hide a loss
    if (only_losses && !is_loss) return;
    std::size_t n = 0;
    for (const Finding& finding : findings) {
      if (finding.is_loss != is_loss || ++n > kMostFindings) continue;
      complain(InputError(loudness(finding) + finding.text, Where{file, finding.place, finding.at}).what());
    }
    if (n > kMostFindings)
      complain(std::string(is_loss ? "warning" : "note") + ": and " + std::to_string(n - kMostFindings) +
               " more: see --report or --json");
  }
}

std::string loudness(const Finding& finding) { return finding.is_loss ? "warning: " : "note: "; }

std::string fixed(double value, int digits) { return printed("%.*f", digits, value); }

std::string rounded(double value, int digits) { return printed("%.*g", digits, value); }

std::string counted(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + ' ' + (n == 1 ? one : many);
}

std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> width;
  for (const auto& row : rows) {
    width.resize(std::max(width.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], shown_width(row[i]));
  }
  std::string out;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string fill(width[i] - shown_width(row[i]), ' ');
      line += (i == 0 ? "  " : "   ") + (i == 0 ? row[i] + fill : fill + row[i]);
    }
    line.resize(line.find_last_not_of(' ') + 1);
    out += line + '\n';
  }
  return out;
}

}  // namespace quadline
