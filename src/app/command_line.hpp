#pragma once
#include "core/world.hpp"

namespace breccia {

/// Reads the command line, runs the verb it names and turns whatever happens into an exit status:
/// 0 done, 1 stopped before its time, 2 a mistake of the user, 3 a check of the scene failed.
int run_command_line(int argc, char** argv, const World& world);

}  // namespace breccia
