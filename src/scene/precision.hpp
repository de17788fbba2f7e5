#pragma once
#include "step/model.hpp"

#include <string>
#include <vector>

namespace breccia {

/// What of a run in mixed precision is computed in double all the same, a line each; empty: nothing
/// (or the run is in double).
template <int D>
std::vector<std::string> left_in_double(const Model<D>& model);

/// Where the round-off of single precision may be felt in this scene, each with cause and remedy;
/// empty: nowhere that the scene tells (or the run is in double).
template <int D>
std::vector<std::string> precision_doubts(const Model<D>& model);

extern template std::vector<std::string> left_in_double(const Model<2>&);
extern template std::vector<std::string> left_in_double(const Model<3>&);
extern template std::vector<std::string> precision_doubts(const Model<2>&);
extern template std::vector<std::string> precision_doubts(const Model<3>&);

}  // namespace breccia
