#include "mesh/refusal.hpp"

#include "core/error.hpp"

#include <cstdio>

namespace breccia {

void refuse(const std::string& place, const std::string& cause, const std::string& remedy) {
  throw Error(place, cause, remedy);
}

std::string list_ids(std::span<const Index> ids) {
  constexpr std::size_t shown = 5;
  std::string text;
  for (std::size_t i = 0; i < ids.size() && i < shown; ++i) {
    if (i > 0) text += i + 1 == ids.size() ? " and " : ", ";
    text += std::to_string(ids[i]);
  }
  if (ids.size() > shown) text += " and " + std::to_string(ids.size() - shown) + " more";
  return text;
}

std::string name_ids(const std::string& entity, std::span<const Index> ids) {
  return entity + (ids.size() == 1 ? " " : "s ") + list_ids(ids);
}

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

template <std::size_t D>
std::string place_text(const std::array<double, D>& x) {
  std::string text = "(";
  for (std::size_t k = 0; k < D; ++k) text += (k > 0 ? ", " : "") + short_number(x[k]);
  return text + ") m";
}

template std::string place_text<2>(const std::array<double, 2>&);
template std::string place_text<3>(const std::array<double, 3>&);

}  // namespace breccia
