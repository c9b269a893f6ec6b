// The picture of a mesh: one path for each class of quality, then the curves, the points and the legend.

#include "io/svg/svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/constants.hpp"
#include "io/text/number_text.hpp"
#include "quality/face_corners.hpp"
#include "quality/quad_sums.hpp"

namespace quadline {
namespace {

constexpr double kPictureWidth = 1000;  // pixels where nothing else is asked for
constexpr double kLegendHeight = 64;
constexpr double kMargin = 12;

/// Classes of quality (scaled Jacobian), the worst first: upper end and colour.
struct QualityClass {
  double below;
  const char* color;
  const char* label;
};
constexpr std::array<QualityClass, 9> kClasses = {{
    {1e-6, "#000000", "inverted"},
    {0.2, "#a50026", "0"},
    {0.4, "#d73027", "0.2"},
    {0.5, "#f46d43", "0.4"},
    {0.6, "#fdae61", "0.5"},
    {0.7, "#fee08b", "0.6"},
    {0.8, "#d9ef8b", "0.7"},
    {0.9, "#a6d96a", "0.8"},
    {kInfinity, "#66bd63", "0.9"},
}};

std::size_t class_of(double quality) {
  std::size_t i = 0;
  while (i + 1 < kClasses.size() && !(quality < kClasses[i].below)) ++i;
  return i;
}

/// A point of the picture in whole numbers, y downwards.
struct Spot {
  std::int64_t x, y;
};

/// From the model to the picture.
class View {
 public:
  explicit View(const Mesh& mesh);

  Spot spot(Point p) const { return {std::llround((p.x - lo_.x) * scale_), std::llround((hi_.y - p.y) * scale_)}; }
  double width() const { return (hi_.x - lo_.x) * scale_; }
  double height() const { return (hi_.y - lo_.y) * scale_; }
  double unit() const { return unit_; }  ///< a pixel of a picture of the usual width
  double mean_edge() const { return mean_edge_ * scale_; }

