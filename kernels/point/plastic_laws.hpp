#pragma once
#include "point/inelastic.hpp"
#include "point/plastic_j2.hpp"

#include <variant>

namespace breccia {

/// The list of inelastic laws. A new law is one line here; loops and pictures follow this list.
using PlasticLaw = std::variant<  //
    NoYield,                      //
    J2>;

}  // namespace breccia
