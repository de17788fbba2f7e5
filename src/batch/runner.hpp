#pragma once

#include "batch/state.hpp"

#include <functional>

namespace breccia {

/// Is shown every variant when it is complete; what it throws ends the batch.
using VariantInspector = std::function<void(std::size_t variant)>;

/// Runs these variants, each in a process and a folder of its own; one that fails is run again
/// until it has had so many attempts. States are kept on disk at every change.
void run_variants(const Sweep& sweep, const std::vector<std::size_t>& numbers, int attempts,
                  std::vector<VariantState>& states, const VariantInspector& inspect);

/// The command of one variant. Several ranks are started by srun in a Slurm job, else by mpirun.
std::vector<std::string> run_command(const Sweep& sweep, std::size_t variant, bool restart,
                                     bool in_slurm);

}  // namespace breccia
