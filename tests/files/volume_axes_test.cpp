// Which way the volumes of NIfTI files lie: a body in the world, scanned along any axes, is the same body.
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <random>

#include "samples/files/volume.h"
#include "tests/files/nifti_file.h"

namespace boxcar::test {
namespace {

constexpr glm::dvec3 kSides{0.5, 2, 1.25};  // of the world's voxels
constexpr glm::ivec3 kExtent{4, 3, 5};

int16_t Value(glm::ivec3 world) {
    return static_cast<int16_t>(1 + world.x + 10 * world.y + 100 * world.z);
}

// The file's axis i runs along the world's axis `along[i]`, against it where `isReversed[i]`.
struct Storage {
    glm::ivec3 along{0, 1, 2};
    glm::ivec3 isReversed{0};

    glm::ivec3 World(glm::ivec3 stored) const {
        glm::ivec3 world;
        for (int i = 0; i < 3; i++)
            world[along[i]] = isReversed[i] ? kExtent[along[i]] - 1 - stored[i] : stored[i];
        return world;
    }
    // Directions of the file's axes in the world.
    glm::dmat3 Directions() const {
        glm::dmat3 directions(0);
        for (int i = 0; i < 3; i++)
            directions[i][along[i]] = isReversed[i] ? -1 : 1;
        return directions;
    }
};

std::vector<Storage> AllStorages() {
    std::vector<Storage> all;
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
            for (int signs = 0; signs < 8 && a != b; signs++)
                all.push_back({{a, b, 3 - a - b}, {signs & 1, signs >> 1 & 1, signs >> 2 & 1}});
    return all;
}

// Of a world that is turned by `turn`.
struct Scan {
    Storage storage = {};
    glm::dmat3 turn{1};
    bool isNifti2 = false;

