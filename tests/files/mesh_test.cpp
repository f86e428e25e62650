#include "samples/files/mesh.h"

#include <glm/geometric.hpp>
#include <map>

#include "tests/files/support.h"

namespace boxcar::test {
namespace {

MeshData Read(const std::string& text, const MeshLimits& limits = {}) {
    const TemporaryFolder folder;
    return ReadMesh(folder.Put("m.obj", ToBytes(text)), limits);
}

// The line without the path that it begins with.
std::string ErrorFor(const std::string& text, const MeshLimits& limits = {}) {
    const TemporaryFolder folder;
    const std::string path = folder.Put("m.obj", ToBytes(text));
    const std::string error = ErrorOf([&] { ReadMesh(path, limits); });
    EXPECT_TRUE(error.starts_with(path + ": ")) << error;
    return error.substr(std::min(error.size(), path.size() + 2));
}

const std::string kSquare = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\n";

using Indices = std::vector<uint32_t>;

TEST(MeshFile, HoldsPositionsNormalsAndUvFromTheTop) {
    const MeshData mesh = Read(
        "# a triangle\no named\nusemtl none\n"
        "v 1 2 3\nv +4 -5e0 6. 1\nv .5 8 9 0.1 0.2 0.3\n"
        "vt 0 0\nvt 1 0.25 0\nvt 0.5 1\nvn 0 0 2\ns 1\n"
        "f 1/1/1 2/2/1 3/3/1\n");
    EXPECT_EQ(mesh.vertices, std::vector<Vertex>({{{1, 2, 3}, {0, 0, 1}, {0, 1}},
                                                  {{4, -5, 6}, {0, 0, 1}, {1, 0.75f}},
                                                  {{0.5f, 8, 9}, {0, 0, 1}, {0.5f, 0}}}));
    EXPECT_EQ(mesh.indices, Indices({0, 1, 2}));
}

TEST(MeshFile, FacesBecomeFansAndTheirCornersAreSharedWhereAllThreeAreTheSame) {
    const MeshData square = Read(kSquare + "f 1 2 3 4\nf -4 -3 -2\n");
    EXPECT_EQ(square.indices, Indices({0, 1, 2, 0, 2, 3, 0, 1, 2}));
    EXPECT_EQ(square.vertices.size(), 4u);

    // The seam: one position, two uv.
    const MeshData seam = Read(kSquare + "vt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/2 3/1 4/1\n");
    EXPECT_EQ(seam.indices, Indices({0, 1, 2, 3, 2, 4}));
    EXPECT_EQ(seam.vertices[0].position, seam.vertices[3].position);
    EXPECT_EQ(seam.vertices[3].uv, glm::vec2(1, 0));

    EXPECT_EQ(Read(kSquare + "g a\nf 1 2 3\ng b\nusemtl c\nf 3 4 1\n").indices, Indices({0, 1, 2, 2, 3, 0}));
    EXPECT_EQ(Read("v 0 0 0\r\nv 2 0 0\r\nv 2 1 0\r\nf 1\t2  3 \r\n").indices, Indices({0, 1, 2}));
}

// Each says the same in another way that is allowed.
TEST(MeshFile, WaysToWriteOneMeshAreReadAsIt) {
    const std::string face = "f 1 2 3\nf 1 3 4\n";
    const MeshData expected = Read(kSquare + face);
    const std::string same[] = {
        "\xef\xbb\xbf" + kSquare + face,
        kSquare + "f 1 2 3 # front\nf 1 3 4# back \\\n",
        "# a path \\\n" + kSquare + face,
        "v 0 0 0\nv 2 \\\n0 0\nv 2 1\\\r\n0\n\\\n\\\nv 0 1 0\n" + face,
        kSquare + "f 1 2\\\n\\\n3\nf \\\n1 3 4 \\",
        kSquare + "f 1/ 2/ 3/\nf 1// 3// 4//\n",
        kSquare + "f 1/1 2/2 3/3\nf 1/7 3/8 4/9\n",
        kSquare + "f 1//1 2//2 3//3\nf 1/-1/-1 3/1/1 4//9\n",
        kSquare + "f -4 -3 -2\nf -4 -2 -1\n",
        "v 0 0 0 1 0 0\nv 2 0 0 1\nv 2 1 0 0.5 0.5 0.5 1\nv 0 1 0 # red\n" + face,
    };
    for (const std::string& text : same) {
        const MeshData mesh = Read(text);
        EXPECT_EQ(mesh.vertices, expected.vertices) << text;
        EXPECT_EQ(mesh.indices, expected.indices) << text;
    }
    // Slashes with nothing behind them, in a file that has normals and uv.
    const MeshData mixed = Read(kSquare + "vt 0.5\nvn 0 0 -1\nf 1/1/ 2//1 3/ 4/1/1\n");
    EXPECT_EQ(mixed.vertices, std::vector<Vertex>({{{0, 0, 0}, {0, 0, 1}, {0.5f, 1}},
                                                   {{2, 0, 0}, {0, 0, -1}, {0, 0}},
                                                   {{2, 1, 0}, {0, 0, 1}, {0, 0}},
                                                   {{0, 1, 0}, {0, 0, -1}, {0.5f, 1}}}));
    // Lines are counted as an editor counts them.
    EXPECT_EQ(ErrorFor("v 0 \\\n0 0\nv 1 \\\nx 0\n"), "line 3 is a position without 3 finite numbers");
}

// A corner of three faces with areas 1/2 * (1, 2, 4) along x, y and z.
TEST(MeshFile, NormalsThatItDoesNotHaveAreTheFacesWeightedByArea) {
    const std::string corner = "v 0 0 0\nv 1 0 0\nv 0 4 0\nv 0 0 2\n";  // cross products: x: 8, y: 2, z: 4
    const MeshData mesh = Read(corner + "f 1 3 4\nf 1 4 2\nf 1 2 3\n");
    const glm::vec3 expected = glm::normalize(glm::vec3(8, 2, 4));
    for (int c = 0; c < 3; c++)
        EXPECT_NEAR(mesh.vertices[0].normal[c], expected[c], 1e-7);

    // A normal of length 0 is none; a position whose faces have no area has one that at least is of length 1.
    EXPECT_EQ(Read(corner + "vn 0 0 0\nf 1//1 2//1 3//1\n").vertices[0].normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(Read(corner + "f 1 1 2\n").vertices[0].normal, glm::vec3(0, 1, 0));
    // Cross products beyond what a float holds.
    EXPECT_EQ(Read("v 0 0 0\nv 3e38 0 0\nv 0 3e38 0\nf 1 2 3\n").vertices[0].normal, glm::vec3(0, 0, 1));
}

// As many as the files have lines of v and f; neither has uv, normals or faces of four corners.
TEST(MeshFile, SampleMeshesAreReadWhole) {
    struct Sample {
        std::string name;
        size_t positions, triangles;
    };
    for (const Sample& sample : {Sample{"bunny.obj", 1839, 3674}, Sample{"teapot.obj", 792, 992}}) {
        const MeshData mesh = ReadMesh(SAMPLES_FOLDER + sample.name);
        EXPECT_EQ(mesh.vertices.size(), sample.positions) << sample.name;
        EXPECT_EQ(mesh.indices.size(), 3 * sample.triangles) << sample.name;
        for (const Vertex& vertex : mesh.vertices)
            EXPECT_NEAR(glm::length(vertex.normal), 1, 1e-6);
    }
}

TEST(MeshFile, WhatIsNoMeshIsRefused) {
    EXPECT_EQ(ErrorFor(""), "the file is empty; an OBJ mesh is expected");
    EXPECT_EQ(ErrorFor("# nothing\n"), "it has no face; an OBJ mesh is expected");
    EXPECT_EQ(ErrorFor(kSquare), "it has no face; an OBJ mesh is expected");
    EXPECT_EQ(ErrorFor(std::string("\x89PNG\r\n\x1a\n\0\0\0\r", 12)), "no text; an OBJ mesh is expected");
    EXPECT_EQ(ErrorFor("# Macintosh\nv 1 2 3\rv 4 5 6\r"),
              "line 2 has a zero byte or a lone carriage return; OBJ is text");
    EXPECT_EQ(ErrorOf([] { ReadMesh("/dev/zero"); }), "/dev/zero: no text; an OBJ mesh is expected");
    const TemporaryFolder folder;
    EXPECT_EQ(ErrorOf([&] { ReadMesh(folder.Path("none.obj")); }),
              folder.Path("none.obj") + ": cannot be read: No such file or directory");
}

TEST(MeshFile, NumbersThatAreNoneOrNotFiniteAreRefused) {
    for (const std::string numbers : {"nan 0 0", "0 -inf 0", "0 0 1e39", "0 0 1e999", "0 0", "", "1,5 2 3",
                                      "0 0 0x10", "0 0 +-5", "0 0 1e", "0 0 -", "0 0 1 # 2"}) {
        const bool isThree = numbers == "0 0 1 # 2";  // what follows them is nobody's
        EXPECT_EQ(ErrorFor("\nv " + numbers + "\n"), isThree ? "it has no face; an OBJ mesh is expected"
                                                             : "line 2 is a position without 3 finite numbers");
    }
    EXPECT_EQ(ErrorFor("vn 1 2\n"), "line 1 is a normal without 3 finite numbers");
    for (const std::string numbers : {"", "x", "1 x", "1 nan"})
        EXPECT_EQ(ErrorFor("vt " + numbers + "\n"), "line 1 is a uv without 1 or 2 finite numbers");
    EXPECT_EQ(ErrorFor("v 0 0 0." + std::string(600, '0') + "1e600\n" + kSquare + "f 1 2 3\n"),
              "one of its numbers has too many digits");
    // A number too small for a float is 0.
    EXPECT_EQ(Read("v 1e-60 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").vertices[0].position, glm::vec3(0));
}

TEST(MeshFile, FacesThatAreNoneAreRefused) {
    const auto errorOf = [](const std::string& face) { return ErrorFor(kSquare + face + "\n"); };
    EXPECT_EQ(errorOf("f 1 2"), "line 5 is a face of 2 corners; 3 to 255 are expected");
    EXPECT_EQ(errorOf("f"), "line 5 is a face of 0 corners; 3 to 255 are expected");
    for (const std::string corner : {"x", "1.5", "/1", "//1", "1///1", "1/1/1/1", "1/1/1/", "1/x", "1//x", "1\\ "})
        EXPECT_TRUE(errorOf("vt 0 0\nvn 0 0 1\nf 1 2 " + corner)
                        .ends_with("has a corner that is none of v, v/vt, v//vn, v/vt/vn"))
            << corner;
    for (const std::string index : {"0", "5", "-5", "2147483648", "4294967297", "99999999999999999999"})
        EXPECT_EQ(errorOf("f 1 2 " + index), "line 5: index " + index + "; there are 4 positions so far");
    EXPECT_EQ(errorOf("f 1 2 # 3"), "line 5 is a face of 2 corners; 3 to 255 are expected");
    EXPECT_EQ(errorOf("f 1 2 \\\nv 1 2 3"), "line 5 has a corner that is none of v, v/vt, v//vn, v/vt/vn");
    EXPECT_EQ(errorOf("f 1/0 2/1 3/1"), "line 5: index 0; there are 0 uv so far");
    // Where some come behind the face the file is not one that has none.
    EXPECT_EQ(errorOf("f 1/1 2/1 3/1\nf 1 2 3\nvt 0 0"), "line 5: index 1; there are 0 uv so far");
    EXPECT_EQ(errorOf("f 1//-1 2 3\nf 1 2 3\nvn 0 0 1"), "line 5: index -1; there are 0 normals so far");
    EXPECT_EQ(errorOf("vn 0 0 1\nf 1//1 2//2 3//1"), "line 6: index 2; there are 1 normals so far");
}

TEST(MeshFile, HugeFacesAreRefusedAndLargeOnesRead) {
    const auto face = [](int corners) {
        std::string line = "f";
        for (int i = 0; i < corners; i++)
            line += fmt::format(" {}", i % 4 + 1);
        return line + "\n";
    };
    EXPECT_EQ(Read(kSquare + face(255)).indices.size(), 3 * 253u);
    EXPECT_EQ(ErrorFor(kSquare + face(256)), "line 5 is a face of more than 255 corners, the most that are read");
    EXPECT_EQ(ErrorFor(kSquare + face(10'000'000)),
              "line 5 is a face of more than 255 corners, the most that are read");
}

TEST(MeshFile, LimitsAreKept) {
    EXPECT_EQ(ErrorFor(kSquare + "f 1 2 3\n", {.maxVertices = 3}),
              "line 4 is a position more than the 3 that are read");
    EXPECT_EQ(ErrorFor(kSquare + "f 1 2 3\nf 1 2 3 4\n", {.maxTriangles = 2}),
              "line 6 leads to more than 2 triangles, the most that are read");
    EXPECT_EQ(ErrorFor(kSquare + "vt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/2 2/2 3/2\n", {.maxVertices = 4}),
              "it makes more than 4 vertices, the most that are read");
    EXPECT_EQ(Read(kSquare + "f 1 2 3 4\n", {.maxVertices = 4, .maxTriangles = 2}).indices.size(), 6u);
    EXPECT_TRUE(ErrorFor(std::string(3 << 20, '#'), {.maxBytes = 2 << 20}).starts_with("longer than 2 MiB"));
}

// tinyobjloader would take memory for tags as the file says, and fail at lines and points that it cannot read.
TEST(MeshFile, LinesOfOtherKindsArePassedOver) {
    EXPECT_EQ(Read("t crease 2000000000/2000000000/2000000000 1\nvw 0 -1 -1\nl 0\np x\nmtllib /dev/zero\nfoo\n" +
                   kSquare + "f 1 2 3\n")
                  .vertices.size(),
              3u);
}

// Cut anywhere and with any byte changed, a file is a mesh or an Error.
TEST(MeshFile, DamagedFilesAreMeshesOrErrors) {
    const TemporaryFolder folder;
    const std::string whole =
        kSquare + "vt 0 0\nvt 1\nvn 0 0 1\nf 1/1/1 2/2/1 -2/-1/-1\nf 1//1 3//1 4//1 # c\nf 1/ 2 \\\n3 4\n";
    int meshes = 0, errors = 0;
    const auto tryText = [&](const std::string& text) {
        const std::string path = folder.Put("m.obj", ToBytes(text));
        try {
            const MeshData mesh = ReadMesh(path);
            meshes++;
            for (const uint32_t index : mesh.indices)
                ASSERT_LT(index, mesh.vertices.size());
            for (const Vertex& vertex : mesh.vertices)
                ASSERT_NEAR(glm::length(vertex.normal), 1, 1e-5) << text;
        } catch (const Error& error) {
            errors++;
            ASSERT_TRUE(std::string(error.what()).starts_with(path + ": ")) << error.what();
        }
    };
    for (size_t length = 0; length < whole.size(); length++)
        tryText(whole.substr(0, length));
    for (size_t at = 0; at < whole.size(); at++)
        for (const char byte : {'\0', '\n', '\r', ' ', '/', '-', '0', '9', '.', 'e', 'f', '#', '\\', '\xff'}) {
            std::string text = whole;
            text[at] = byte;
            tryText(text);
        }
    EXPECT_GT(meshes, 100);
    EXPECT_GT(errors, 100);
}

}  // namespace
}  // namespace boxcar::test
