#include "mesh/quality.hpp"

#include "mesh/geometry.hpp"
#include "mesh/refusal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace breccia {
namespace {

constexpr double kDegrees = 57.295779513082320877;

template <int D>
double clamped_angle(const Point<D>& a, const Point<D>& b) {
  const double size = length(a) * length(b);
  return size > 0 ? std::acos(std::clamp(dot(a, b) / size, -1.0, 1.0)) : 0;
}

/// Smallest angle between two edges (plane) or two faces (space), which equals pi minus the angle
/// of their normals.
template <int D>
double least_angle(const Simplex<D>& x) {
  double least = std::numeric_limits<double>::infinity();
  for (int a = 0; a <= D; ++a) {
    for (int b = 0; b < a; ++b) {
      const auto n = face_normal_area<D>(x, a);
      const auto m = face_normal_area<D>(x, b);
      least = std::min(least, std::numbers::pi - clamped_angle<D>(n, m));
    }
  }
  return least;
}

double circumradius(const Simplex<2>& x) {
  double product = 1;
  for (int f = 0; f < 3; ++f) product *= length(face_normal_area<2>(x, f));
  return product / (4 * std::abs(signed_volume<2>(x)));
}

/// Radius from the products of opposite edges: R = sqrt(s (s-a) (s-b) (s-c)) / (6 V), (a, b, c)
/// those products.
double circumradius(const Simplex<3>& x) {
  const auto edge = [&](int a, int b) { return length(minus(x[a], x[b])); };
  const double p = edge(0, 1) * edge(2, 3);
  const double q = edge(0, 2) * edge(1, 3);
  const double r = edge(0, 3) * edge(1, 2);
  const double s = 0.5 * (p + q + r);
  return std::sqrt(std::max(0.0, s * (s - p) * (s - q) * (s - r))) /
         (6 * std::abs(signed_volume<3>(x)));
}

template <int D>
double shape_quality(const Simplex<D>& x) {
  if (!(std::abs(signed_volume<D>(x)) > 0)) return 0;
  double sum = 0;
  for (double h : heights<D>(x)) sum += 1 / h;
  return std::min(1.0, D / (sum * circumradius(x)));  // the inradius is 1 / sum
}

template <int D>
void keep_least(NotableElement<D>& least, double value, Index element) {
  if (least.element == kNone || value < least.value) least = {element, value, {}};
}

/// Running sums of the report.
struct Sums {
  double edges = 0, edge_count = 0, shape = 0, step = 0;
};

template <int D>
void count_edges(const Simplex<D>& x, QualityReport<D>& report, Sums& sums) {
  for (int a = 0; a <= D; ++a) {
    for (int b = 0; b < a; ++b, sums.edge_count += 1) {
      const double size = length(minus(x[a], x[b]));
      report.min_size = std::min(report.min_size, size);
      report.max_size = std::max(report.max_size, size);
      sums.edges += size;
    }
  }
}

template <int D>
std::string notable_line(const std::string& name, const NotableElement<D>& worst,
                         const std::string& value) {
  char text[160];
  std::snprintf(text, sizeof text, "  %-16s %-14s element %d at %s\n", name.c_str(), value.c_str(),
                static_cast<int>(worst.element), place_text(worst.centroid).c_str());
  return text;
}

template <int D>
Index count_composites(const Mesh<D>& mesh) {
  std::vector<Index> elements(mesh.body_names.size(), 0);
  for (Index b : mesh.body) ++elements[b];
  Index count = 0;
  for (std::size_t b = 0; b < elements.size(); ++b) {
    const int group = mesh.group_of_body(static_cast<Index>(b));
    if (group > 1) count += elements[b] / group;
  }
  return count;
}

}  // namespace

