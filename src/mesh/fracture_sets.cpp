#include "mesh/fracture_sets.hpp"

#include "core/log.hpp"
#include "core/random.hpp"
#include "mesh/fracture_faces.hpp"
#include "mesh/geometry.hpp"
#include "mesh/refusal.hpp"
#include "mesh/size_field.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr std::uint32_t kStream = 0x46524143;  // of all fracture sets

/// Room that a body takes, and whether a point is inside.
struct Room {
  Point<3> lower{1e300, 1e300, 0}, upper{-1e300, -1e300, 0};
  double measure = 0;  ///< m2 or m3
  const Shape* shape = nullptr;

  void take(const Point<3>& x) {
    for (int d = 0; d < 3; ++d) {
      lower[d] = std::min(lower[d], x[d]);
      upper[d] = std::max(upper[d], x[d]);
    }
  }

  static bool in_loop(const std::vector<Point<2>>& loop, const Point<3>& x) {
    bool inside = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto &a = loop[i], &b = loop[(i + 1) % loop.size()];
      if ((a[1] > x[1]) == (b[1] > x[1])) continue;
      if (a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) > x[0]) inside = !inside;
    }
    return inside;
  }

  bool holds(const Point<3>& x) const {
    if (const auto* p = std::get_if<Polygon>(shape)) {
      bool inside = in_loop(p->outer, x);
      for (const auto& hole : p->holes) inside = inside && !in_loop(hole, x);
      return inside;
    }
    if (const auto* d = std::get_if<Disc>(shape))
      return std::hypot(x[0] - d->centre[0], x[1] - d->centre[1]) < d->radius;
    if (const auto* b = std::get_if<Ball>(shape)) return length(minus(x, b->centre)) < b->radius;
    if (const auto* c = std::get_if<Cylinder>(shape)) {
      const double s = dot(minus(x, c->centre), c->axis) / dot(c->axis, c->axis);
      return s > 0 && s < 1 && length(minus(x, along(c->centre, s, c->axis))) < c->radius;
    }
    for (int d = 0; d < 3; ++d)
      if (upper[d] > lower[d] && (x[d] < lower[d] || x[d] > upper[d])) return false;
    return true;
  }
};

Room room_of(const BodyShape& body) {
  Room room;
  room.shape = &body.shape;
  const auto box = [&](const Point<3>& centre, double radius, bool space) {
    for (int sign : {-1, 1})
      room.take({centre[0] + sign * radius, centre[1] + sign * radius,
                 space ? centre[2] + sign * radius : 0});
  };
  if (const auto* r = std::get_if<Rectangle>(&body.shape)) {
    room.take({r->lower[0], r->lower[1], 0});
    room.take({r->upper[0], r->upper[1], 0});
    room.measure = (r->upper[0] - r->lower[0]) * (r->upper[1] - r->lower[1]);
  } else if (const auto* d = std::get_if<Disc>(&body.shape)) {
    box({d->centre[0], d->centre[1], 0}, d->radius, false);
    room.measure = kPi * d->radius * d->radius;
  } else if (const auto* p = std::get_if<Polygon>(&body.shape)) {
    for (const auto& x : p->outer) room.take({x[0], x[1], 0});
    const auto area = [](const std::vector<Point<2>>& loop) {
      double twice = 0;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto &a = loop[i], &b = loop[(i + 1) % loop.size()];
        twice += a[0] * b[1] - a[1] * b[0];
      }
      return std::abs(0.5 * twice);
    };
    room.measure = area(p->outer);
    for (const auto& hole : p->holes) room.measure -= area(hole);
  } else if (const auto* b = std::get_if<Box>(&body.shape)) {
    room.take(b->lower);
    room.take(b->upper);
    const auto e = minus(b->upper, b->lower);
    room.measure = e[0] * e[1] * e[2];
  } else if (const auto* ball = std::get_if<Ball>(&body.shape)) {
    box(ball->centre, ball->radius, true);
    room.measure = 4 * kPi / 3 * std::pow(ball->radius, 3);
  } else if (const auto* c = std::get_if<Cylinder>(&body.shape)) {
    box(c->centre, c->radius, true);
    box(along(c->centre, 1.0, c->axis), c->radius, true);
    room.measure = kPi * c->radius * c->radius * length(c->axis);
  } else {
    refuse("body \"" + body.name + "\"",
           "a set of fractures needs a body whose shape is in the scene",
           "put the fractures into the mesh file, or give them as lines");
  }
  return room;
}

