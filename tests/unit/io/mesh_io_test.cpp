#include "io/mesh_io.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "io/mesh_formats.hpp"
#include "mesh_shapes.hpp"
#include "quadline/errors.hpp"

namespace quadline {

// Found by GoogleTest's comparisons.
static bool operator==(const EdgeSet& a, const EdgeSet& b) {
  return a.name == b.name && a.kind == b.kind && a.edges == b.edges;
}
static bool operator==(const NodeSet& a, const NodeSet& b) { return a.name == b.name && a.nodes == b.nodes; }

namespace {

void expect_same(const Mesh& a, const Mesh& b) {
  EXPECT_TRUE(a.points == b.points);
  EXPECT_EQ(a.quads, b.quads);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.quad_region, b.quad_region);
  EXPECT_EQ(a.triangle_region, b.triangle_region);
  EXPECT_EQ(a.regions, b.regions);
  EXPECT_TRUE(a.curves == b.curves);
  EXPECT_TRUE(a.node_sets == b.node_sets);
}

/// The same mesh with its elements by region, as .msh and .inp hold it: the groups, not the order.
Mesh by_region(const Mesh& mesh) {
  Mesh out = mesh;
  out.quads.clear();
  out.quad_region.clear();
  for (std::uint32_t r = 0; r < mesh.regions.size(); ++r) {
    for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
      if (mesh.quad_region[i] != r) continue;
      out.quads.push_back(mesh.quads[i]);
      out.quad_region.push_back(r);
    }
  }
  return out;
}

