#include "mesh/fracture_faces.hpp"
#include "mesh/geometry.hpp"
#include "mesh/refusal.hpp"
#include "mesh/size_field.hpp"

#include <algorithm>
#include <cmath>

namespace breccia {
namespace {

constexpr double kTouch = 1e-6, kNear = 0.1;  // of the element size

Point<3> lifted(const Point<2>& x) {
  return {x[0], x[1], 0};
}

void add_loop(const std::vector<Point<2>>& loop, std::vector<FracturePiece>& edges) {
  for (std::size_t i = 0; i < loop.size(); ++i)
    edges.push_back({lifted(loop[i]), lifted(loop[(i + 1) % loop.size()])});
}

/// Straight edges of a plane body.
std::vector<FracturePiece> edges_of(const Shape& shape) {
  std::vector<FracturePiece> edges;
  if (const auto* r = std::get_if<Rectangle>(&shape))
    add_loop({r->lower, {r->upper[0], r->lower[1]}, r->upper, {r->lower[0], r->upper[1]}}, edges);
  if (const auto* p = std::get_if<Polygon>(&shape)) {
    add_loop(p->outer, edges);
    for (const auto& hole : p->holes) add_loop(hole, edges);
  }
  return edges;
}

/// Depth of a point below the surface of a round body or a box (m), negative outside; far inside
/// for the other shapes.
double depth_of(const Shape& shape, const Point<3>& x) {
  if (const auto* d = std::get_if<Disc>(&shape))
    return d->radius - length(minus(x, lifted(d->centre)));
  if (const auto* b = std::get_if<Ball>(&shape)) return b->radius - length(minus(x, b->centre));
  double depth = 1e300;
  if (const auto* b = std::get_if<Box>(&shape))
    for (int d = 0; d < 3; ++d) depth = std::min({depth, x[d] - b->lower[d], b->upper[d] - x[d]});
  return depth;
}

std::string piece_text(const FractureNet& net, std::size_t piece) {
  return "fracture \"" + net.name + "\", piece " + std::to_string(piece) + " from " +
         place_text(net.pieces[piece][0]);
}

void check_piece(int dimension, const FractureNet& net, std::size_t n, const std::string& place) {
  const FracturePiece& piece = net.pieces[n];
  const bool right = dimension == 2 ? piece.size() == 2 : piece.size() >= 3;
  if (!right || !(measure_of(piece) > 0))
    refuse(place, piece_text(net, n) + " has no extent",
           dimension == 2 ? "give at least two different points"
                          : "give at least three corners that are not on one line");
  for (std::size_t i = 3; i < piece.size(); ++i) {
    const double off = distance_to({piece[0], piece[1], piece[2]}, piece[i]);
    const FracturePiece plane = {piece[0], piece[1], piece[2]};
    const auto normal = cross(minus(piece[1], piece[0]), minus(piece[2], piece[0]));
    if (std::abs(dot(minus(piece[i], piece[0]), normal)) / length(normal) <=
        1e-6 * (off + length(normal)))
      continue;
    refuse(place, piece_text(net, n) + " is not flat: corner " + std::to_string(i) + " is off",
           "cut it into triangles");
  }
}

}  // namespace

std::string conflict_with_surface(const BodyShape& body, const FracturePiece& piece) {
  for (const auto& x : piece) {
    const double h = element_size(body, x), depth = depth_of(body.shape, x);
    if (depth > kTouch * h && depth < kNear * h)
      return "ends " + short_number(depth) + " m below the surface, at " + place_text(x);
  }
  for (const auto& edge : edges_of(body.shape)) {
    const std::string conflict = conflict_of(piece, edge, element_size(body, piece[0]));
    if (!conflict.empty()) return conflict + " (the edge from " + place_text(edge[0]) + ")";
  }
  return "";
}

void check_fractures(int dimension, const BodyShape& body) {
  const std::string place = "body \"" + body.name + "\"";
  struct Item {
    const FractureNet* net;
    std::size_t piece;
  };
  std::vector<Item> items;
  for (const FractureNet& net : body.fractures)
    for (std::size_t n = 0; n < net.pieces.size(); ++n) {
      check_piece(dimension, net, n, place);
      items.push_back({&net, n});
    }
  constexpr const char* kRemedy =
      "let one end at the other or cross it at a larger angle, move it, or take smaller elements";
  for (std::size_t i = 0; i < items.size(); ++i) {
    const FracturePiece& piece = items[i].net->pieces[items[i].piece];
    const std::string at_surface = conflict_with_surface(body, piece);
    if (!at_surface.empty())
      refuse(place, piece_text(*items[i].net, items[i].piece) + ": it " + at_surface,
             "let it end on the surface or beyond, or further inside");
    const double h = element_size(body, piece[0]);
    for (std::size_t j = 0; j < i; ++j) {
      const FracturePiece& other = items[j].net->pieces[items[j].piece];
      const std::string conflict =
          conflict_of(piece, other, std::min(h, element_size(body, other[0])));
      if (conflict.empty()) continue;
      refuse(place,
             piece_text(*items[i].net, items[i].piece) + " and " +
                 piece_text(*items[j].net, items[j].piece) + ": one " + conflict,
             kRemedy);
    }
  }
}

}  // namespace breccia
