#include "mesh/fracture_net.hpp"

#include "mesh/geometry.hpp"
#include "mesh/refusal.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {
namespace {

constexpr double kTouch = 1e-6;        // of the element size
constexpr double kNear = 0.1;          // of the element size
constexpr double kSliver = 0.0871557;  // sine of 5 degrees

double distance_to_segment(const Point<3>& x, const Point<3>& a, const Point<3>& b) {
  const auto axis = minus(b, a);
  const double s = std::clamp(dot(minus(x, a), axis) / dot(axis, axis), 0.0, 1.0);
  return length(minus(x, along(a, s, axis)));
}

Point<3> unit_normal(const FracturePiece& polygon) {
  Point<3> n{};
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    n = along(n, 1.0, cross(minus(polygon[i], polygon[0]), minus(polygon[i + 1], polygon[0])));
  const double size = length(n);
  return {n[0] / size, n[1] / size, n[2] / size};
}

/// Whether the foot of x on the plane of a convex polygon lies inside it.
bool is_above(const FracturePiece& polygon, const Point<3>& n, const Point<3>& x) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto edge = minus(polygon[(i + 1) % polygon.size()], polygon[i]);
    if (dot(cross(edge, minus(x, polygon[i])), n) < 0) return false;
  }
  return true;
}

bool pierces(const FracturePiece& a, const FracturePiece& b, const Point<3>& normal) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto& p = a[i];
    const auto& q = a[(i + 1) % a.size()];
    const double dp = dot(minus(p, b[0]), normal), dq = dot(minus(q, b[0]), normal);
    if (dp * dq < 0 && is_above(b, normal, along(p, dp / (dp - dq), minus(q, p)))) return true;
  }
  return false;
}

std::string degrees(double sine) {
  return short_number(std::asin(std::min(1.0, sine)) * 57.29577951308232) + " degrees";
}

std::string near_text(double distance, const Point<3>& x) {
  return "ends " + short_number(distance) + " m beside it, at " + place_text(x);
}

/// Two segments of the plane.
std::string conflict_of_segments(const FracturePiece& a, const FracturePiece& b, double h) {
  bool touch = false, ends = false;
  for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const auto& x : *one) {
      const double d = distance_to_segment(x, (*other)[0], (*other)[1]);
      if (d > kTouch * h && d < kNear * h) return near_text(d, x);
      if (d > kTouch * h) continue;
      touch = true;
      for (const auto& y : *other) ends = ends || length(minus(x, y)) <= kTouch * h;
    }
  }
  auto u = minus(a[1], a[0]), v = minus(b[1], b[0]);
  const double sine = std::abs(cross(u, v)[2]) / (length(u) * length(v));
  const auto side = [](const FracturePiece& s, const Point<3>& x) {
    return cross(minus(s[1], s[0]), minus(x, s[0]))[2];
  };
  const bool crosses = side(a, b[0]) * side(a, b[1]) < 0 && side(b, a[0]) * side(b, a[1]) < 0;
  if ((!touch && !crosses) || sine >= kSliver) return "";
  if (ends) {  // directions away from the common end
    if (std::min(length(minus(a[1], b[0])), length(minus(a[1], b[1]))) <= kTouch * h)
      u = minus(a[0], a[1]);
    if (std::min(length(minus(b[1], a[0])), length(minus(b[1], a[1]))) <= kTouch * h)
      v = minus(b[0], b[1]);
    if (dot(u, v) < 0) return "";  // one goes on where the other ends
  }
  return sine < 1e-6 ? "coincides with it" : "meets it at " + degrees(sine);
}

std::string conflict_of_polygons(const FracturePiece& a, const FracturePiece& b, double h) {
  const auto na = unit_normal(a), nb = unit_normal(b);
  const double sine = length(cross(na, nb));
  for (const auto& [one, other, n] : {std::tuple(&a, &b, &nb), std::tuple(&b, &a, &na)}) {
    auto points = *one;
    Point<3> middle{};
    for (const auto& x : *one) middle = along(middle, 1.0 / static_cast<double>(one->size()), x);
    points.push_back(middle);
    for (const auto& x : points) {
      const double d = std::abs(dot(minus(x, (*other)[0]), *n));
      if (d >= kNear * h || !is_above(*other, *n, x)) continue;
      if (sine < kSliver) return "coincides with it at " + place_text(x);
      if (d > kTouch * h && x != middle) return near_text(d, x);
    }
  }
  if (sine < kSliver && (pierces(a, b, nb) || pierces(b, a, na)))
    return "meets it at " + degrees(sine);
  return "";
}

}  // namespace

double measure_of(const FracturePiece& piece) {
  if (piece.size() == 2) return length(minus(piece[1], piece[0]));
  Point<3> n{};
  for (std::size_t i = 1; i + 1 < piece.size(); ++i)
    n = along(n, 0.5, cross(minus(piece[i], piece[0]), minus(piece[i + 1], piece[0])));
  return length(n);
}

double distance_to(const FracturePiece& piece, const Point<3>& x) {
  if (piece.size() > 2) {
    const auto n = unit_normal(piece);
    if (is_above(piece, n, x)) return std::abs(dot(minus(x, piece[0]), n));
  }
  double least = distance_to_segment(x, piece[0], piece[1]);
  for (std::size_t i = 1; piece.size() > 2 && i < piece.size(); ++i)
    least = std::min(least, distance_to_segment(x, piece[i], piece[(i + 1) % piece.size()]));
  return least;
}

std::string conflict_of(const FracturePiece& a, const FracturePiece& b, double h) {
  for (int d = 0; d < 3; ++d) {  // boxes apart
    double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
    for (const auto& x : a) low[0] = std::min(low[0], x[d]), high[0] = std::max(high[0], x[d]);
    for (const auto& x : b) low[1] = std::min(low[1], x[d]), high[1] = std::max(high[1], x[d]);
    if (low[0] > high[1] + kNear * h || low[1] > high[0] + kNear * h) return "";
  }
  return a.size() == 2 ? conflict_of_segments(a, b, h) : conflict_of_polygons(a, b, h);
}

}  // namespace breccia
