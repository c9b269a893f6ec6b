// Checked by hand rather than against schema/model.schema.json: so that each message can say what to do.
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <vector>

#include "io/json/parse_json.hpp"
#include "io/text/nearest_name.hpp"
#include "io/text/number_text.hpp"
#include "quadline/errors.hpp"
#include "quadline/json.hpp"

namespace quadline {

namespace {

using Json = nlohmann::json;

/// "a list", "the text 'left'": what stands where something else was expected.
std::string found(const Json& value) {
  switch (value.type()) {
    case Json::value_t::object:
      return "an object {...}";
    case Json::value_t::array:
      return value.empty() ? "an empty list" : "a list of " + std::to_string(value.size());
    case Json::value_t::string:
      return "the text '" + value.get<std::string>().substr(0, 40) + "'";
    case Json::value_t::null:
      return "nothing (null)";
    case Json::value_t::boolean:
      return value.get<bool>() ? "true" : "false";
    default:
      break;
  }
  std::string text;
  append_number(text, value.get<double>());
  return "the number " + text;
}

/// A value of the document, and how it was reached. Its path becomes text only where an error asks for it.
struct Spot {
  const Json& value;
  const Spot* up = nullptr;
  std::string_view key = {};
  std::size_t index = 0;

  Json::json_pointer pointer() const {
    if (!up) return Json::json_pointer();
    Json::json_pointer path = up->pointer();
    return up->value.is_array() ? path /= index : path /= std::string(key);
  }
  std::string path() const { return pointer().to_string(); }
};

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  Model model(const Spot& root) const {
    expect_object(root, "a model");
    expect_keys(root, {"name", "about", "units", "size", "outer", "holes", "lines", "points", "regions"});
    Model model;
    model.file = file_;
    model.name = text(root, "name");
    model.about = text(root, "about");
    model.units = text(root, "units");
    model.size = optional_length(root, "size").value_or(0);
    if (!root.value.contains("outer")) fail(root, "'outer', the loop round the domain, is missing");
    with(root, "outer", [&](const Spot& outer) { model.outer = loops(outer); });
    each(root, "holes", [&](const Spot& hole) { model.holes.push_back(this->hole(hole)); });
    each(root, "lines", [&](const Spot& line) { model.lines.push_back(this->line(line)); });
    each(root, "points", [&](const Spot& point) { model.points.push_back(named<NamedPoint>(point, "a point")); });
    each(root, "regions", [&](const Spot& region) { model.regions.push_back(named<Region>(region, "a region")); });
    return model;
  }

 private:
  [[noreturn]] void fail(const Spot& at, const std::string& message) const {
    throw InputError(ErrorCode::FileSyntax, message, Where{file_, at.path(), {}});
  }

  template <class Visit>
  static void with(const Spot& object, std::string_view key, Visit visit) {
    const auto value = object.value.find(key);
    if (value != object.value.end()) visit(Spot{*value, &object, key});
  }

  template <class Visit>
  static void each_of(const Spot& list, Visit visit) {
    for (std::size_t i = 0; i < list.value.size(); ++i) visit(Spot{list.value[i], &list, {}, i});
  }

  template <class Visit>
  void each(const Spot& object, std::string_view key, Visit visit) const {
    with(object, key, [&](const Spot& list) {
      if (!list.value.is_array()) fail(list, "expected a list [...], found " + found(list.value));
      each_of(list, visit);
    });
  }

  void expect_object(const Spot& at, const char* what) const {
    if (!at.value.is_object()) fail(at, std::string("expected ") + what + " {...}, found " + found(at.value));
  }

  /// A key with a slip of the pen would lose what it holds; keys that start with "x-" are free for other programs.
  void expect_keys(const Spot& object, const std::vector<std::string>& known) const {
    for (const auto& [key, value] : object.value.items()) {
      if (key.starts_with("x-") || (key == "$schema" && !object.up)) continue;
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      const std::string nearest = nearest_name(key, known);
      fail(Spot{value, &object, key},
           "unknown key '" + key + "': " +
               (nearest.empty() ? "take it out, or let it begin with 'x-'" : "did you mean '" + nearest + "'?"));
    }
  }

  std::string text(const Spot& object, std::string_view key) const {
    std::string out;
    with(object, key, [&](const Spot& at) {
      if (!at.value.is_string()) fail(at, "expected a text \"...\", found " + found(at.value));
      out = at.value.get<std::string>();
    });
    return out;
  }

  double number(const Spot& at) const {
    if (!at.value.is_number()) fail(at, "expected a number, found " + found(at.value));
    return at.value.get<double>();
  }

  std::optional<double> optional_length(const Spot& object, std::string_view key) const {
    std::optional<double> out;
    with(object, key, [&](const Spot& at) {
      out = number(at);
      if (!(*out > 0)) fail(at, "expected a length above 0, found " + found(at.value));
    });
    return out;
  }

  Point point(const Spot& at) const {
    if (!at.value.is_array() || at.value.size() != 2) fail(at, "expected a point [x, y], found " + found(at.value));
    return {number(Spot{at.value[0], &at, {}, 0}), number(Spot{at.value[1], &at, {}, 1})};
  }