    glm::dvec3 StoredSides() const {
        return {kSides[storage.along[0]], kSides[storage.along[1]], kSides[storage.along[2]]};
    }
    // From the file's voxels to the world.
    glm::dmat3 Steps() const {
        glm::dmat3 steps = turn * storage.Directions();
        for (int i = 0; i < 3; i++)
            steps[i] *= StoredSides()[i];
        return steps;
    }
};

// Without an orientation: the voxel sizes and the voxels.
BinaryFile FileOf(const Scan& scan) {
    const glm::ivec3 along = scan.storage.along;
    const glm::ivec3 extent(kExtent[along[0]], kExtent[along[1]], kExtent[along[2]]);
    std::vector<int16_t> voxels;
    for (int z = 0; z < extent.z; z++)
        for (int y = 0; y < extent.y; y++)
            for (int x = 0; x < extent.x; x++)
                voxels.push_back(Value(scan.storage.World({x, y, z})));
    BinaryFile file = scan.isNifti2
                          ? BinaryFile(Nifti2File({extent.x, extent.y, extent.z}, kInt16, 16))
                          : BinaryFile(NiftiFile({static_cast<int16_t>(extent.x), static_cast<int16_t>(extent.y),
                                                  static_cast<int16_t>(extent.z)},
                                                 kInt16, 16));
    for (int i = 0; i < 3; i++)
        if (scan.isNifti2)
            file.Set(112 + 8 * i, scan.StoredSides()[i]);
        else
            file.Set(80 + 4 * i, static_cast<float>(scan.StoredSides()[i]));
    return file.Voxels(voxels);
}

BinaryFile WithSform(BinaryFile file, const glm::dmat3& steps, bool isNifti2 = false) {
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 4; column++) {
            const double value = column < 3 ? steps[column][row] : 17 * row;
            if (isNifti2)
                file.Set(400 + 32 * row + 8 * column, value);
            else
                file.Set(280 + 16 * row + 4 * column, static_cast<float>(value));
        }
    return isNifti2 ? file.Set<int32_t>(348, 1) : file.Set<int16_t>(254, 1);
}

// The quaternion a + b i + c j + d k of the directions, the third of them turned round where they are left-handed.
BinaryFile WithQform(BinaryFile file, glm::dmat3 directions, bool isNifti2 = false) {
    const double hand = glm::determinant(directions) < 0 ? -1 : 1;
    directions[2] *= hand;
    glm::dquat q = glm::quat_cast(directions);
    if (q.w < 0) q = -q;
    const double fields[] = {q.x, q.y, q.z};
    for (int i = 0; i < 3; i++)
        if (isNifti2)
            file.Set(352 + 8 * i, fields[i]);
        else
            file.Set(256 + 4 * i, static_cast<float>(fields[i]));
    return isNifti2 ? file.Set(104, hand).Set<int32_t>(344, 1)
                    : file.Set(76, static_cast<float>(hand)).Set<int16_t>(252, 1);
}

Volume Read(const BinaryFile& file) {
    return DecodeVolume(file.m_bytes, "v");
}

void ExpectUpright(const Volume& volume) {
    EXPECT_EQ(glm::ivec3(volume.widthVoxels, volume.heightVoxels, volume.depthVoxels), kExtent);
    EXPECT_EQ(volume.voxelMillimetres, glm::vec3(kSides));
    EXPECT_EQ(volume.worldFromAxes, glm::mat3(1));
    EXPECT_FALSE(volume.hasShear);
    for (int z = 0, i = 0; z < kExtent.z; z++)
        for (int y = 0; y < kExtent.y; y++)
            for (int x = 0; x < kExtent.x; x++, i++)
                ASSERT_EQ(volume.voxels[static_cast<size_t>(i)], Value({x, y, z})) << x << " " << y << " " << z;
}

TEST(VolumeAxes, EachOf48WaysToStoreABodyIsReadAsTheSameVoxels) {
    const std::vector<Storage> all = AllStorages();
    EXPECT_EQ(all.size(), 48u);
    for (const Storage& storage : all)
        for (const bool isNifti2 : {false, true}) {
            const Scan scan{.storage = storage, .isNifti2 = isNifti2};
            ExpectUpright(Read(WithSform(FileOf(scan), scan.Steps(), isNifti2)));
            ExpectUpright(Read(WithQform(FileOf(scan), storage.Directions(), isNifti2)));
        }
}

TEST(VolumeAxes, TheSformGoesBeforeTheQformAndThatBeforeVoxelSizes) {
    const Scan mirrored{.storage = {{0, 1, 2}, {1, 0, 0}}};
    const glm::dmat3 wrong = glm::dmat3(0, 0, 1, 1, 0, 0, 0, 1, 0);
    const BinaryFile both = WithQform(WithSform(FileOf(mirrored), mirrored.Steps()), wrong);
    ExpectUpright(Read(both));
    EXPECT_EQ(Read(both).what, "4 x 3 x 5 voxels of 0.5 x 2 x 1.25 mm; sform, stored LAS");
    const BinaryFile qform =
        WithQform(WithSform(FileOf(mirrored), wrong).Set<int16_t>(254, 0), mirrored.storage.Directions());
    ExpectUpright(Read(qform));
    EXPECT_EQ(Read(qform).what, "4 x 3 x 5 voxels of 0.5 x 2 x 1.25 mm; qform, stored LAS");
    const BinaryFile none = WithQform(FileOf({}), wrong).Set<int16_t>(252, 0);
    ExpectUpright(Read(none));
    EXPECT_EQ(Read(none).what, "4 x 3 x 5 voxels of 0.5 x 2 x 1.25 mm; voxel sizes alone, no orientation");
}

// An sform that says nothing of three directions, or no numbers, is as none.
TEST(VolumeAxes, WhatIsNoOrientationIsPassedOver) {
    const Scan mirrored{.storage = {{0, 1, 2}, {1, 0, 0}}};
    glm::dmat3 flat = mirrored.Steps(), parallel = flat, notANumber = flat, huge = flat;
    flat[2] = glm::dvec3(0);
    parallel[1] = -2.0 * parallel[0];
    notANumber[1][1] = NAN;
    huge[0][0] = INFINITY;
    for (const glm::dmat3& steps : {flat, parallel, notANumber, huge}) {
        const BinaryFile file = WithSform(FileOf(mirrored), steps);
        EXPECT_TRUE(Read(file).what.ends_with("voxel sizes alone, no orientation"));
        ExpectUpright(Read(WithQform(file, mirrored.storage.Directions())));
    }
    for (const float b : {NAN, INFINITY}) {
        BinaryFile file = WithQform(FileOf({}), glm::dmat3(1));
        ExpectUpright(Read(file.Set(256, b)));
    }
}

TEST(VolumeAxes, SidesAreTheSformsAndInItsUnit) {
    const Scan scan{.storage = {{2, 0, 1}, {0, 1, 1}}};
    BinaryFile file = WithSform(FileOf(scan), 2.0 * scan.Steps());
    file.Set(80, 7.0f);
    EXPECT_EQ(Read(file).voxelMillimetres, glm::vec3(1, 4, 2.5f));
    EXPECT_EQ(Read(file.Set<uint8_t>(123, 3)).voxelMillimetres, glm::vec3(0.001f, 0.004f, 0.0025f));
    EXPECT_EQ(ErrorOf([&] { Read(WithSform(FileOf(scan), 1e7 * scan.Steps())); }),
              "v: voxels of 5e+06 millimetres along axis 2; 1e-06 to 1e+06 are expected");
}

// The place of each voxel in the world, but for one offset of all: by the file's matrix, and by what was read.
void ExpectSamePlaces(const Scan& scan, const Volume& volume) {
    const glm::dmat3 steps = scan.Steps();
    const glm::dmat3 read(volume.worldFromAxes);
    const glm::ivec3 along = scan.storage.along;
    const glm::ivec3 stored(kExtent[along[0]], kExtent[along[1]], kExtent[along[2]]);
    std::vector<glm::dvec3> places(1000);  // by value
    for (int z = 0; z < stored.z; z++)
        for (int y = 0; y < stored.y; y++)
            for (int x = 0; x < stored.x; x++)
                places[static_cast<size_t>(Value(scan.storage.World({x, y, z})))] = steps * glm::dvec3(x, y, z);
    const glm::dvec3 offset = places[static_cast<size_t>(volume.voxels[0])];
    size_t i = 0;
    for (uint32_t z = 0; z < volume.depthVoxels; z++)
        for (uint32_t y = 0; y < volume.heightVoxels; y++)
            for (uint32_t x = 0; x < volume.widthVoxels; x++, i++) {
                const glm::dvec3 place = read * (glm::dvec3(volume.voxelMillimetres) * glm::dvec3(x, y, z));
                const glm::dvec3 expected = places[static_cast<size_t>(volume.voxels[i])] - offset;
                ASSERT_LT(glm::length(place - expected), 1e-5);
            }
    for (int axis = 0; axis < 3;
         axis++)  // the nearest axes: no other would be nearer than half a right angle's cosine
        EXPECT_GT(read[axis][axis], 0.5) << volume.what;
}

TEST(VolumeAxes, ObliqueScansKeepTheirVoxelsAndHaveTheRotationThatIsLeft) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> angle(-0.6, 0.6);
    for (const Storage& storage : AllStorages()) {
        glm::dvec3 axis(angle(random), angle(random), angle(random));
        const Scan scan{.storage = storage,
                        .turn = glm::mat3_cast(glm::angleAxis(angle(random), glm::normalize(axis))),
                        .isNifti2 = true};
        for (const BinaryFile& file : {WithSform(FileOf(scan), scan.Steps(), true),
                                       WithQform(FileOf(scan), scan.turn * storage.Directions(), true)}) {
            const Volume volume = Read(file);
            EXPECT_FALSE(volume.hasShear);
            ExpectSamePlaces(scan, volume);
            for (int column = 0; column < 3; column++)
                EXPECT_LT(glm::length(glm::dvec3(volume.worldFromAxes[column]) - scan.turn[column]), 1e-6);
        }
    }
}

