#pragma once
#include "mesh/mesh.hpp"
#include "mesh/topology.hpp"

#include <cstdint>
#include <vector>

namespace breccia {

/// Per element the smallest element of its piece (the elements that hang together through faces),
/// or kNone where the piece, whole as it is, may touch itself. Rigid ones never do (`rigid`: per
/// element), nor do convex and compact ones: they would have to be bent by strains of about a third
/// first.
template <int D>
std::vector<Index> whole_pieces(const Mesh<D>& mesh, const Topology<D>& topology,
                                const std::vector<std::uint8_t>& rigid);

extern template std::vector<Index> whole_pieces<2>(const Mesh<2>&, const Topology<2>&,
                                                   const std::vector<std::uint8_t>&);
extern template std::vector<Index> whole_pieces<3>(const Mesh<3>&, const Topology<3>&,
                                                   const std::vector<std::uint8_t>&);

}  // namespace breccia