  Point point(const Spot& object, const char* key) const {
    Point out;
    if (!object.value.contains(key)) fail(object, std::string("'") + key + "' is missing");
    with(object, key, [&](const Spot& at) { out = point(at); });
    return out;
  }

  /// A whole number from `least` to `most`, a multiple of `step`.
  std::optional<std::uint32_t> optional_count(const Spot& object, std::string_view key, std::uint32_t least,
                                              std::uint32_t most, std::uint32_t step) const {
    std::optional<std::uint32_t> out;
    with(object, key, [&](const Spot& at) {
      const double given = number(at);
      if (!(given >= least && given <= most && std::fmod(given, step) == 0))
        fail(at, std::string("expected ") + (step == 2 ? "an even" : "a whole") + " number from " +
                     std::to_string(least) + " to " + std::to_string(most) + ", found " + found(at.value));
      out = static_cast<std::uint32_t>(given);
    });
    return out;
  }

  void refuse_washer(const Spot& object, const char* why) const {
    refuse(object, {"edges", "rings", "ring_width"}, why);
  }

  Circle circle(const Spot& at) const {
    if (at.value.contains("path")) refuse_washer(at, "this key belongs to a hole, or to its circle: take it out");
    expect_keys(at, {"center", "radius", "edges", "rings", "ring_width"});
    const Point center = point(at, "center");
    const auto radius = optional_length(at, "radius");
    if (!radius) fail(at, "'radius' is missing");
    Circle out{.center = center, .radius = *radius};
    read_washer(at, out);
    return out;
  }

  void read_washer(const Spot& at, Circle& circle) const {
    circle.edges = optional_count(at, "edges", kLeastCircleEdges, kMostCircleEdges, 2);
    circle.rings = optional_count(at, "rings", 1, kMostRings, 1);
    circle.ring_width = optional_length(at, "ring_width");
  }

  /// A path, or an object that holds it, and what its circle asks for.
  Path hole(const Spot& at) const {
    if (!at.value.is_object() || !at.value.contains("path")) return path(at);
    expect_keys(at, {"path", "edges", "rings", "ring_width"});
    Path out;
    with(at, "path", [&](const Spot& path) {
      if (path.value.is_object()) refuse_washer(path, "this key stands beside 'path' here: move it there");
      out = this->path(path);
    });
    if (!out.circle) refuse_washer(at, "only a circle {\"center\", \"radius\"} has this key: take it out");
    if (out.circle) read_washer(at, *out.circle);
    return out;
  }

  /// An outer loop has nothing outside that rings could fill.
  Path outer_loop(const Spot& at) const {
    refuse(at, {"rings", "ring_width"}, "rings lie round holes and round lines: take it out");
    return path(at);
  }

  void refuse(const Spot& object, std::initializer_list<std::string_view> keys, const char* why) const {
    for (const std::string_view key : keys) with(object, key, [&](const Spot& at) { fail(at, why); });
  }

  PathItem item(const Spot& at) const {
    if (!at.value.is_object()) return {point(at), {}};
    expect_keys(at, {"to", "via"});
    return {point(at, "to"), point(at, "via")};
  }

  Path path(const Spot& at) const {
    Path out;
    out.where = at.path();
    if (at.value.is_object()) {
      out.circle = circle(at);
      return out;
    }
    if (!at.value.is_array())
      fail(at, "expected a path (a list of points and arcs, or a circle), found " + found(at.value));
    each_of(at, [&](const Spot& step) { out.items.push_back(item(step)); });
    if (out.items.size() < 2) fail(at, "a path needs two points or more, found " + found(at.value));
    if (out.items[0].via) fail(Spot{at.value[0], &at, {}, 0}, "a path starts with a point [x, y], not with an arc");
    return out;
  }

  /// One loop, or a list of loops: those are circles, or lists whose first item is a list.
  std::vector<Path> loops(const Spot& at) const {
    const auto is_loop = [](const Json& value) {
      return value.contains("center") || value.contains("radius") ||
             (value.is_array() && !value.empty() && (value[0].is_array() || value[0].is_object()));
    };
    if (at.value.is_array() && at.value.empty()) fail(at, "expected a loop, or a list of loops, found an empty list");
    if (!at.value.is_array() || !is_loop(at.value[0])) return {outer_loop(at)};
    std::vector<Path> out;
    each_of(at, [&](const Spot& loop) { out.push_back(outer_loop(loop)); });
    return out;
  }

  Line line(const Spot& at) const {
    expect_object(at, "a line");
    refuse_washer(at, "this key belongs to the circle: move it into 'path'");
    expect_keys(at, {"name", "path", "size"});
    if (!at.value.contains("path")) fail(at, "'path' is missing");
    Line out{text(at, "name"), {}, optional_length(at, "size")};
    with(at, "path", [&](const Spot& path) { out.path = this->path(path); });
    return out;
  }

  /// A point or a region: they hold the same.
  template <class Named>
  Named named(const Spot& at, const char* what) const {
    expect_object(at, what);
    expect_keys(at, {"name", "at", "size"});
    return {text(at, "name"), point(at, "at"), optional_length(at, "size"), at.path()};
  }

  const std::string& file_;
};

}  // namespace

Model read_model_json(std::string_view text, const std::string& file) {
  const Json document = parse_json(text, file);
  return Reader(file).model(Spot{document});
}

}  // namespace quadline
