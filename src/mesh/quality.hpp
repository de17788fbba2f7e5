#pragma once

#include "mesh/mesh.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace breccia {

/// One element singled out by the report.
template <int D>
struct NotableElement {
  Index element = kNone;
  double value = 0;
  Point<D> centroid{};
};

/// Shape quality is D * inradius / circumradius: 1 for the regular simplex, 0 for a flat one.
template <int D>
struct QualityReport {
  Index elements = 0;    ///< sub-elements of composites count each
  Index composites = 0;  ///< 0: all elements are simple
  Index points = 0;
  double volume = 0;                                 ///< m2 or m3
  double min_size = 0, mean_size = 0, max_size = 0;  ///< edge lengths, m
  NotableElement<D> min_height;                      ///< m
  NotableElement<D> min_angle;  ///< smallest angle between edges (2D) or faces (3D), rad
  NotableElement<D> worst_shape;
  double mean_shape = 0;
  std::array<Index, 10> shape_histogram{};  ///< elements with shape quality in [i/10, (i+1)/10)
  NotableElement<D> time_step;              ///< element with the smallest stable step (s), A-1.9
  std::string time_step_body;
  double mean_time_step = 0;  ///< s
};

/// `wave_speed`: P-wave speed of each body in m/s, as many as bodies; empty: the step is left out.
template <int D>
QualityReport<D> assess_quality(const Mesh<D>& mesh, std::span<const double> wave_speed = {});

/// The report as a table for people.
template <int D>
std::string to_text(const QualityReport<D>& report);

}  // namespace breccia