std::string message_of(Mesh (*parse)(std::string_view, const std::string&), const std::string& text) {
  try {
    parse(text, "file");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

const Mesh kMeshes[] = {shapes::plate_with_lines(), shapes::plate_with_lines(3, 4), shapes::ring(), shapes::mixed()};

TEST(MeshJson, ComesBackWhole) {
  for (const Mesh& mesh : kMeshes) expect_same(parse_mesh_json(to_mesh_json(mesh), "file"), mesh);
}

TEST(MeshJson, KeepsNamesOfAnySpelling) {
  Mesh mesh = shapes::mixed();
  mesh.regions = {"deck \"A\" \\ \n plate é 板"};
  mesh.node_sets = {{"", {}}, {"\x01", {5}}};
  expect_same(parse_mesh_json(to_mesh_json(mesh), "file"), mesh);
}

TEST(MeshJson, ErrorsNameThePath) {
  std::string text = to_mesh_json(shapes::mixed());
  text.replace(text.find("[1,2,5]"), 7, "[1,2,6]");
  EXPECT_NE(message_of(parse_mesh_json, text).find("/triangles/0"), std::string::npos);
  EXPECT_NE(message_of(parse_mesh_json, "{\"outer\": []}").find("is a model"), std::string::npos);
  EXPECT_NE(message_of(parse_mesh_json, "{\n\n\"format\" 1}").find("line 3"), std::string::npos);
  EXPECT_EQ(message_of(parse_mesh_json, "{\"format\": 1e999}"), "file: /format: the number 1e999 is too large");
}

TEST(MeshVtu, ComesBackWhole) {
  for (const Mesh& mesh : kMeshes) expect_same(parse_vtu(to_vtu(mesh), "file"), mesh);
}

TEST(MeshVtu, KeepsNamesThatXmlEscapes) {
  Mesh mesh = shapes::plate_with_lines();
  mesh.regions[1] = "a<b & \"c\"/d";
  mesh.curves[1].name = "";
  expect_same(parse_vtu(to_vtu(mesh), "file"), mesh);
}

TEST(MeshVtu, IsSplitIntoBlocksWhereItIsLong) {
  const Mesh mesh = shapes::plate_with_lines(150, 200);  // 300 x 200 quads: 1.9 MB of node numbers
  expect_same(parse_vtu(to_vtu(mesh), "file"), mesh);
}

TEST(MeshMsh, ComesBackWithItsGroups) {
  for (const Mesh& mesh : kMeshes) expect_same(parse_msh(to_msh(mesh), "file"), by_region(mesh));
}

TEST(MeshInp, ComesBackWithItsGroups) {
  for (const Mesh& mesh : kMeshes) {
    Mesh back = parse_inp(to_inp(mesh), "file");
    ASSERT_EQ(back.points.size(), mesh.points.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
      EXPECT_LE(distance(back.points[i], mesh.points[i]), 1e-13 * norm(mesh.points[i]));
    back.points = mesh.points;
    expect_same(back, mesh);
  }
}

TEST(MeshInp, MakesNamesThatSolversTake) {
  Mesh mesh = shapes::plate_with_lines();
  mesh.regions = {"deck plate", "Deck_Plate"};
  mesh.curves[1].name = "7 é";
  mesh.curves[2].name = std::string(100, 'x');
  mesh.node_sets[0].name = "nall";
  const std::string text = to_inp(mesh);
  EXPECT_NE(text.find("ELSET=deck_plate\n"), std::string::npos);
  EXPECT_NE(text.find("ELSET=Deck_Plate_2\n"), std::string::npos);
  EXPECT_NE(text.find("ELSET=S_7__,"), std::string::npos);
  EXPECT_NE(text.find("ELSET=" + std::string(80, 'x') + ','), std::string::npos);
  EXPECT_NE(text.find("NSET=nall_2\n1\n"), std::string::npos);
}

TEST(MeshInp, NumbersFitTheColumnsOfCalculix) {
  Mesh mesh = shapes::mixed();
  mesh.points[5] = {-1.2345678901234567e-5, 1.0 / 3 * 1e-4};
  const std::string text = to_inp(mesh);
  EXPECT_NE(text.find("\n6,-1.2345678901235e-05,3.33333333333333e-05,0\n"), std::string::npos) << text;
  const Mesh back = parse_inp(text, "file");
  EXPECT_NEAR(back.points[5].x, mesh.points[5].x, 1e-18);
}

TEST(MeshInp, OneBeamOnAnEdgeOfTwoLines) {
  const std::string text = to_inp(shapes::plate_with_lines());
  // middle: 2 edges, bent: 1 shared edge and 2 of its own
  EXPECT_NE(text.find("*ELSET, ELSET=LINES, GENERATE\n9,12,1\n"), std::string::npos) << text;
  EXPECT_NE(text.find("*ELSET, ELSET=middle, GENERATE\n9,10,1\n"), std::string::npos) << text;
  EXPECT_NE(text.find("*ELSET, ELSET=bent, GENERATE\n10,12,1\n"), std::string::npos) << text;
}

TEST(MeshInp, ReadsWhatOthersWrite) {
  const Mesh mesh = parse_inp(
      "*Heading\n two quads, and a truss\n*Node, nset=all\n 10, 0., 0., 5.\n 20, 1., 0., 5.\n 30, 2.,,5.\n"
      " 40, 0., 1e0, 5.\n 50, +1., 1., 5.\n 60, 2., 1., 5.\n** comment\n*ELEMENT, type=S4R,\n elset=Deck\n"
      " 1, 10, 20,\n 50, 40\n*element, TYPE=cps3\n7, 20, 30, 60\n8, 20, 60, 50\n*Element, type=T3D2, elset=Bar\n"
      "9, 20, 50\n*nset, nset=Edge, generate\n10, 30, 20\n*NSET, NSET=both\nedge, 60\n*elset, elset=TRI\n7\n8\n"
      "*Shell Section, elset=Deck, material=steel\n 10.\n",
      "file");
  EXPECT_EQ(mesh.points.size(), 6u);
  EXPECT_EQ(mesh.quads, (std::vector<std::array<NodeIndex, 4>>{{0, 1, 4, 3}}));
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<NodeIndex, 3>>{{1, 2, 5}, {1, 5, 4}}));
  EXPECT_EQ(mesh.regions, (std::vector<std::string>{"Deck", "TRI"}));
  EXPECT_EQ(mesh.triangle_region, (std::vector<std::uint32_t>{1, 1}));
  ASSERT_EQ(mesh.curves.size(), 1u);
  EXPECT_TRUE(mesh.curves[0] == (EdgeSet{"Bar", CurveKind::Line, {{1, 4}}}));
  ASSERT_EQ(mesh.node_sets.size(), 2u);
  EXPECT_TRUE(mesh.node_sets[0] == (NodeSet{"Edge", {0, 2}}));
  EXPECT_TRUE(mesh.node_sets[1] == (NodeSet{"both", {0, 2, 5}}));
}

TEST(MeshInp, ErrorsNameTheLine) {
  EXPECT_NE(message_of(parse_inp, "*NODE\n1,0,0\n*INCLUDE, INPUT=x\n").find("line 3"), std::string::npos);
  EXPECT_NE(message_of(parse_inp, "*NODE\n1,0,zero\n").find("line 2"), std::string::npos);
  EXPECT_NE(message_of(parse_inp, "*NODE\n1,0,0\n2,1,0\n*ELEMENT,TYPE=S4\n1,1,2,3,4\n").find("line 5"),
            std::string::npos);
  EXPECT_NE(message_of(parse_inp, "*NODE\n1,0,0\n*ELEMENT,TYPE=C3D8\n").find("C3D8"), std::string::npos);
  EXPECT_NE(message_of(parse_inp, "*,,x\n").find("no keyword"), std::string::npos);
}

TEST(MeshMsh, ReadsVersion2) {
  const Mesh mesh = parse_msh(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 5 \"deck\"\n1 9 \"web\"\n$EndPhysicalNames\n"
      "$Comments\nanything\n$EndComments\n"
      "$Nodes\n5\n7 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n9 2 0.5 0\n$EndNodes\n"
      "$Elements\n4\n1 15 2 3 1 7\n2 1 2 9 1 3 2\n3 3 2 5 1 7 2 3 4\n4 2 2 0 1 2 9 3\n$EndElements\n",
      "file");
  ASSERT_EQ(mesh.points.size(), 5u);
  EXPECT_EQ(mesh.points[3], (Point{0, 0}));  // nodes come by number
  EXPECT_EQ(mesh.quads, (std::vector<std::array<NodeIndex, 4>>{{3, 0, 1, 2}}));
  EXPECT_EQ(mesh.regions, (std::vector<std::string>{"deck", "domain"}));
  EXPECT_EQ(mesh.triangle_region, std::vector<std::uint32_t>{1});
  ASSERT_EQ(mesh.curves.size(), 1u);
  EXPECT_TRUE(mesh.curves[0] == (EdgeSet{"web", CurveKind::Line, {{1, 0}}}));
  ASSERT_EQ(mesh.node_sets.size(), 1u);
  EXPECT_TRUE(mesh.node_sets[0] == (NodeSet{"point-3", {3}}));
}

/// Values as they stand in a binary file.
template <class... Values>
std::string raw(Values... values) {
  std::string out;
  (out.append(reinterpret_cast<const char*>(&values), sizeof values), ...);
  return out;
}

using I = std::int32_t;
using S = std::uint64_t;

std::string binary_msh_4() {
  return "$MeshFormat\n4.1 1 8\n" + raw(I{1}) +
         "\n$EndMeshFormat\n$PhysicalNames\n1\n2 4 \"deck\"\n$EndPhysicalNames\n" + "$Entities\n" +
         raw(S{0}, S{0}, S{1}, S{0}) + raw(I{1}, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, S{1}, I{4}, S{0}) +
         "\n$EndEntities\n$Nodes\n" + raw(S{1}, S{4}, S{1}, S{4}) +
         raw(I{2}, I{1}, I{0}, S{4}, S{1}, S{2}, S{3}, S{4}) +
         raw(0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0) + "\n$EndNodes\n$Elements\n" +
         raw(S{1}, S{1}, S{1}, S{1}) + raw(I{2}, I{1}, I{3}, S{1}, S{1}, S{1}, S{2}, S{3}, S{4}) + "\n$EndElements\n";
}

std::string binary_msh_2() {
  return "$MeshFormat\n2.2 1 8\n" + raw(I{1}) + "\n$EndMeshFormat\n$Nodes\n4\n" + raw(I{1}, 0.0, 0.0, 0.0) +
         raw(I{2}, 1.0, 0.0, 0.0) + raw(I{3}, 1.0, 1.0, 0.0) + raw(I{4}, 0.0, 1.0, 0.0) +
         "\n$EndNodes\n$Elements\n1\n" + raw(I{3}, I{1}, I{2}, I{1}, I{4}, I{1}, I{1}, I{2}, I{3}, I{4}) +
         "\n$EndElements\n";
}

TEST(MeshMsh, ReadsBinary) {
  for (const std::string& text : {binary_msh_4(), binary_msh_2()}) {
    const Mesh mesh = parse_msh(text, "file");
    ASSERT_EQ(mesh.points.size(), 4u);
    EXPECT_EQ(mesh.points[2], (Point{1, 1}));
    EXPECT_EQ(mesh.quads, (std::vector<std::array<NodeIndex, 4>>{{0, 1, 2, 3}}));
  }
  EXPECT_EQ(parse_msh(binary_msh_4(), "file").regions, std::vector<std::string>{"deck"});
  EXPECT_EQ(parse_msh(binary_msh_2(), "file").regions, std::vector<std::string>{"region-4"});
}

TEST(MeshMsh, ErrorsNameThePlace) {
  EXPECT_NE(message_of(parse_msh, "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 1 1 1\n2 1 0 1\n1\n0 x 0\n")
                .find("line 8"),
            std::string::npos);
  EXPECT_NE(message_of(parse_msh, "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 9 1 9\n2 1 0 999999999999\n")
                .find("more than the file holds"),
            std::string::npos);
  EXPECT_NE(message_of(parse_msh, "$MeshFormat\n4 0 8\n$EndMeshFormat\n").find("version '4'"), std::string::npos);
}

std::string base64(const std::string& bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t j = 0; j < 3; ++j)
      bits = bits << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0);
    for (std::size_t j = 0; j < 4; ++j) out += i + j > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * j) & 63];
  }
  return out;
}

