#pragma once
#include <string>
#include <string_view>

namespace breccia {

/// Exponents of metre, kilogram, second, kelvin and radian. The radian is kept apart so that an
/// angle is never taken for a pure number in a scene.
struct Dimension {
  int m = 0, kg = 0, s = 0, K = 0, rad = 0;

  friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
  friend constexpr Dimension operator*(Dimension a, Dimension b) {
    return {a.m + b.m, a.kg + b.kg, a.s + b.s, a.K + b.K, a.rad + b.rad};
  }
  friend constexpr Dimension operator/(Dimension a, Dimension b) {
    return {a.m - b.m, a.kg - b.kg, a.s - b.s, a.K - b.K, a.rad - b.rad};
  }
};

/// Dimensions that scenes use.
namespace unit {
inline constexpr Dimension none{};
inline constexpr Dimension length{1, 0, 0, 0, 0};
inline constexpr Dimension area{2, 0, 0, 0, 0};
inline constexpr Dimension volume{3, 0, 0, 0, 0};
inline constexpr Dimension mass{0, 1, 0, 0, 0};
inline constexpr Dimension time{0, 0, 1, 0, 0};
inline constexpr Dimension frequency{0, 0, -1, 0, 0};
inline constexpr Dimension temperature{0, 0, 0, 1, 0};
inline constexpr Dimension angle{0, 0, 0, 0, 1};
inline constexpr Dimension velocity{1, 0, -1, 0, 0};
inline constexpr Dimension acceleration{1, 0, -2, 0, 0};
inline constexpr Dimension angular_velocity{0, 0, -1, 0, 1};
inline constexpr Dimension density{-3, 1, 0, 0, 0};
inline constexpr Dimension force{1, 1, -2, 0, 0};
inline constexpr Dimension energy{2, 1, -2, 0, 0};
inline constexpr Dimension power{2, 1, -3, 0, 0};
inline constexpr Dimension specific_energy{2, 0, -2, 0, 0};  ///< J/kg
inline constexpr Dimension heat_capacity{2, 0, -2, -1, 0};   ///< J/(kg.K)
inline constexpr Dimension pressure{-1, 1, -2, 0, 0};
inline constexpr Dimension surface_energy{0, 1, -2, 0, 0};        ///< J/m2 = N/m
inline constexpr Dimension interface_stiffness{-2, 1, -2, 0, 0};  ///< Pa/m
inline constexpr Dimension viscosity{-1, 1, -1, 0, 0};            ///< Pa.s
inline constexpr Dimension interface_viscosity{-2, 1, -1, 0, 0};  ///< Pa.s/m
}  // namespace unit

/// A number with its unit, converted to SI (m, kg, s, K, rad).
struct Quantity {
  double value = 0;
  Dimension dimension;
  bool has_unit = false;  ///< false for "60": a pure number
};

/// Reads "60 GPa", "2650 kg/m3", "9.81 m/s^2", "10 %", "3 N.m", "1 J/(kg.K)".
/// \throws Error with an empty place when the number, the unit or its value makes no sense.
Quantity parse_quantity(std::string_view text);

/// One unit without a number, such as "MPa/m": value is its size in SI. \throws Error as above.
Quantity parse_unit(std::string_view text);

/// Whether parse_unit would accept the text.
bool is_unit(std::string_view text);

/// "Pa", "kg/m3", "rad/s"; "1" for a pure number.
std::string si_unit(Dimension dimension);

/// "pressure", "pure number"; for a dimension without a name its SI unit.
std::string dimension_name(Dimension dimension);

/// `pressure, e.g. "60 GPa"`.
std::string friendly(Dimension dimension);

/// "a pressure", "an angle".
std::string with_article(const std::string& noun);

}  // namespace breccia
