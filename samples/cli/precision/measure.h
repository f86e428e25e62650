// How well a table gives its picture back: signal to noise of the 1 x 1 box, error of wider boxes.
//
// Hensley 2005, sect. 4.1 (the identity filter) and 4.2
#pragma once

#include <functional>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "samples/cli/precision/precision_table.h"

namespace boxcar {

// What is taken off every texel. Hensley 2005, sect. 4.2.1
enum class Bias { None, Half, Mean };
const char* Name(Bias bias);

// A picture as it is measured.
struct Subject {
    Extent2D extent;
    std::vector<glm::vec4> texels;  // rows from the top
    int colors = 3;                 // channels that are measured, from the first: alpha is left out
    uint32_t largestCode = 0;       // what a sample of 1 is as a whole code, 255 or 65535; 0: has no codes
    bool wholeCodes = false;        // the samples are codes / largestCode; else they are rounded to them, an error
};

struct Case {
    Precision precision = Precision::Fp32;
    Bias bias = Bias::None;
    SATOrigin origin = SATOrigin::Corner;
    uint32_t taps = 4;
    Builder builder = Builder::Raster;
};

struct Measurement {
    Case setup;

    // 10 log10(sum I^2 / sum (I - R)^2) over all colour channels, R the 1 x 1 box, not clamped; infinite where R is
    // I. Nothing where a box is infinite or NaN: a sum was beyond the precision's largest value.
    std::optional<double> snrDb;

    struct Width {
        uint32_t sizeTexels = 1;
        std::optional<double> rms;  // of the box mean, in the picture's units; nothing as above
    };
    std::vector<Width> widths;
};

// 1, 3, 9, 33, 129
extern const std::vector<uint32_t> kMeasuredWidths;

// Uploads a picture once and measures any number of tables of it. The reference is in double: sums of the samples, or
// for whole codes sums of the codes, which are exact.
class Meter {
public:
    Meter(Device& device, Subject subject, std::vector<uint32_t> widths = kMeasuredWidths);

    Measurement Measure(const Case& setup);

    // The 1 x 1 boxes, as R above; under U32 divided by the largest code.
    std::vector<glm::vec4> Identity(const Case& setup);

    const Subject& Picture() const { return m_subject; }

    // What Bias::Mean takes off, from the device.
    glm::vec4 Mean() const { return m_mean; }

private:
    struct Reference {
        uint32_t sizeTexels;
        std::vector<double> means;  // colours interleaved
    };

    TableSetup SetupOf(const Case& setup) const;
    const Image& Table(const Case& setup);
    std::vector<double> BoxMeans(const Case& setup, const Image& table, uint32_t sizeTexels);
    std::vector<Reference> References(double scale, bool rounded) const;

    Device& m_device;
    Subject m_subject;
    Image m_source;
    glm::vec4 m_mean{0};
    PrecisionTable m_table;
    std::vector<uint32_t> m_widths;
    std::vector<Reference> m_samples;  // box means of the samples
    std::vector<Reference> m_codes;    // of the codes, in codes
};

// All cases that a picture is measured in: every precision, bias, origin and number of taps, then the other builders.
// `largestCode` as in Subject: floats have no U32 and only 8 bits have blocks.
std::vector<Case> AllCases(uint32_t largestCode);

}  // namespace boxcar