/// One quad as a VTU file with its points encoded as given.
std::string square_vtu(const std::string& attributes, const std::string& points) {
  return "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>"
         "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><Points><DataArray type=\"Float64\" "
         "NumberOfComponents=\"3\" " +
         attributes + ">" + points +
         "</DataArray></Points><Cells><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2 3"
         "</DataArray><DataArray type=\"Int32\" Name=\"offsets\">4</DataArray><DataArray type=\"UInt8\" "
         "Name=\"types\">9</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>";
}

TEST(MeshVtu, ReadsTextAndBase64) {
  const std::string data = raw(0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 2.0, 1.0, 0.0, 0.0, 1.0, 0.0);
  const std::string head = raw(static_cast<std::uint32_t>(data.size()));
  const std::string files[] = {
      square_vtu("format=\"ascii\"", "\n0 0 0  2 0 0\n2 1 0 0 1 0\n"),
      square_vtu("format=\"binary\"", base64(head + data)),
      square_vtu("format=\"binary\"", "\n " + base64(head) + base64(data) + "\n"),  // VTK pads the count by itself
  };
  for (const std::string& file : files) {
    const Mesh mesh = parse_vtu(file, "file");
    ASSERT_EQ(mesh.points.size(), 4u);
    EXPECT_EQ(mesh.points[2], (Point{2, 1}));
    EXPECT_EQ(mesh.quads.size(), 1u);
    EXPECT_EQ(mesh.regions, std::vector<std::string>{"domain"});
  }
}