/// Two unit vectors across n.
std::array<Point<3>, 2> across(const Point<3>& n) {
  const Point<3> other = std::abs(n[0]) < 0.6 ? Point<3>{1, 0, 0} : Point<3>{0, 1, 0};
  auto u = cross(n, other);
  const double size = length(u);
  for (double& c : u) c /= size;
  return {u, cross(n, u)};
}

/// The random numbers of one attempt.
class Draw {
 public:
  Draw(const FractureSet& set, std::uint64_t attempt)
      : random_{set.seed, kStream + set.stream}, id_(attempt) {}
  double uniform() { return random_.uniform(id_, draw_++); }

 private:
  Random random_;
  std::uint64_t id_;
  std::uint32_t draw_ = 0;
};

double draw_length(const LengthLaw& law, Draw& draw) {
  const double u = draw.uniform(), q = 1 - law.exponent;
  if (law.shortest >= law.longest) return law.longest;
  if (std::abs(q) < 1e-9) return law.shortest * std::pow(law.longest / law.shortest, u);
  const double a = std::pow(law.shortest, q), b = std::pow(law.longest, q);
  return std::pow(a + u * (b - a), 1 / q);
}

/// Angle from the mean by von Mises' distribution: Best and Fisher (1979), doi:10.2307/2346732.
double draw_angle(double kappa, Draw& draw) {
  const double tau = 1 + std::sqrt(1 + 4 * kappa * kappa);
  const double rho = (tau - std::sqrt(2 * tau)) / (2 * kappa);
  const double r = (1 + rho * rho) / (2 * rho);
  for (;;) {
    const double z = std::cos(kPi * draw.uniform()), f = (1 + r * z) / (r + z);
    const double c = kappa * (r - f), u = draw.uniform();
    if (c * (2 - c) > u || std::log(c / u) + 1 - c >= 0)
      return (draw.uniform() < 0.5 ? -1 : 1) * std::acos(std::clamp(f, -1.0, 1.0));
  }
}

Point<3> draw_direction(int dimension, const FractureSet& set, Draw& draw) {
  const double size = length(set.direction);
  const Point<3> mean = {set.direction[0] / size, set.direction[1] / size, set.direction[2] / size};
  if (set.parallel) return mean;
  if (dimension == 2) {
    const double turn =
        set.concentration > 0 ? draw_angle(set.concentration, draw) : kPi * draw.uniform();
    const double c = std::cos(turn), s = std::sin(turn);
    return {c * mean[0] - s * mean[1], s * mean[0] + c * mean[1], 0};
  }
  // Fisher (1953), doi:10.1098/rspa.1953.0064; without concentration uniform on the sphere.
  const double u = draw.uniform(), kappa = set.concentration, turn = 2 * kPi * draw.uniform();
  const double c = kappa > 0 ? 1 + std::log(u + (1 - u) * std::exp(-2 * kappa)) / kappa : 2 * u - 1;
  const double s = std::sqrt(std::max(0.0, 1 - c * c));
  const auto [e1, e2] = across(mean);
  Point<3> n{};
  n = along(along(along(n, c, mean), s * std::cos(turn), e1), s * std::sin(turn), e2);
  return n;
}

/// Part of a piece inside the body, m or m2, by points on it.
double inside_of(const FracturePiece& piece, const Room& room) {
  constexpr int kPoints = 24;
  int in = 0, all = 0;
  Point<3> middle{};
  for (const auto& x : piece) middle = along(middle, 1.0 / static_cast<double>(piece.size()), x);
  for (std::size_t i = 0; i < piece.size(); ++i)
    for (int k = 0; k < kPoints; ++k) {
      // Equal shares of the length, or rings of equal area of a polygon.
      const double s = (k + 0.5) / kPoints, t = piece.size() == 2 ? s : std::sqrt(s);
      in += room.holds(along(middle, t, minus(piece[i], middle))) ? 1 : 0;
      ++all;
    }
  return measure_of(piece) * in / all;
}

}  // namespace

std::array<Point<3>, 2> box_of(const BodyShape& body) {
  const Room room = room_of(body);
  return {room.lower, room.upper};
}

