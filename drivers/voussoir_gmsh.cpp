// voussoir-gmsh: what only gmsh can do, for programs of this project that ask for it. Nobody else starts it.
#include "base/child_process.hpp"
#include "gmsh/gmsh_works.hpp"
#include "mesh/gmsh_program.hpp"

int main(int argc, char** argv) {
  using namespace voussoir;
  return serve_works(argc, argv,
                     {{gmsh_work::look_at_drawing, gmsh_work::looked_at},
                      {gmsh_work::mesh_drawing, gmsh_work::drawing_meshed},
                      {gmsh_work::mesh_volumes, gmsh_work::volumes_meshed},
                      {gmsh_work::outline_volumes, gmsh_work::volumes_outlined},
                      {gmsh_work::triangulate_step, gmsh_work::step_triangulated},
                      {gmsh_work::mesh_polygons, gmsh_work::polygons_meshed},
                      {gmsh_work::fill_surfaces, gmsh_work::surfaces_filled}});
}