TEST(MeshVtu, RefusesCountsThatDoNotFitTheArrays) {
  const std::string whole = square_vtu("format=\"ascii\"", "0 0 0 2 0 0 2 1 0 0 1 0");
  const auto with = [&](const std::string& text, const std::string& other) {
    std::string file = whole;
    return file.replace(file.find(text), text.size(), other);
  };
  EXPECT_NE(message_of(parse_vtu, with("NumberOfPoints=\"4\"", "NumberOfPoints=\"5\"")).find("number of its points, 4"),
            std::string::npos);
  for (const char* count : {"2", "-1", "1000000000000000000", "99999999999999999999", "x"})
    EXPECT_NE(message_of(parse_vtu, with("NumberOfCells=\"1\"", std::string("NumberOfCells=\"") + count + '"'))
                  .find("NumberOfCells is"),
              std::string::npos);
}

TEST(MeshVtu, RefusesWhatIsNotFlat) {
  const std::string tilted = square_vtu("format=\"ascii\"", "0 0 0 2 0 0 2 1 1 0 1 1");
  EXPECT_NE(message_of(parse_vtu, tilted).find("z goes from 0 to 1"), std::string::npos);
  EXPECT_EQ(parse_vtu(square_vtu("format=\"ascii\"", "0 0 7 2 0 7 2 1 7 0 1 7"), "file").points.size(), 4u);
}

