// Reads a model, meshes it, writes the mesh, reads it back; the same once more as JSON in memory.
#include <cstdio>

#include "quadline/io/mesh_io.hpp"
#include "quadline/io/read_model.hpp"
#include "quadline/json.hpp"
#include "quadline/quadline.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  quadline::Context context;
  const quadline::Mesh mesh = quadline::generate(quadline::read_model(argv[1]), {}, context).mesh;
  quadline::write_mesh(mesh, quadline::mesh_file(argv[2]));
  const bool is_same = quadline::read_mesh(argv[2]).quads == mesh.quads &&
                       quadline::parse_mesh_json(quadline::to_mesh_json(mesh)).quads == mesh.quads;
  std::printf("%zu quads, read back: %s\n", mesh.quads.size(), is_same ? "the same quads" : "other quads");
  return is_same ? 0 : 1;
}
