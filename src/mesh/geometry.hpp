#pragma once

#include "base/simplex.hpp"
#include "mesh/mesh.hpp"

#include <array>
#include <cmath>

namespace breccia {

/// Corner positions of one simplex. Unit m.
template <int D>
using Simplex = std::array<Point<D>, D + 1>;

template <std::size_t D>
std::array<double, D> minus(const std::array<double, D>& a, const std::array<double, D>& b) {
  std::array<double, D> c{};
  for (std::size_t k = 0; k < D; ++k) c[k] = a[k] - b[k];
  return c;
}

/// a + s b
template <std::size_t D>
std::array<double, D> along(const std::array<double, D>& a, double s,
                            const std::array<double, D>& b) {
  std::array<double, D> c{};
  for (std::size_t k = 0; k < D; ++k) c[k] = a[k] + s * b[k];
  return c;
}

template <std::size_t D>
double dot(const std::array<double, D>& a, const std::array<double, D>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < D; ++k) sum += a[k] * b[k];
  return sum;
}

template <std::size_t D>
double length(const std::array<double, D>& a) {
  return std::sqrt(dot(a, a));
}

inline Point<3> cross(const Point<3>& a, const Point<3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <int D>
Simplex<D> corners(const Mesh<D>& mesh, Index element) {
  Simplex<D> x;
  for (int a = 0; a <= D; ++a) x[a] = mesh.point[mesh.element[element][a]];
  return x;
}

/// Signed area (m2) or volume (m3); positive for a positively oriented simplex.
template <int D>
double signed_volume(const Simplex<D>& x) {
  const auto u = minus(x[1], x[0]);
  const auto v = minus(x[2], x[0]);
  if constexpr (D == 2) {
    return 0.5 * (u[0] * v[1] - u[1] * v[0]);
  } else {
    return dot(cross(u, v), minus(x[3], x[0])) / 6.0;
  }
}

/// Outward normal of local face f times its length (m) or area (m2).
template <int D>
Point<D> face_normal_area(const Simplex<D>& x, int face) {
  const auto& a = x[face_node<D>(face, 0)];
  const auto u = minus(x[face_node<D>(face, 1)], a);
  if constexpr (D == 2) {
    return {u[1], -u[0]};
  } else {
    const auto n = cross(u, minus(x[face_node<D>(face, 2)], a));
    return {0.5 * n[0], 0.5 * n[1], 0.5 * n[2]};
  }
}

/// Height over each face (m): D times the volume over the area of the face opposite node a.
template <int D>
std::array<double, D + 1> heights(const Simplex<D>& x) {
  const double volume = std::abs(signed_volume<D>(x));
  std::array<double, D + 1> h{};
  for (int a = 0; a <= D; ++a) {
    const double area = length(face_normal_area<D>(x, a));
    h[a] = area > 0 ? D * volume / area : 0;
  }
  return h;
}

template <int D>
Point<D> centroid(const Simplex<D>& x) {
  Point<D> c{};
  for (const auto& corner : x) c = along(c, 1.0 / (D + 1), corner);
  return c;
}

/// Sum of the signed volumes of one body's elements (all bodies: kNone).
template <int D>
double total_volume(const Mesh<D>& mesh, Index body = kNone) {
  double sum = 0;
  for (Index e = 0; e < mesh.elements(); ++e) {
    if (body == kNone || mesh.body[e] == body) sum += signed_volume<D>(corners(mesh, e));
  }
  return sum;
}

/// Largest stable step of a linear simplex (s): 2 / (c_p sqrt((D + 1) sum_a 1 / h_a^2)),
/// ALGORITHMS. `wave_speed` is the P-wave speed in m/s.
template <int D>
double stable_step(const Simplex<D>& x, double wave_speed) {
  double sum = 0;
  for (double h : heights<D>(x)) sum += 1.0 / (h * h);
  return 2.0 / (wave_speed * std::sqrt((D + 1) * sum));
}

}  // namespace breccia
