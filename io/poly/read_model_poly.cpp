// Triangle asks for segments and points in holes, a model for loops and lines: the faces of the graph tell which is
// which. The domain is what neither a hole nor the outside reaches without crossing a segment.
#include <algorithm>
#include <cmath>
#include <map>

#include "geom/predicates.hpp"
#include "io/model_formats.hpp"
#include "io/poly/poly_contents.hpp"
#include "io/text/number_text.hpp"
#include "quadline/errors.hpp"

namespace quadline {

namespace {

std::string number_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

class Builder {
 public:
  Builder(PolyContents contents, const std::filesystem::path& file)
      : contents_(std::move(contents)),
        n_given_(contents_.graph.points.size()),
        stand_in_(make_planar(contents_.graph, file.string())),
        faces_(contents_.graph) {
    model_.file = file.string();
    model_.name = file.stem().string();
  }

  Model build() {
    is_inside_.assign(faces_.face_count(), 1);
    is_inside_[PlanarFaces::kOutside] = 0;
    for (const PolyContents::Hole& hole : contents_.holes) is_inside_[faces_.face_at(hole.at)] = 0;
    add_loops();
    if (model_.outer.empty())
      throw InputError("the segments close no loop that is not a hole: nothing is left to mesh",
                       Where{model_.file, {}, {}});
    add_lines();
    add_points();
    add_regions();
    return std::move(model_);
  }

 private:
  Point at(std::uint32_t point) const { return contents_.graph.points[point]; }
  std::uint32_t half_count() const { return static_cast<std::uint32_t>(2 * contents_.graph.segments.size()); }
  const GraphSegment& segment(std::uint32_t half) const { return contents_.graph.segments[half / 2]; }
  bool has_inside(std::uint32_t half) const { return is_inside_[faces_.face(half)] != 0; }
  /// The domain lies on the left of the half-edge, not on its right.
  bool is_rim(std::uint32_t half) const { return has_inside(half) && !has_inside(half ^ 1u); }

  void add_loops() {
    std::vector<char> is_done(half_count(), 0);
    std::vector<std::uint32_t> place(contents_.graph.points.size(), 0);  // in the walk, counted from one
    for (std::uint32_t start = 0; start < half_count(); ++start) {
      if (is_done[start] || !is_rim(start)) continue;
      std::vector<std::uint32_t> walk;
      for (std::uint32_t h = start; !is_done[h]; h = next_on_rim(h)) {
        is_done[h] = 1;
        // Where the walk comes back to a point, the loop since then is taken out: loops touch, but do not cross.
        if (const std::uint32_t first = place[faces_.tail(h)]; first != 0) take_loop(walk, first - 1, place);
        walk.push_back(h);
        place[faces_.tail(h)] = static_cast<std::uint32_t>(walk.size());
      }
      take_loop(walk, 0, place);
    }
  }

  std::uint32_t next_on_rim(std::uint32_t half) const {
    std::uint32_t next = faces_.rotate_cw(half ^ 1u);
    while (!is_rim(next)) next = faces_.rotate_cw(next);
    return next;
  }

  void take_loop(std::vector<std::uint32_t>& walk, std::size_t first, std::vector<std::uint32_t>& place) {
    const std::vector<std::uint32_t> loop(walk.begin() + static_cast<std::ptrdiff_t>(first), walk.end());
    walk.resize(first);
    Path path{{}, {}, "line " + std::to_string(segment(loop[0]).line)};
    std::size_t top = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      place[faces_.tail(loop[i])] = 0;
      const Point p = at(faces_.tail(loop[i])), highest = at(faces_.tail(loop[top]));
      if (p.y > highest.y || (p.y == highest.y && p.x > highest.x)) top = i;
      path.items.push_back({p, {}});
    }
    const Point before = at(faces_.tail(loop[(top + loop.size() - 1) % loop.size()]));
    const bool is_outer = orientation(before, at(faces_.tail(loop[top])), at(faces_.head(loop[top]))) > 0;
    (is_outer ? model_.outer : model_.holes).push_back(std::move(path));
  }

  bool is_on_line(std::uint32_t half) const { return has_inside(half) == has_inside(half ^ 1u); }

  /// The half-edge that goes on from the head of this one, in the same line; itself at the line's end.
  std::uint32_t next_on_line(std::uint32_t half) const {
    const std::uint32_t back = half ^ 1u, next = faces_.rotate_cw(back);
    const bool goes_on = next != back && faces_.rotate_cw(next) == back && is_on_line(next) &&
                         segment(next).marker == segment(half).marker;
    return goes_on ? next : half;
  }

  void add_lines() {
    std::vector<char> is_done(contents_.graph.segments.size(), 0);
    std::map<std::string, std::vector<std::size_t>> by_name;  // indices of lines
    for (std::uint32_t s = 0; s < is_done.size(); ++s) {
      if (is_done[s] || !is_on_line(2 * s)) continue;
      std::uint32_t first = 2 * s + 1;  // back to where the line starts
      for (std::uint32_t h = next_on_line(first); h != first && h != 2 * s + 1; h = next_on_line(first)) first = h;
      model_.lines.push_back(line_from(first ^ 1u, is_done));
      by_name[model_.lines.back().name].push_back(model_.lines.size() - 1);
    }
    for (const auto& [name, lines] : by_name)
      for (std::size_t i = 0; lines.size() > 1 && i < lines.size(); ++i)
        model_.lines[lines[i]].name = name + '-' + std::to_string(i + 1);
  }

  Line line_from(std::uint32_t first, std::vector<char>& is_done) const {
    const GraphSegment& given = segment(first);
    const std::string name = given.marker != 0 ? "line-" + std::to_string(given.marker)  //
                                               : "segment-" + std::to_string(given.number);
    Line line{name, {{}, {}, "line " + std::to_string(given.line)}, {}};
    line.path.items.push_back({at(faces_.tail(first)), {}});
    std::uint32_t h = first;
    while (!is_done[h / 2]) {
      is_done[h / 2] = 1;
      line.path.items.push_back({at(faces_.head(h)), {}});
      h = next_on_line(h);
    }
    return line;
  }

  /// Vertices that no segment uses are nodes all the same.
  void add_points() {
    std::vector<char> is_used(contents_.graph.points.size(), 0);
    for (std::uint32_t h = 0; h < half_count(); ++h) is_used[faces_.tail(h)] = 1;
    for (std::uint32_t i = 0; i < n_given_; ++i) {
      if (stand_in_[i] != i || is_used[i]) continue;
      model_.points.push_back(
          {"vertex-" + std::to_string(contents_.first_number + i), at(i), {}, contents_.vertex_place(i)});
    }
  }

  void add_regions() {
    for (const PolyContents::Region& region : contents_.regions) {
      std::optional<double> size;
      // The edge of an equilateral triangle of that area.
      if (region.max_area > 0) size = std::sqrt(4 * region.max_area / std::sqrt(3.0));
      model_.regions.push_back(
          {"region-" + number_text(region.attribute), region.at, size, "line " + std::to_string(region.line)});
    }
  }

  PolyContents contents_;
  std::size_t n_given_;
  std::vector<std::uint32_t> stand_in_;
  PlanarFaces faces_;
  std::vector<char> is_inside_;  ///< of each face
  Model model_;
};

}  // namespace

Model read_model_poly(std::string_view text, const std::filesystem::path& file) {
  return Builder(parse_poly(text, file), file).build();
}

}  // namespace quadline