 private:
  Point lo_{0, 0}, hi_{1, 1};
  double scale_ = 1, unit_ = 1, mean_edge_ = 1;
};

/// Mean edge length of the elements, by their perimeters; `fallback` where there is none.
double mean_edge_of(const Mesh& mesh, double fallback) {
  double sum = 0;
  const auto add = [&](const auto& element) {
    for (std::size_t i = 0; i < element.size(); ++i)
      sum += distance(mesh.points[element[i]], mesh.points[element[(i + 1) % element.size()]]);
  };
  for (const auto& quad : mesh.quads) add(quad);
  for (const auto& triangle : mesh.triangles) add(triangle);
  const auto count = static_cast<double>(4 * mesh.quads.size() + 3 * mesh.triangles.size());
  return sum > 0 ? sum / count : fallback;
}

View::View(const Mesh& mesh) {
  if (!mesh.points.empty()) lo_ = hi_ = mesh.points[0];
  for (const Point p : mesh.points) {
    lo_ = {std::min(lo_.x, p.x), std::min(lo_.y, p.y)};
    hi_ = {std::max(hi_.x, p.x), std::max(hi_.y, p.y)};
  }
  const double span = std::max({hi_.x - lo_.x, hi_.y - lo_.y, std::numeric_limits<double>::min()});
  mean_edge_ = mean_edge_of(mesh, span);
  constexpr double kStepsPerEdge = 50, kFewestSteps = 10 * kPictureWidth, kMostSteps = 1e7;
  const double steps = std::clamp(kStepsPerEdge * span / mean_edge_, kFewestSteps, kMostSteps);
  scale_ = steps / span;
  unit_ = steps / kPictureWidth;
}

/// Path data: one absolute move, then relative lines, which are short.
void append_path(std::string& out, const View& view, const Mesh& mesh, const NodeIndex* nodes, std::size_t n,
                 bool closed) {
  Spot last{};
  for (std::size_t i = 0; i < n; ++i) {
    const Spot here = view.spot(mesh.points[nodes[i]]);
    const Spot step = i == 0 ? here : Spot{here.x - last.x, here.y - last.y};
    if (i < 2) {
      out += i == 0 ? 'M' : 'l';
    } else if (step.x >= 0) {
      out += ' ';
    }
    append_number(out, step.x);
    if (step.y >= 0) out += ' ';
    append_number(out, step.y);
    last = here;
  }
  if (closed) out += 'z';
}

void append_attribute(std::string& out, const char* name, double value) {
  out += std::string(" ") + name + "=\"";
  append_number(out, std::round(value * 100) / 100);
  out += '"';
}

void append_text(std::string& out, double x, double y, double size, const std::string& text) {
  out += "<text";
  append_attribute(out, "x", x);
  append_attribute(out, "y", y);
  append_attribute(out, "font-size", size);
  out += '>' + text + "</text>\n";
}

void draw_elements(const Mesh& mesh, const View& view, std::string& out) {
  std::array<std::string, kClasses.size()> quads, triangles;
  for (const auto& quad : mesh.quads)
    append_path(quads[class_of(scaled_jacobian(corners(mesh, quad)))], view, mesh, quad.data(), 4, true);
  for (const auto& triangle : mesh.triangles)
    append_path(triangles[class_of(scaled_jacobian(corners(mesh, triangle)))], view, mesh, triangle.data(), 3, true);
  out += "<g stroke=\"#303030\" stroke-linejoin=\"round\"";
  append_attribute(out, "stroke-width", std::min(0.8 * view.unit(), 0.05 * view.mean_edge()));
  out += ">\n";
  const auto add = [&](const char* kind, std::size_t i, const std::string& data) {
    if (data.empty()) return;
    out += std::string("<path class=\"") + kind + "\" fill=\"" + kClasses[i].color + "\" d=\"" + data + "\"/>\n";
  };
  // The worst last, on top.
  for (std::size_t i = kClasses.size(); i-- > 0;) {
    add("triangles", i, triangles[i]);
    add("quads", i, quads[i]);
  }
  out += "</g>\n";
}

/// The edges of all curves of a sort, as long runs where one edge starts at the end of the last.
void draw_curves(const Mesh& mesh, const View& view, bool lines, const char* color, double pixels, std::string& out) {
  std::string data;
  for (const EdgeSet& curve : mesh.curves) {
    if ((curve.kind == CurveKind::Line) != lines) continue;
    std::vector<NodeIndex> run;
    for (const auto& [a, b] : curve.edges) {
      if (run.empty() || run.back() != a) {
        if (!run.empty()) append_path(data, view, mesh, run.data(), run.size(), false);
        run = {a};
      }
      run.push_back(b);
    }
    if (!run.empty()) append_path(data, view, mesh, run.data(), run.size(), false);
  }
  if (data.empty()) return;
  out += std::string("<path class=\"") + (lines ? "lines" : "boundary") + "\" fill=\"none\" stroke=\"" + color +
         "\" stroke-linecap=\"round\" stroke-linejoin=\"round\"";
  append_attribute(out, "stroke-width", pixels * view.unit());
  out += " d=\"" + data + "\"/>\n";
}

void draw_points(const Mesh& mesh, const View& view, std::string& out) {
  for (const NodeSet& set : mesh.node_sets) {
    if (set.nodes.size() != 1) continue;  // sets of foreign meshes are no point constraints
    const Spot at = view.spot(mesh.points[set.nodes[0]]);
    out += "<circle class=\"point\" fill=\"#d000d0\"";
    append_attribute(out, "cx", static_cast<double>(at.x));
    append_attribute(out, "cy", static_cast<double>(at.y));
    append_attribute(out, "r", 3 * view.unit());
    out += "/>\n";
  }
}

/// A figure with three decimals.
std::string figure(double value) {
  std::string out;
  append_number(out, std::round(value * 1000) / 1000);
  return out;
}

std::string figures(const Mesh& mesh) {
  std::string text = std::to_string(mesh.quads.size()) + " quads";
  if (!mesh.triangles.empty()) text += ", " + std::to_string(mesh.triangles.size()) + " triangles";
  text += ", " + std::to_string(mesh.points.size()) + " nodes";
  if (mesh.quads.empty()) return text;
  QuadSums sums;  // measure() would look at much more
  for (const auto& nodes : mesh.quads) {
    const QuadPoints quad = corners(mesh, nodes);
    sums.add(quad_distortion(quad), scaled_jacobian(quad));
  }
  text += "; scaled Jacobian least " + figure(sums.jacobian_min()) + ", mean " + figure(sums.jacobian_mean()) +
          "; beta mean " + figure(sums.beta_mean());
  if (sums.n_inverted() > 0) text += "; " + std::to_string(sums.n_inverted()) + " inverted";
  return text;
}

void draw_legend(const Mesh& mesh, const View& view, std::string& out) {
  const double px = view.unit(), top = view.height() + kMargin * px;
  out += "<g class=\"legend\" font-family=\"sans-serif\" fill=\"#202020\">\n";
  append_text(out, 0, top + 16 * px, 15 * px, figures(mesh));
  append_text(out, 0, top + 40 * px, 13 * px, "scaled Jacobian");
  constexpr double kFirst = 118, kStep = 60, kHigh = 12;
  for (std::size_t i = 0; i < kClasses.size(); ++i) {
    const double x = (kFirst + kStep * static_cast<double>(i)) * px;
    out += "<rect";
    append_attribute(out, "x", x);
    append_attribute(out, "y", top + 29 * px);
    append_attribute(out, "width", kStep * px);
    append_attribute(out, "height", kHigh * px);
    out += std::string(" fill=\"") + kClasses[i].color + "\"/>\n";
    append_text(out, x, top + 54 * px, 11 * px, kClasses[i].label);
  }
  append_text(out, (kFirst + kStep * static_cast<double>(kClasses.size())) * px, top + 54 * px, 11 * px, "1");
  out += "</g>\n";
}

}  // namespace

std::string to_svg(const Mesh& mesh) {
  const View view(mesh);
  const double px = view.unit();
  const double width = std::max(view.width(), 0.75 * kPictureWidth * px) + 2 * kMargin * px;
  const double height = view.height() + (2 * kMargin + kLegendHeight) * px;
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\"";
  append_attribute(out, "width", width / px);
  append_attribute(out, "height", height / px);
  out += " viewBox=\"";
  for (const double value : {-kMargin * px, -kMargin * px, width, height}) {
    append_number(out, std::llround(value));
    out += ' ';
  }
  out.back() = '"';
  out += ">\n<rect x=\"-10%\" y=\"-10%\" width=\"120%\" height=\"120%\" fill=\"#ffffff\"/>\n";
  draw_elements(mesh, view, out);
  draw_curves(mesh, view, false, "#1040a0", 1.8, out);
  draw_curves(mesh, view, true, "#7000b0", 2.6, out);
  draw_points(mesh, view, out);
  draw_legend(mesh, view, out);
  return out += "</svg>\n";
}

}  // namespace quadline
