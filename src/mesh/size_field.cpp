#include "mesh/size_field.hpp"

#include "mesh/geometry.hpp"

#include <algorithm>
#include <limits>

namespace breccia {
namespace {

constexpr double kGrowth =
    0.3;  // of the size per unit length: neighbours differ by less than a third

struct Extent {
  double operator()(const Rectangle& r) const { return length(minus(r.upper, r.lower)); }
  double operator()(const Disc& d) const { return 2 * d.radius; }
  double operator()(const Polygon& p) const {
    Point<2> lower, upper;
    lower.fill(std::numeric_limits<double>::infinity());
    upper.fill(-std::numeric_limits<double>::infinity());
    for (const auto& x : p.outer) {
      for (int k = 0; k < 2; ++k) {
        lower[k] = std::min(lower[k], x[k]);
        upper[k] = std::max(upper[k], x[k]);
      }
    }
    return p.outer.empty() ? 0 : length(minus(upper, lower));
  }
  double operator()(const Box& b) const { return length(minus(b.upper, b.lower)); }
  double operator()(const Ball& b) const { return 2 * b.radius; }
  double operator()(const Cylinder& c) const { return length(c.axis) + 2 * c.radius; }
  double operator()(const MeshFile&) const { return 0; }
};

}  // namespace

double element_size(const BodyShape& body, const Point<3>& x) {
  double size = body.size;
  for (const Refinement& r : body.refinements) {
    const double gap = length(minus(x, r.at)) - r.radius;
    const double span = r.transition > 0 ? r.transition : (body.size - r.size) / kGrowth;
    const double s = span > 0 ? std::clamp(gap / span, 0.0, 1.0) : (gap > 0 ? 1.0 : 0.0);
    size = std::min(size, r.size + s * (body.size - r.size));
  }
  for (const FractureNet& net : body.fractures) {
    if (net.size <= 0) continue;
    const double growth = net.growth > 0 ? net.growth : kGrowth;
    for (const FracturePiece& piece : net.pieces)
      size = std::min(size, net.size + growth * distance_to(piece, x));
  }
  return size;
}

double extent_of(const Shape& shape) {
  return std::visit(Extent{}, shape);
}

}  // namespace breccia
