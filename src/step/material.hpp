#pragma once
#include "core/settings.hpp"
#include "point/anisotropic.hpp"
#include "point/eos.hpp"
#include "point/plastic_laws.hpp"

#include <optional>
#include <string>
#include <vector>

namespace breccia {

/// Shock viscosity: q = rho l (quadratic l tr(d)^2 + linear c |tr(d)|) where tr(d) < 0.
struct BulkViscosity {
  double quadratic = 0, linear = 0;
  bool on() const { return quadratic > 0 || linear > 0; }
};

/// One material as the scene gives it; SI.
struct Material {
  std::string name;
  double density = 0;  ///< kg/m3
  double young = 0;    ///< Pa
  double poisson = 0;
  double damping = 0;  ///< fraction of critical at the highest mode of each element (A-1.6)
  /// Elasticity along material axes; then `young` and `poisson` are those of an isotropic material
  /// with the same mean shear modulus and fastest wave.
  std::optional<Anisotropic> stiffness;
  PlasticLaw plastic;  ///< NoYield where the scene gives none
  std::optional<Eos> eos;
  BulkViscosity viscosity;
  /// Of rigid bodies: exerts no forces; `young` and `poisson` are what contact looks at.
  bool rigid = false;

  double lambda() const { return young * poisson / ((1 + poisson) * (1 - 2 * poisson)); }
  double mu() const { return young / (2 * (1 + poisson)); }
  double bulk() const { return young / (3 * (1 - 2 * poisson)); }
  bool yields() const { return !std::holds_alternative<NoYield>(plastic); }
  /// lambda of plane stress, which keeps sigma_33 at zero.
  double lambda_plane_stress() const { return 2 * lambda() * mu() / (lambda() + 2 * mu()); }
  /// Modulus of compression without lateral strain; in plane stress the in-plane one.
  double p_wave_modulus(bool plane_stress) const {
    return (plane_stress ? lambda_plane_stress() : lambda()) + 2 * mu();
  }
};

/// The material of a rigid body made of `material`: its mass and its surface, nothing that deforms.
Material rigid_material(const Material& material);

/// The [material.*] sections in scene order.
std::vector<Material> read_materials(const Settings& scene);

}  // namespace breccia
