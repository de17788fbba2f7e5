#pragma once
#include "point/inelastic.hpp"
#include "point/plastic_drucker_prager.hpp"
#include "point/plastic_holmquist.hpp"
#include "point/plastic_j2.hpp"
#include "point/plastic_johnson_cook.hpp"
#include "point/plastic_mohr_coulomb.hpp"
#include "point/plastic_rate.hpp"

#include <variant>

namespace breccia {

/// The list of inelastic laws. A new law is one line here; loops and pictures follow this list.
using PlasticLaw = std::variant<   //
    NoYield,                       //
    J2,                            //
    JohnsonCook,                   //
    DruckerPrager,                 //
    RateDependent<DruckerPrager>,  //
    MohrCoulomb,                   //
    RateDependent<MohrCoulomb>,    //
    Holmquist>;

}  // namespace breccia