template <class T>
std::string big_endian(T value) {
  std::string bytes = raw(value);
  return {bytes.rbegin(), bytes.rend()};
}

std::string old_vtk(const std::string& kind, const std::string& points, const std::string& cells,
                    const std::string& types) {
  return "# vtk DataFile Version 3.0\ntitle\n" + kind + "\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 float\n" + points +
         "\nCELLS 2 9\n" + cells + "\nCELL_TYPES 2\n" + types + "\nCELL_DATA 2\nanything\n";
}

TEST(MeshVtk, ReadsTextAndBinaryOldAndNew) {
  std::string points, cells, types = big_endian(I{9}) + big_endian(I{5});
  for (const float x : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0}) points += big_endian(x);
  for (const I i : {4, 0, 1, 2, 3, 3, 1, 4, 2}) cells += big_endian(i);
  const std::string files[] = {
      old_vtk("ASCII", "0 0 0 1 0 0 1 1 0 0 1 0 2 0 0", "4 0 1 2 3\n3 1 4 2", "9\n5"),
      old_vtk("BINARY", points, cells, types),
      "# vtk DataFile Version 5.1\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\nFIELD FieldData 1\nt 1 1 double\n0\n"
      "POINTS 5 double\n0 0 0 1 0 0 1 1 0\n0 1 0 2 0 0\nMETADATA\nINFORMATION 0\n\nCELLS 3 7\n"
      "OFFSETS vtktypeint64\n0 4 7\nCONNECTIVITY vtktypeint64\n0 1 2 3 1 4 2\nCELL_TYPES 2\n9\n5\n",
  };
  for (const std::string& file : files) {
    const Mesh mesh = parse_vtk(file, "file");
    ASSERT_EQ(mesh.points.size(), 5u);
    EXPECT_EQ(mesh.points[4], (Point{2, 0}));
    EXPECT_EQ(mesh.quads, (std::vector<std::array<NodeIndex, 4>>{{0, 1, 2, 3}}));
    EXPECT_EQ(mesh.triangles, (std::vector<std::array<NodeIndex, 3>>{{1, 4, 2}}));
  }
  EXPECT_NE(message_of(parse_vtk, old_vtk("ASCII", "0 0 0 1 0 0 1 1 0 0 1 0 2 0 0", "4 0 1 2 3\n3 1 4 7", "9\n5"))
                .find("node 7"),
            std::string::npos);
}

TEST(ReadMesh, TurnsAMeshThatIsSeenFromBelow) {
  const Mesh mesh = parse_vtu(square_vtu("format=\"ascii\"", "0 0 0 0 1 0 2 1 0 2 0 0"), "file");
  EXPECT_EQ(mesh.quads[0], (std::array<NodeIndex, 4>{0, 3, 2, 1}));
}

/// Every file that is cut or spoilt is refused or read; nothing else happens.
void expect_robust(Mesh (*parse)(std::string_view, const std::string&), const std::string& whole) {
  std::size_t n_refused = 0;
  const auto try_it = [&](const std::string& text) {
    try {
      parse(text, "file");
    } catch (const InputError&) {
      ++n_refused;
    }
  };
  const std::size_t step = whole.size() / 400 + 1;
  for (std::size_t n = 0; n < whole.size(); n += step) try_it(whole.substr(0, n));
  EXPECT_GT(n_refused, whole.size() / step / 2);
  std::uint32_t seed = 1;
  for (int i = 0; i < 2000; ++i) {
    std::string text = whole;
    for (int j = 0; j < 1 + i % 4; ++j) {
      seed = seed * 1664525u + 1013904223u;
      text[(seed >> 8) % text.size()] = static_cast<char>(i % 2 == 0 ? seed >> 3 : '0' + (seed >> 4) % 10);
    }
    try_it(text);
  }
}

TEST(ReadMesh, StandsDamagedFiles) {
  const Mesh mesh = shapes::plate_with_lines();
  expect_robust(parse_mesh_json, to_mesh_json(mesh));
  expect_robust(parse_vtu, to_vtu(mesh));
  expect_robust(parse_msh, to_msh(mesh));
  expect_robust(parse_inp, to_inp(mesh));
  expect_robust(parse_msh, binary_msh_2());
  expect_robust(parse_msh, binary_msh_4());
  expect_robust(parse_vtk, old_vtk("ASCII", "0 0 0 1 0 0 1 1 0 0 1 0 2 0 0", "4 0 1 2 3\n3 1 4 2", "9\n5"));
  expect_robust(parse_vtu, square_vtu("format=\"binary\"", base64(std::string(104, 'x'))));
}