bool touches_inside(const BodyShape& body, const FracturePiece& piece) {
  return inside_of(piece, room_of(body)) > 0;
}

FracturePiece disc_piece(const Point<3>& centre, const Point<3>& normal, double radius,
                         double size) {
  const double ask = 2 * kPi * radius / size;
  const int corners = static_cast<int>(std::clamp(std::round(ask), 8.0, 48.0));
  const double n = length(normal), step = 2 * kPi / corners;
  const auto [u, v] = across({normal[0] / n, normal[1] / n, normal[2] / n});
  const double reach = radius * std::sqrt(step / std::sin(step));  // the area of the disc
  FracturePiece piece;
  for (int i = 0; i < corners; ++i)
    piece.push_back(
        along(along(centre, reach * std::cos(i * step), u), reach * std::sin(i * step), v));
  return piece;
}

std::vector<FracturePiece> draw_fractures(int dimension, const FractureSet& set,
                                          const BodyShape& body,
                                          const std::vector<FracturePiece>& others) {
  constexpr std::uint64_t kTries = 200;  // for each that fits
  const Room room = room_of(body);
  std::vector<FracturePiece> pieces;
  double done = 0;
  std::uint64_t attempt = 0, since = 0;
  const auto enough = [&] {
    return set.number > 0 ? static_cast<int>(pieces.size()) >= set.number
                          : done >= set.intensity * room.measure;
  };
  for (; !enough(); ++attempt, ++since) {
    if (since > kTries)
      refuse("body \"" + body.name + "\"",
             "after " + std::to_string(pieces.size()) +
                 " random fractures there is no room for more without slivers",
             "ask for fewer or shorter ones, or take smaller elements");
    Draw draw(set, attempt);
    Point<3> centre{};
    for (int d = 0; d < dimension; ++d)
      centre[d] = room.lower[d] + draw.uniform() * (room.upper[d] - room.lower[d]);
    if (!room.holds(centre)) {
      --since;
      continue;
    }
    const double extent = draw_length(set.length, draw);
    const Point<3> direction = draw_direction(dimension, set, draw);
    const double h = element_size(body, centre);
    const FracturePiece piece = dimension == 2
                                    ? FracturePiece{along(centre, -0.5 * extent, direction),
                                                    along(centre, 0.5 * extent, direction)}
                                    : disc_piece(centre, direction, 0.5 * extent, h);
    const auto meets = [&](const FracturePiece& other) {
      return !conflict_of(piece, other, h).empty();
    };
    if (!conflict_with_surface(body, piece).empty() ||
        std::any_of(pieces.begin(), pieces.end(), meets) ||
        std::any_of(others.begin(), others.end(), meets))
      continue;
    done += inside_of(piece, room);
    pieces.push_back(piece);
    since = 0;
  }
  return pieces;
}

std::vector<FracturePiece> parallel_planes(int dimension, const BodyShape& body, double spacing,
                                           const Point<3>& direction, const Point<3>& through) {
  const Room room = room_of(body);
  const double size = length(direction), reach = 0.55 * length(minus(room.upper, room.lower));
  Point<3> normal = {direction[0] / size, direction[1] / size, direction[2] / size};
  if (dimension == 2) normal = {-normal[1], normal[0], 0};
  const auto [u, v] = across(normal);
  Point<3> middle = along(room.lower, 0.5, minus(room.upper, room.lower));
  const double offset = dot(minus(through, middle), normal);
  std::vector<FracturePiece> pieces;
  const int last = static_cast<int>(std::ceil(2 * reach / spacing));
  for (int n = -last; n <= last; ++n) {
    const double at = std::remainder(offset, spacing) + n * spacing;
    if (std::abs(at) > reach) continue;
    const Point<3> centre = along(middle, at, normal);
    FracturePiece piece;
    if (dimension == 2) {
      const Point<3> t = {normal[1], -normal[0], 0};
      piece = {along(centre, -1.02 * reach, t), along(centre, 1.02 * reach, t)};
    } else {
      for (const auto& [a, b] :
           {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
        piece.push_back(along(along(centre, 1.02 * a * reach, u), 1.02 * b * reach, v));
    }
    if (inside_of(piece, room) > 0 && conflict_with_surface(body, piece).empty())
      pieces.push_back(piece);
  }
  return pieces;
}

}  // namespace breccia
