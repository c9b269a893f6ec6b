// Each kind of error has its code, which programs read in place of the text.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "io/mesh_formats.hpp"
#include "quadline/generate.hpp"
#include "quadline/io/mesh_io.hpp"
#include "quadline/io/read_criteria.hpp"
#include "quadline/io/read_model.hpp"
#include "quadline/json.hpp"

namespace quadline {
namespace {

template <class Run>
std::string code_of(Run run) {
  try {
    run();
  } catch (const Error& error) {
    return name_of(error.code());
  }
  return "none";
}

TEST(ErrorCodes, TellTheKindOfError) {
  Context context;
  context.is_cancelled = [] { return true; };
  Context quiet;
  Model plate;
  plate.size = 1;
  plate.outer = {{.items = {{{0, 0}}, {{4, 0}}, {{4, 3}}, {{0, 3}}}}};
  EXPECT_EQ(code_of([&] { generate(plate, {.growth = 0.5}, quiet); }), "InvalidOption");
  EXPECT_EQ(code_of([&] { mesh_file(""); }), "InvalidOption");
  EXPECT_EQ(code_of([&] { read_criteria("no-such-criteria"); }), "InvalidOption");
  EXPECT_EQ(code_of([&] { generate({}, {}, quiet); }), "InvalidModel");
  EXPECT_EQ(code_of([&] { parse_msh("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n", "m.msh"); }), "InvalidMesh");
  EXPECT_EQ(code_of([&] { read_model("no/such/model.json"); }), "FileUnreadable");
  EXPECT_EQ(code_of([&] { read_model_json("{", "m.json"); }), "FileSyntax");
  EXPECT_EQ(code_of([&] { parse_mesh_json("[]"); }), "FileSyntax");
  EXPECT_EQ(code_of([&] { parse_vtk("# vtk DataFile", "m.vtk"); }), "FileSyntax");
  EXPECT_EQ(code_of([&] { read_model("model.doc"); }), "UnknownFormat");
  EXPECT_EQ(code_of([&] { mesh_file("mesh.doc"); }), "UnknownFormat");
  EXPECT_EQ(code_of([&] { generate(plate, {.size_at = [](Point) { return 1e-3; }, .max_quads = 1e4}, quiet); }),
            "TooManyQuads");
  EXPECT_EQ(code_of([&] { write_mesh({}, {"no/such/folder/m.json", "json"}); }), "CannotWrite");
  EXPECT_EQ(code_of([&] { generate(plate, {}, context); }), "Cancelled");
  EXPECT_EQ(code_of([&] { write_mesh({}, {"m.doc", "doc"}); }), "Internal");
}

}  // namespace
}  // namespace quadline
