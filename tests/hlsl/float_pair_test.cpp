// Arithmetic beyond float, which a compiler that rearranges sums would undo: what float_pair.hlsli and the weights of
// sat_exact.hlsli compute on the device, against numbers of 64 bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "test_support_shaders.h"
#include "tests/support/device_buffer.h"

namespace boxcar {
namespace {

static_assert(std::numeric_limits<long double>::digits >= 64);

using Floats = std::vector<float>;

// Runs a shader that reads `source` from the buffer of a name and writes `resultsPerThread` floats a thread.
Floats RunShader(const char* shader, const std::string& sourceName, const Floats& source, uint32_t threads,
                 uint32_t resultsPerThread) {
    NamedWords buffers;
    for (const float value : source)
        buffers[sourceName].push_back(std::bit_cast<uint32_t>(value));
    buffers["results"].resize(static_cast<size_t>(threads) * resultsPerThread);
    const NamedWords after = RunCompute(test_support_shaders::Find(shader), buffers, threads / 64);
    Floats results;
    for (const uint32_t word : after.at("results"))
        results.push_back(std::bit_cast<float>(word));
    return results;
}

enum Operation : uint32_t { kSum, kOrdered, kSplit, kProduct, kAdd, kSub, kMul, kDiv, kSqrt, kOperations };

struct Operands {
    float aHigh, bHigh, aLow, bLow;
    long double A() const { return static_cast<long double>(aHigh) + aLow; }
    long double B() const { return static_cast<long double>(bHigh) + bLow; }
};

struct Case {
    Operands in;
    long double results[kOperations];  // high + low
};

constexpr uint32_t kThreads = 4096;

// Magnitudes from 2^-16 to 2^16, some with few digits, some of which almost cancel; low parts of up to half a unit.
std::vector<Operands> RandomOperands() {
    std::mt19937 random(61);
    const auto high = [&] {
        const uint32_t digits = random() % 4 == 0 ? random() % 16 : random() % (1u << 23);
        const float magnitude =
            std::ldexp(1 + std::ldexp(static_cast<float>(digits), -23), static_cast<int>(random() % 32) - 16);
        return random() % 2 == 0 ? magnitude : -magnitude;
    };
    const auto low = [&](float of) {
        const float half = std::ldexp(0.5f, std::ilogb(of) - 23);
        return half * std::uniform_real_distribution<float>(-1, 1)(random);
    };
    std::vector<Operands> operands(4 * kThreads);
    for (Operands& o : operands) {
        o.aHigh = high();
        o.bHigh = random() % 4 != 0 ? high() : -o.aHigh * (1 + std::ldexp(static_cast<float>(random() % 8), -23));
        o.aLow = low(o.aHigh);
        o.bLow = low(o.bHigh);
    }
    return operands;
}

std::vector<Case> RunPairs() {
    const std::vector<Operands> operands = RandomOperands();
    Floats source;
    for (uint32_t thread = 0; thread < kThreads; thread++)
        for (const auto member : {&Operands::aHigh, &Operands::bHigh, &Operands::aLow, &Operands::bLow})
            for (uint32_t lane = 0; lane < 4; lane++)
                source.push_back(operands[4 * thread + lane].*member);
    const Floats results = RunShader("shaders/float_pair.cs", "operands", source, kThreads, 8 * kOperations);
    std::vector<Case> cases;
    for (uint32_t i = 0; i < 4 * kThreads; i++) {
        Case& made = cases.emplace_back(Case{operands[i], {}});
        for (uint32_t operation = 0; operation < kOperations; operation++) {
            const float* high = &results[8 * (i / 4 * kOperations + operation) + i % 4];
            EXPECT_LE(std::abs(high[4]), operation == kSplit ? std::abs(high[0]) : std::ldexp(std::abs(high[0]), -23))
                << "operation " << operation;
            made.results[operation] = static_cast<long double>(high[0]) + high[4];
        }
    }
    return cases;
}

TEST(FloatPair, SumsSplitsAndProductsOfFloatsAreExact) {
    for (const Case& c : RunPairs()) {
        const long double a = c.in.aHigh, b = c.in.bHigh;
        ASSERT_EQ(c.results[kSum], a + b) << a << " + " << b;
        ASSERT_EQ(c.results[kOrdered], a + c.in.aLow) << a << " + " << c.in.aLow;
        ASSERT_EQ(c.results[kSplit], a);
        ASSERT_EQ(c.results[kProduct], a * b) << a << " * " << b;
    }
}

TEST(FloatPair, ErrorsStayWithinTheirBounds) {
    for (const Case& c : RunPairs()) {
        const long double a = c.in.A(), b = c.in.B();
        const long double larger = std::max(std::abs(a), std::abs(b));
        ASSERT_LE(std::abs(c.results[kAdd] - (a + b)), 0x1p-46L * larger) << a << " + " << b;
        ASSERT_LE(std::abs(c.results[kSub] - (a - b)), 0x1p-46L * larger) << a << " - " << b;
        ASSERT_LE(std::abs(c.results[kMul] - a * b), 0x1p-45L * std::abs(a * b)) << a << " * " << b;
        ASSERT_LE(std::abs(c.results[kDiv] - a / b), 0x1p-44L * std::abs(a / b)) << a << " / " << b;
        const long double root = std::sqrt(std::abs(static_cast<long double>(c.in.aHigh)));
        ASSERT_LE(std::abs(c.results[kSqrt] - root), 0x1p-44L * root) << c.in.aHigh;
    }
}

TEST(SATStretches, WeightsAreWhatTheBoxCoversExactly) {
    std::mt19937 random(62);
    std::uniform_real_distribution<float> begin(-3, 3), width(0, 4);
    Floats boxes;
    for (uint32_t thread = 0; thread < kThreads; thread++) {
        // Near 0 a float has digits that 1 less it has not.
        const float lo =
            thread % 8 == 0 ? std::floor(begin(random)) : std::ldexp(begin(random), -static_cast<int>(random() % 16));
        boxes.insert(boxes.end(), {lo, lo + (thread % 4 == 0 ? 0.25f : 1.0f) * width(random)});
    }
    const Floats results = RunShader("shaders/sat_stretches.cs", "boxes", boxes, kThreads, 12);
    for (uint32_t thread = 0; thread < kThreads; thread++) {
        const double lo = boxes[2 * thread], hi = boxes[2 * thread + 1];
        const float* corners = &results[12 * static_cast<size_t>(thread)];
        ASSERT_TRUE(corners[0] <= lo && hi <= corners[3]) << lo << " to " << hi;
        for (uint32_t i = 0; i < 3; i++) {
            const double texels = corners[i + 1] - corners[i];
            const double covered =
                std::max(std::min<double>(corners[i + 1], hi) - std::max<double>(corners[i], lo), 0.0);
            const double weight = static_cast<double>(corners[4 + i]) + corners[8 + i];
            ASSERT_EQ(texels * weight, texels > 0 ? covered : 0) << "stretch " << i << " of " << lo << " to " << hi;
        }
    }
}

}  // namespace
}  // namespace boxcar
