#pragma once
#include "base/simplex.hpp"
#include "harness/simulation.hpp"
#include "loops/element_stress.hpp"
#include "step/stress_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace breccia {

// Scenes of one elastic block, written as a user writes them, and looks inside them.

/// One body "b" of material "m" from its mesh file or structured grid.
struct BlockScene {
  int dimension = 2;
  std::string size = "[1, 1]";   ///< m, from the origin
  std::string cells = "[4, 4]";  ///< of the structured grid
  std::string pattern = {};      ///< cross and kuhn if empty
  double jitter = 0;
  std::string element = {};  ///< tri3 and tet4 if empty
  std::string file = {};     ///< mesh file instead of the grid
  double density = 1000, young = 1e9, poisson = 0.3, damping = 0;
  std::string material = {};  ///< further keys of the material, or others than `elastic`
  bool elastic = true;        ///< false: `material` has the elastic constants
  std::string plane = "strain";
  std::string run = "duration = 1";  ///< further keys of [run]
  std::string body = {};             ///< further keys of the body
  std::string more = {};             ///< further sections

  std::string text() const {
    std::string shape, mesh;
    if (file.empty()) {
      const std::string origin = dimension == 2 ? "[0, 0]" : "[0, 0, 0]";
      shape = fmt::format("shape = {{ {} = {{ corner = {}, size = {} }} }}",
                          dimension == 2 ? "rectangle" : "box", origin, size);
      mesh = fmt::format("mesh = {{ generator = \"structured\", cells = {}, jitter = {}{}{} }}",
                         cells, jitter, pattern.empty() ? "" : ", pattern = \"" + pattern + "\"",
                         element.empty() ? "" : ", element = \"" + element + "\"");
    } else {
      shape = fmt::format("shape = {{ file = \"{}\" }}", file);
    }
    return fmt::format(
        "[run]\ndimension = {}\n{}{}\n"
        "[[body]]\nname = \"b\"\nmaterial = \"m\"\n{}\n{}\n{}\n"
        "[material.m]\ndensity = {:.17g}\ndamping = {:.17g}\n{}\n{}\n{}\n",
        dimension, dimension == 2 ? "plane = \"" + plane + "\"\n" : "", run, body, shape, mesh,
        density, damping,
        elastic ? fmt::format("elastic = {{ young = {:.17g}, poisson = {:.17g} }}", young, poisson)
                : "",
        material, more);
  }
};

template <int D>
Vec<D> vector_of(const Point<D>& p) {
  Vec<D> v;
  for (int d = 0; d < D; ++d) v[d] = p[static_cast<std::size_t>(d)];
  return v;
}

template <int D>
using VectorField = std::function<Vec<D>(const Vec<D>&)>;

/// Nodal values f(X) of a field with D components: positions, velocities.
template <class Field, int D>
void put_field(SceneWorld<D>& world, const VectorField<D>& f) {
  const auto host = world.template host<Field>();
  for (Index n = 0; n < world.model().mesh.points(); ++n) {
    const Vec<D> value = f(vector_of<D>(world.model().mesh.point[static_cast<std::size_t>(n)]));
    for (int d = 0; d < D; ++d) host(n, d) = value[d];
  }
  world.template put<Field>(host);
}

/// True for nodes that lie on no free face.
template <int D>
std::vector<bool> inner_nodes(const Model<D>& model) {
  std::vector<bool> inner(model.mesh.point.size(), true);
  for (const ElementFace& f : model.topology.free)
    for (int j = 0; j < D; ++j) {
      const auto& nodes = model.mesh.element[static_cast<std::size_t>(f.element)];
      inner[static_cast<std::size_t>(nodes[static_cast<std::size_t>(face_node<D>(f.face, j))])] =
          false;
    }
  return inner;
}

/// The law of the one material.
template <int D>
HenckyElastic law_of(SceneWorld<D>& world) {
  const auto lame = world.template host<MaterialLame>();
  return {lame(0, 0), lame(0, 1)};
}

/// Cauchy stress of a deformation gradient.
template <int D>
Sym<D> stress_of(const HenckyElastic& law, const Mat<D>& f) {
  const double jacobian = determinant(f);
  return law.kirchhoff(hencky_strain(left_cauchy_green(f), jacobian)) * (1 / jacobian);
}

/// Cauchy stress of every element now.
template <int D>
std::vector<Sym<D>> element_stresses(SceneWorld<D>& world) {
  const auto host = Kokkos::create_mirror_view_and_copy(
      Kokkos::HostSpace{}, cauchy_stress(stress_of(world.model()), world.model().elements()));
  std::vector<Sym<D>> all(host.extent(0));
  for (std::size_t e = 0; e < all.size(); ++e)
    for (int c = 0; c < Sym<D>::size; ++c) all[e].s[c] = host(e, c);
  return all;
}

/// Sums of a class of corner forces on the nodes, N.
template <class Force, int D>
std::vector<Vec<D>> nodal_forces(SceneWorld<D>& world) {
  const auto corner = world.template host<Force>();
  const Mesh<D>& mesh = world.model().mesh;
  std::vector<Vec<D>> force(mesh.point.size(), Vec<D>::zero());
  for (std::size_t e = 0; e < mesh.element.size(); ++e)
    for (std::size_t a = 0; a <= D; ++a)
      for (int d = 0; d < D; ++d)
        force[static_cast<std::size_t>(mesh.element[e][a])][d] += corner(e, a, d);
  return force;
}

/// Evaluates all forces of the present state, moving nothing.
template <int D>
void evaluate_forces(SceneWorld<D>& world, const Clock& clock) {
  world.simulation.plan().run(Stage::search, Stage::split, clock);
}

}  // namespace breccia
