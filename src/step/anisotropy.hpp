#pragma once
#include "core/schema.hpp"
#include "core/settings.hpp"
#include "point/anisotropic.hpp"

#include <optional>

namespace breccia {

/// Declares [material.NAME.orthotropic], .transversely_isotropic and .stiffness.
void declare_anisotropy(Schema& schema);

/// Elastic constants along material axes, where the material has them; Pa. The axis of transverse
/// isotropy is y in the plane and z in space.
/// \throws Error that names the leading minor that is not positive.
std::optional<Anisotropic> read_anisotropy(const Settings& material, int dimension);

/// The law that keeps sigma_zz at zero.
Anisotropic plane_stress_of(const Anisotropic& law);

/// Largest rho c^2 of plane waves in any direction (in the plane: of directions and motions in it),
/// from more than 500 directions, times 1.01, Pa (ALGORITHMS ).
double fastest_modulus(const Anisotropic& law, int dimension);

/// Shear modulus averaged over all directions (Voigt 1889), Pa.
double mean_shear(const Anisotropic& law);

/// Inverse of the law: strain of a stress along material axes.
Sym<3> strain_of(const Anisotropic& law, const Sym<3>& stress);

}  // namespace breccia
