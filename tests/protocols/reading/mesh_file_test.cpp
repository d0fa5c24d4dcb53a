// Meshes of others: what is read, and what is refused at once.
#include "protocols/reading/mesh_file.h"

#include <sys/stat.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <numbers>

#include <gtest/gtest.h>

#include "questionnaires/json/problem.h"
#include "tests/support/complaint.h"
#include "tests/support/scratch_folder.h"

namespace protocols {
namespace mesh_file_test {

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 "
    "1 2\n";
const std::string kStl =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid s\n";

std::string binaryStl() {
  std::string text = "solid, says its head, and is binary";
  text.resize(80, ' ');
  const std::uint32_t count = 1;
  text.append(reinterpret_cast<const char*>(&count), sizeof count);
  const float numbers[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  text.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
  return text + std::string(2, '\0');
}

std::string polygon(int corners, const std::string& more = "") {
  std::string text = more;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
  }
  text += "f";
  for (int i = 1; i <= corners; ++i) text += " " + std::to_string(i);
  return text + "\n";
}

std::string complaintAbout(const std::string& text) {
  return tests::complaintOf([&] { readMesh(text); });
}

std::size_t trianglesIn(const std::string& text) {
  std::size_t count = 0;
  for (const auto& surface : readMesh(text)) count += surface.triangles.size();
  return count;
}

TEST(MeshFile, ReadsStlObjAndPly) {
  for (const auto& text : {kObj, kPly, kStl, binaryStl()}) {
    EXPECT_EQ(trianglesIn(text), 1U) << text.substr(0, 30);
  }
}

TEST(MeshFile, RefusesOtherFormatsWhateverTheirName) {
  const tests::ScratchFolder folder;
  const std::string collada =
      "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
      "version=\"1.4.1\"></COLLADA>";
  const std::string gltf =
      "{\"asset\": {\"version\": \"2.0\"}, \"buffers\": [{\"uri\": \"x.bin\"}]}";
  const std::string blender = "BLENDER-v279" + std::string(200, '\0');
  const std::string ifc = "ISO-10303-21;\nHEADER;\n";
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const auto& text : {collada, gltf, blender, ifc, off, std::string()}) {
    EXPECT_NE(complaintAbout(text).find("no STL, OBJ or PLY"), std::string::npos) << text;
  }
  const std::string path = folder / "bone.obj";
  std::ofstream(path) << collada;
  EXPECT_THROW(readMeshFile(path), base::UserError);
}

TEST(MeshFile, OpensNoFileThatItNames) {
  const tests::ScratchFolder folder;
  const std::string fifo = folder / "pipe.mtl";
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  const std::string path = folder / "bone.obj";
  std::ofstream(path) << "mtllib pipe.mtl\nmtllib " << fifo << "\n" << kObj;
  EXPECT_EQ(readMeshFile(path).size(), 1U);  // whoever opens the pipe waits for ever
}

TEST(MeshFile, IsAnOrdinaryFile) {
  const tests::ScratchFolder folder;
  const std::string fifo = folder / "bone.stl";
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  EXPECT_THROW(readMeshFile(fifo), base::UserError);
  EXPECT_THROW(readMeshFile("/dev/zero"), base::UserError);
  EXPECT_THROW(readMeshFile(folder / "missing.stl"), base::UserError);
}

TEST(MeshFile, CutsFacesOfAFewCornersAndRefusesThoseOfThousands) {
  EXPECT_EQ(trianglesIn(polygon(300)), 298U);
  EXPECT_NE(complaintAbout(polygon(20'000)).find("20000"), std::string::npos);
}

TEST(MeshFile, HasNoFaceWithoutCorners) {
  // Found by the fuzzer: the library ends the program.
  auto text = kPly;
  text.replace(text.find("3 0 1 2"), 7, "0");
  EXPECT_NE(complaintAbout(text).find("a face without corners"), std::string::npos);
}

TEST(MeshFile, AllocatesNoMoreThanFitsIntoIt) {
  const auto with = [](std::string part, const std::string& other) {
    auto text = kPly;
    return text.replace(text.find(part), part.size(), other);
  };
  for (const auto* element : {"vertex 3", "face 1"}) {
    const auto many = std::string(element, std::string(element).size() - 1) + "4000000000";
    EXPECT_NE(
        complaintAbout(with(element, many)).find("more corners and faces"), std::string::npos);
  }
  EXPECT_NE(complaintAbout(with("list uchar", "list uint")).find("'list uint'"), std::string::npos);
  EXPECT_EQ(trianglesIn(with("list uchar", "list uint8")), 1U);
}

TEST(MeshFile, HasAHeadThatCanBeReadInOneWayOnly) {
  // Found by the fuzzer: the library reads on for ever in a head that does not end.
  for (const auto size : {kPly.find("end_header"), kPly.find("element"), kPly.find("format")}) {
    EXPECT_NE(complaintAbout(kPly.substr(0, size)).find("its head does not end"), std::string::npos)
        << size;
  }
  const std::string many = " vertex 4000000000\n";
  const auto with = [](const std::string& line) {
    auto text = kPly;
    return text.insert(text.find("element"), line);
  };
  ASSERT_EQ(trianglesIn(with("comment an element of ours\n")), 1U) << "control";
  for (const auto& line :
       {"elemen\x1b\x1bt" + many,
        "comment \f element" + many,
        "Element" + many,
        std::string("element other -4000000000\n"),
        std::string("element other\n 3\n")}) {
    EXPECT_NE(complaintAbout(with(line)).find("its head"), std::string::npos) << line;
  }
  for (const auto* before : {"comment \r", "comment end_header\n", "  ", "\t"}) {
    EXPECT_NE(complaintAbout(with(before + ("element" + many))).find("more"), std::string::npos);
  }
}

}  // namespace mesh_file_test
}  // namespace protocols