TEST(VolumeAxes, HalfARightAngleAndAnyRotationAreReadRight) {
    std::mt19937 random(6);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 200; i++) {
        const glm::dquat q =
            i == 0 ? glm::angleAxis(glm::quarter_pi<double>(), glm::dvec3(0, 0, 1))
                   : glm::normalize(glm::dquat(normal(random), normal(random), normal(random), normal(random)));
        const Scan scan{.turn = glm::mat3_cast(q), .isNifti2 = true};
        ExpectSamePlaces(scan, Read(WithSform(FileOf(scan), scan.Steps(), true)));
        ExpectSamePlaces(scan, Read(WithQform(FileOf(scan), scan.turn, true)));
    }
}

TEST(VolumeAxes, SaysHowFarItIsTurnedAndThatAShearIsLeftOut) {
    const Scan turned{.turn = glm::mat3_cast(glm::angleAxis(glm::radians(12.5), glm::dvec3(0, 0, 1)))};
    EXPECT_TRUE(Read(WithSform(FileOf(turned), turned.Steps())).what.ends_with("RAS, turned by 12.50 degrees"));
    glm::dmat3 sheared = Scan().Steps();
    sheared[1].x += 0.5;
    const Volume volume = Read(WithSform(FileOf({}), sheared));
    EXPECT_TRUE(volume.hasShear);
    EXPECT_TRUE(volume.what.ends_with(" degrees, without its shear")) << volume.what;
    EXPECT_NEAR(volume.voxelMillimetres.y, std::hypot(2, 0.5), 1e-6);
    EXPECT_NEAR(glm::determinant(volume.worldFromAxes), 1, 1e-6);
}

