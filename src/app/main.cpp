#include "app/command_line.hpp"

int main(int argc, char** argv) {
  const breccia::World world(&argc, &argv);
  return breccia::run_command_line(argc, argv, world);
}
