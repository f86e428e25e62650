// Pictures as the whole numbers that exact tables sum.
//
// Asked for by name (--precision u32, u64), codes are what the manual says:
//
//   8 and 16-bit files, raw   their own codes, 0..255 or 0..65535
//   8 and 16-bit files        linear light, colors times alpha, as round(65535 v)
//   float files               v 2^24 in two words: every half float is a multiple of 2^-24
//
// Otherwise they are as fine as the result needs: the file's own codes under raw; else round(v scale), the scale a
// power of two that the words hold under the kernel. Where one such number is too coarse for the smallest values,
// what it leaves over is filtered too, and the results are added: filters are linear.
#pragma once

#include <glm/ext/vector_uint4.hpp>
#include <vector>

#include "runtime/passes/sat_filter.h"
#include "samples/app/device_run.h"
#include "samples/app/light.h"
#include "samples/app/stats.h"
#include "samples/files/picture.h"

namespace boxcar {

// The widest kernel to come.
struct KernelSize {
    glm::vec2 sizeTexels{1};  // of the boxes that it is made of
    uint32_t order = 1;
    bool isWhole = false;  // SATIsWhole, and one width everywhere
};

// One table's worth of codes: value = unit * code / codes.scale.
struct CodeRound {
    SATCodes codes = {};
    double unit = 1;  // a power of two, that results are multiplied by

    double Step() const { return unit / codes.scale; }
};

// How the values of a picture are summed: the first round's codes are of the picture, the others' of what the rounds
// before leave over.
struct CodePlan {
    SATPrecision precision = SATPrecision::U32;
    std::vector<CodeRound> rounds = {};
};

// The codes of a precision asked for by name. Throws Error, which begins with `name`: a float picture for U32; a
// sample of 65536 or more, or one that is not a multiple of 2^-24.
CodePlan NamedCodes(const Picture& picture, const std::string& name, Transfer transfer, SATPrecision precision);

// The codes that keep a filtered picture right: U32 where it holds them, else U64, in as many rounds as it takes.
//
//   result  the samples of the file to write. Integers: the codes' own rounding moves no sample by more than 0.005 of
//           its codes. Floats: each value is kept within 2^-20 of itself.
//
// Throws Error, which begins with `name`: a kernel so wide that 64 bits do not hold 8 steps of each texel.
CodePlan FittingCodes(const Picture& picture, const std::string& name, Transfer transfer, SampleType result,
                      const KernelSize& kernel);

// Says in `stats` how a result was summed.
void AddPlan(Stats& stats, const CodePlan& plan);

// RGBA; channels that the picture does not have are 0. Two's complement.
struct CodeWords {
    std::vector<glm::uvec4> low;
    std::vector<glm::uvec4> high;  // empty for U32
};

// A picture as codes, any rows of it.
class CodedPicture {
public:
    CodedPicture(const Picture& picture, Transfer transfer, CodePlan plan);

    const CodePlan& Plan() const { return m_plan; }

    // The codes of rows [firstRow, firstRow + rows), from the top.
    CodeWords Rows(size_t round, uint32_t firstRow, uint32_t rows) const;

    // The same on the device.
    WordImages Upload(Device& device, size_t round, uint32_t firstRow, uint32_t rows) const;

private:
    const Picture& m_picture;
    CodePlan m_plan;
    std::vector<double> m_light;  // of every code of the file; empty where samples are summed as they are
};

}  // namespace boxcar