template <int D>
QualityReport<D> assess_quality(const Mesh<D>& mesh, std::span<const double> wave_speed) {
  if (!wave_speed.empty() && wave_speed.size() != mesh.body_names.size()) {
    throw std::logic_error("assess_quality: one wave speed per body is needed");
  }
  QualityReport<D> report;
  report.elements = mesh.elements();
  report.points = mesh.points();
  report.composites = count_composites(mesh);
  if (mesh.element.empty()) return report;
  report.min_size = std::numeric_limits<double>::infinity();
  Sums sums;
  for (Index e = 0; e < mesh.elements(); ++e) {
    const auto x = corners(mesh, e);
    const auto h = heights<D>(x);
    const double shape = shape_quality<D>(x);
    report.volume += signed_volume<D>(x);
    count_edges<D>(x, report, sums);
    keep_least(report.min_height, *std::min_element(h.begin(), h.end()), e);
    keep_least(report.min_angle, least_angle<D>(x), e);
    keep_least(report.worst_shape, shape, e);
    sums.shape += shape;
    ++report.shape_histogram[std::min(9, static_cast<int>(shape * 10))];
    if (wave_speed.empty()) continue;
    const double step = stable_step<D>(x, wave_speed[mesh.body[e]]);
    keep_least(report.time_step, step, e);
    sums.step += step;
  }
  report.mean_size = sums.edges / sums.edge_count;
  report.mean_shape = sums.shape / report.elements;
  report.mean_time_step = sums.step / report.elements;
  for (auto* worst :
       {&report.min_height, &report.min_angle, &report.worst_shape, &report.time_step}) {
    if (worst->element != kNone) worst->centroid = centroid<D>(corners(mesh, worst->element));
  }
  if (!wave_speed.empty()) {
    report.time_step_body = mesh.body_names[mesh.body[report.time_step.element]];
  }
  return report;
}

template <int D>
std::string to_text(const QualityReport<D>& report) {
  const auto number = [](double x) { return short_number(x); };
  std::string text = "mesh: " + std::to_string(report.elements) + " elements, " +
                     std::to_string(report.points) + " points, " + number(report.volume) +
                     (D == 2 ? " m2\n" : " m3\n");
  if (report.elements == 0) return text;
  if (report.composites > 0) {
    text += "  composites       " + std::to_string(report.composites) +
            "; what follows is of their sub-elements\n";
  }
  text += "  edge length      " + number(report.min_size) + " to " + number(report.max_size) +
          " m, mean " + number(report.mean_size) + " m\n";
  text += notable_line("least height", report.min_height, number(report.min_height.value) + " m");
  text += notable_line("least angle", report.min_angle,
                       number(report.min_angle.value * kDegrees) + " deg");
  text += notable_line("worst shape", report.worst_shape, number(report.worst_shape.value));
  text += "  mean shape       " + number(report.mean_shape) + " (1 is regular)\n";
  text += "  elements by shape quality\n";
  const auto most = *std::max_element(report.shape_histogram.begin(), report.shape_histogram.end());
  for (int i = 0; i < 10; ++i) {
    const Index count = report.shape_histogram[i];
    if (count == 0) continue;
    const auto bar = static_cast<std::size_t>(40.0 * count / most + 0.5);
    char line[80];
    std::snprintf(line, sizeof line, "    %.1f to %.1f %9d  ", 0.1 * i, 0.1 * (i + 1),
                  static_cast<int>(count));
    text += line + std::string(bar, '#') + "\n";
  }
  if (report.time_step.element != kNone) {
    text += notable_line("stable step", report.time_step, number(report.time_step.value) + " s");
    text += "                   of body \"" + report.time_step_body + "\"; mean over elements " +
            number(report.mean_time_step) + " s\n";
  }
  return text;
}

template QualityReport<2> assess_quality<2>(const Mesh<2>&, std::span<const double>);
template QualityReport<3> assess_quality<3>(const Mesh<3>&, std::span<const double>);
template std::string to_text<2>(const QualityReport<2>&);
template std::string to_text<3>(const QualityReport<3>&);

}  // namespace breccia