// Any bits in the fields that say how it lies: a volume whose rotation is one, or one line.
TEST(VolumeAxes, AnyNumbersInTheHeaderAreAnOrientationOrNone) {
    std::mt19937 random(7);
    int volumes = 0, turned = 0;
    for (int i = 0; i < 5000; i++) {
        BinaryFile file = WithQform(WithSform(FileOf({}), Scan().Steps()), glm::dmat3(1));
        if (i % 2 == 0) file.Set<int16_t>(254, 0);
        const size_t first = i % 2 == 0 ? 256 : 280, count = i % 2 == 0 ? 6 : 12;
        for (int changes = 0; changes < 1 + i % 5; changes++) {
            const auto number = i % 3 == 0 ? std::bit_cast<float>(static_cast<uint32_t>(random()))
                                           : static_cast<float>(random() % 21) - 10;
            file.Set(first + 4 * (random() % count), number);
        }
        try {
            const Volume volume = Read(file);
            volumes++;
            const glm::dmat3 read(volume.worldFromAxes);
            turned += read != glm::dmat3(1);
            ASSERT_NEAR(glm::determinant(read), 1, 1e-5);
            for (int axis = 0; axis < 3; axis++)
                ASSERT_NEAR(glm::length(read[axis]), 1, 1e-5);
            std::vector<float> sorted = volume.voxels, expected = Read(FileOf({})).voxels;
            std::ranges::sort(sorted);
            std::ranges::sort(expected);
            ASSERT_EQ(sorted, expected);
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        }
    }
    EXPECT_GT(volumes, 3000);
    EXPECT_GT(turned, 500);
}

TEST(VolumeAxes, TheHeadIsStoredAsItStands) {
    const Volume head = ReadVolume(SAMPLES_FOLDER "ch2bet.nii.gz");
    EXPECT_EQ(head.what, "181 x 217 x 181 voxels of 1 x 1 x 1 mm; sform, stored RAS");
    EXPECT_EQ(head.worldFromAxes, glm::mat3(1));
}

}  // namespace
}  // namespace boxcar::test
