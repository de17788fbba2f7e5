#pragma once

#include "harness/failures.hpp"
#include "mesh/geometry.hpp"
#include "mesh/mesh.hpp"
#include "mesh/shapes.hpp"
#include "mesh/structured.hpp"

#include <gtest/gtest.h>

#include <string>

namespace breccia {

/// Two triangles on the unit square, body "plate".
inline Mesh<2> two_triangles() {
  Mesh<2> mesh;
  mesh.point = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.element = {{0, 1, 2}, {0, 2, 3}};
  mesh.body = {0, 0};
  mesh.body_names = {"plate"};
  return mesh;
}

/// One tetrahedron on the unit axes, body "block".
inline Mesh<3> one_tetrahedron() {
  Mesh<3> mesh;
  mesh.point = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.element = {{0, 1, 2, 3}};
  mesh.body = {0};
  mesh.body_names = {"block"};
  return mesh;
}

template <int D>
Mesh<D> grid_mesh(Index cells, Pattern pattern, double jitter = 0) {
  Grid<D> grid;
  grid.upper.fill(1);
  grid.cells.fill(cells);
  grid.pattern = pattern;
  grid.jitter = jitter;
  return structured_mesh(grid);
}

inline BodyShape body_of(const std::string& name, Shape shape, double size) {
  BodyShape body;
  body.name = name;
  body.shape = std::move(shape);
  body.size = size;
  return body;
}

template <int D>
Mesh<D> mesh_one(const BodyShape& body) {
  return mesh_bodies<D>(std::span<const BodyShape>(&body, 1));
}

/// Sum of the lengths or areas of a region's faces.
template <int D>
double face_area(const Mesh<D>& mesh, const std::string& region) {
  const Region* side = find_region(mesh, region);
  if (!side) return -1;
  double sum = 0;
  for (const ElementFace& f : side->faces) {
    sum += length(face_normal_area<D>(corners(mesh, f.element), f.face));
  }
  return sum;
}

template <int D>
void expect_same_regions(const Mesh<D>& a, const Mesh<D>& b) {
  ASSERT_EQ(a.regions.size(), b.regions.size());
  for (std::size_t r = 0; r < a.regions.size(); ++r) {
    EXPECT_EQ(a.regions[r].name, b.regions[r].name);
    EXPECT_EQ(a.regions[r].elements, b.regions[r].elements) << a.regions[r].name;
    EXPECT_EQ(a.regions[r].faces, b.regions[r].faces) << a.regions[r].name;
    EXPECT_EQ(a.regions[r].points, b.regions[r].points) << a.regions[r].name;
  }
}

/// Equal to the last bit.
template <int D>
void expect_same_mesh(const Mesh<D>& a, const Mesh<D>& b) {
  EXPECT_EQ(a.point, b.point);
  EXPECT_EQ(a.element, b.element);
  EXPECT_EQ(a.body, b.body);
  EXPECT_EQ(a.body_names, b.body_names);
  EXPECT_EQ(a.curved, b.curved);
  EXPECT_EQ(a.group_size, b.group_size);
  expect_same_regions(a, b);
}

}  // namespace breccia