class MeshFiles : public testing::Test {
 protected:
  MeshFiles() { std::filesystem::create_directories(folder_); }
  ~MeshFiles() override { std::filesystem::remove_all(folder_); }
  template <class Work>
  std::string refusal(Work work) const {
    try {
      work();
    } catch (const InputError& error) {
      std::string text = error.what();
      const std::string folder = folder_.string() + "/";
      if (const std::size_t at = text.find(folder); at != std::string::npos) text.erase(at, folder.size());
      return text;
    }
    return "not refused";
  }
  std::string refusal_to_name(const std::string& name) const {
    return refusal([&] { mesh_file(name); });
  }
  std::string refusal_to_read(const std::filesystem::path& file) const {
    return refusal([&] { read_mesh(file); });
  }
  std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) / "quadline-mesh-files";
};

TEST_F(MeshFiles, EveryFormatIsWrittenAndReadBack) {
  const Mesh mesh = shapes::plate_with_lines();
  for (const char* name : {"a.vtu", "a.msh", "a.inp", "a.json", "A.VTU"}) {
    SCOPED_TRACE(name);
    write_mesh(mesh, mesh_file(folder_ / name));
    Mesh back = read_mesh(folder_ / name);
    ASSERT_EQ(back.points.size(), mesh.points.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i)  // .inp has 15 digits
      EXPECT_LE(distance(back.points[i], mesh.points[i]), 1e-13 * norm(mesh.points[i]));
    back.points = mesh.points;
    expect_same(back, std::string(name) == "a.msh" ? by_region(mesh) : mesh);
  }
  write_mesh(mesh, mesh_file(folder_ / "a.svg"));
  EXPECT_GT(std::filesystem::file_size(folder_ / "a.svg"), 1000u);
}

TEST_F(MeshFiles, TheFormatMayBeNamed) {
  EXPECT_EQ(mesh_file("a.INP").format, "inp");
  EXPECT_EQ(mesh_file("msh:/dev/stdout").format, "msh");
  EXPECT_EQ(mesh_file("msh:/dev/stdout").path, "/dev/stdout");
  EXPECT_EQ(mesh_file("msh:a.vtu").format, "msh");
  EXPECT_EQ(mesh_file("./msh:a.vtu").format, "vtu");
  EXPECT_EQ(mesh_file("dxf:a.vtu").path, "dxf:a.vtu");
  EXPECT_EQ(refusal_to_name("dxf:a"),
            "dxf:a: the format '' is unknown: use .vtu, .msh, .inp, .svg or .json, or name the format: vtu:dxf:a");
  EXPECT_EQ(refusal_to_name(""), "the name of a file to write is empty");
}

TEST_F(MeshFiles, WhatIsNoMeshIsRefused) {
  EXPECT_EQ(refusal_to_name("a.step"), "a.step: the format '.step' is unknown: use .vtu, .msh, .inp, .svg or .json");
  EXPECT_EQ(refusal_to_read(folder_ / "missing.vtu"), "missing.vtu: cannot be read: No such file or directory");
  EXPECT_EQ(refusal_to_read(folder_), folder_.string() + ": cannot be read: Is a directory");
  std::ofstream(folder_ / "empty.vtu").flush();
  EXPECT_EQ(refusal_to_read(folder_ / "empty.vtu"), "empty.vtu: the file is empty");
  std::ofstream(folder_ / "text.msh") << "hello";
  EXPECT_EQ(refusal_to_read(folder_ / "text.msh"),
            "text.msh: no mesh that can be read: .vtu, .vtk, .msh (2.2 and 4.1), .inp and .json can");
}

TEST_F(MeshFiles, ArraysThatDoNotFitAreADefect) {
  Mesh mesh = shapes::mixed();
  mesh.quads[0][2] = 6;
  EXPECT_THROW(write_mesh(mesh, mesh_file("a.vtu")), InternalError);
}

}  // namespace
}  // namespace quadline
