// The format: https://www.cs.cmu.edu/~quake/triangle.poly.html.
#include "io/poly/poly_contents.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "io/text/number_text.hpp"
#include "io/text/read_bytes.hpp"
#include "quadline/errors.hpp"

namespace quadline {

namespace {

/// The lines of a file that hold something, as words. A comment goes from '#' to the end of its line.
class Lines {
 public:
  Lines(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);  // the byte order mark of some editors
  }

  /// Moves to the next line with words; false at the end of the file.
  bool advance() {
    words_.clear();
    while (words_.empty() && !text_.empty()) {
      const std::size_t end = text_.find('\n');
      split(text_.substr(0, end));
      text_.remove_prefix(end == text_.npos ? text_.size() : end + 1);
      ++number_;
    }
    return !words_.empty();
  }

  void expect(const std::string& what) {
    if (!advance()) fail("expected " + what + ", found the end of the file");
  }

  std::size_t number() const { return number_; }
  std::size_t word_count() const { return words_.size(); }

  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(ErrorCode::FileSyntax, message,
                     Where{file_, number_ == 0 ? "" : "line " + std::to_string(number_), {}});
  }

  template <class Number>
  Number get(std::size_t i, const char* what) const {
    if (i >= words_.size()) fail(std::string("expected ") + what + ", found the end of the line");
    const auto value = parse_number<Number>(words_[i]);
    if (!value) fail(std::string("expected ") + what + ", found '" + std::string(words_[i].substr(0, 40)) + "'");
    return *value;
  }

  double coordinate(std::size_t i, const char* what) const {
    const double value = get<double>(i, what);
    if (!std::isfinite(value)) fail(std::string(what) + " is not a finite number");
    return value;
  }

  Point point(std::size_t i) const {
    return {coordinate(i, "the x coordinate"), coordinate(i + 1, "the y coordinate")};
  }

  std::size_t count(std::size_t i, const char* what) const {
    const auto value = get<long long>(i, what);
    if (value < 0) fail(std::string(what) + " is negative");
    return static_cast<std::size_t>(value);
  }

 private:
  void split(std::string_view line) {
    line = line.substr(0, line.find('#'));
    constexpr std::string_view kSpace = " \t\r\f\v";
    while (true) {
      const std::size_t start = line.find_first_not_of(kSpace);
      if (start == line.npos) return;
      line.remove_prefix(start);
      const std::size_t end = std::min(line.find_first_of(kSpace), line.size());
      words_.push_back(line.substr(0, end));
      line.remove_prefix(end);
    }
  }

  std::string_view text_;
  std::string file_;
  std::size_t number_ = 0;
  std::vector<std::string_view> words_;
};

std::string of(std::size_t i, std::size_t n) { return std::to_string(i + 1) + " of " + std::to_string(n); }

class Reader {
 public:
  PolyContents read(std::string_view text, const std::filesystem::path& file) {
    Lines lines(text, file.string());
    lines.expect("the number of vertices");
    if (lines.count(0, "the number of vertices") > 0) {
      read_vertices(lines);
    } else {
      const std::filesystem::path node_file = std::filesystem::path(file).replace_extension(".node");
      contents_.node_file = node_file.string();
      const std::string node_text = read_bytes(node_file);
      Lines node_lines(node_text, node_file.string());
      node_lines.expect("the number of vertices");
      read_vertices(node_lines);
    }
    read_segments(lines);
    read_holes(lines);
    read_regions(lines);
    return std::move(contents_);
  }

 private:
  void read_vertices(Lines& lines) {
    const std::size_t n = lines.count(0, "the number of vertices");
    if (lines.word_count() > 1 && lines.get<int>(1, "the dimension") != 2) lines.fail("the dimension must be 2");
    if (n > std::numeric_limits<std::uint32_t>::max() / 2) lines.fail("too many vertices");
    for (std::size_t i = 0; i < n; ++i) {
      lines.expect("vertex " + of(i, n));
      const auto number = lines.get<long long>(0, "the number of a vertex");
      if (i == 0) contents_.first_number = number;
      if (number != contents_.first_number + static_cast<long long>(i))
        lines.fail("vertices must be numbered without gaps: expected vertex " +
                   std::to_string(contents_.first_number + static_cast<long long>(i)));
      contents_.graph.points.push_back(lines.point(1));
      contents_.vertex_lines.push_back(lines.number());
    }
  }

  void read_segments(Lines& lines) {
    lines.expect("the number of segments");
    const std::size_t n = lines.count(0, "the number of segments");
    const bool has_markers = lines.word_count() > 1 && lines.count(1, "the number of boundary markers") > 0;
    for (std::size_t i = 0; i < n; ++i) {
      lines.expect("segment " + of(i, n));
      GraphSegment segment{vertex(lines, 1), vertex(lines, 2)};
      segment.number = lines.count(0, "the number of a segment");
      segment.line = lines.number();
      if (has_markers && lines.word_count() > 3) segment.marker = lines.get<int>(3, "a boundary marker");
      contents_.graph.segments.push_back(segment);
    }
  }

  std::uint32_t vertex(const Lines& lines, std::size_t i) const {
    const auto number = lines.get<long long>(i, "the number of a vertex");
    const auto n = static_cast<long long>(contents_.graph.points.size());
    const long long first = contents_.first_number;
    if (number < first || number - first >= n)
      lines.fail("there is no vertex " + std::to_string(number) + ": they go from " + std::to_string(first) + " to " +
                 std::to_string(first + n - 1));
    return static_cast<std::uint32_t>(number - first);
  }

  void read_holes(Lines& lines) {
    lines.expect("the number of holes");
    const std::size_t n = lines.count(0, "the number of holes");
    for (std::size_t i = 0; i < n; ++i) {
      lines.expect("hole " + of(i, n));
      contents_.holes.push_back({lines.point(1), lines.number()});
    }
  }

  /// The section may be missing.
  void read_regions(Lines& lines) {
    if (!lines.advance()) return;
    const std::size_t n = lines.count(0, "the number of regions");
    for (std::size_t i = 0; i < n; ++i) {
      lines.expect("region " + of(i, n));
      const double area = lines.word_count() > 4 ? lines.coordinate(4, "the largest area") : 0;
      const double attribute = lines.coordinate(3, "the attribute of a region");
      contents_.regions.push_back({lines.point(1), attribute, area > 0 ? area : 0, lines.number()});
    }
    if (lines.advance()) lines.fail("expected the end of the file after " + std::to_string(n) + " regions");
  }

  PolyContents contents_;
};

}  // namespace

PolyContents parse_poly(std::string_view text, const std::filesystem::path& file) { return Reader().read(text, file); }

}  // namespace quadline
