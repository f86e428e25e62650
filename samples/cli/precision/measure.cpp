#include "samples/cli/precision/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/passes/mean.h"
#include "runtime/transfer.h"

namespace boxcar {
namespace {

// Box sums of one channel, clipped to the image, by a table in double.
class DoubleTable {
public:
    DoubleTable(const std::vector<double>& samples, int width, int height)
        : m_width(width), m_height(height), m_sums((width + 1) * size_t(height + 1), 0.0) {
        for (int y = 0; y < height; y++) {
            double row = 0;
            for (int x = 0; x < width; x++) {
                row += samples[size_t(y) * width + x];
                m_sums[At(x + 1, y + 1)] = m_sums[At(x + 1, y)] + row;
            }
        }
    }

    double Mean(int x, int y, int sizeTexels) const {
        const int left = std::max(x - sizeTexels / 2, 0), right = std::min(x + sizeTexels / 2 + 1, m_width);
        const int top = std::max(y - sizeTexels / 2, 0), bottom = std::min(y + sizeTexels / 2 + 1, m_height);
        const double sum =
            m_sums[At(right, bottom)] - m_sums[At(left, bottom)] - m_sums[At(right, top)] + m_sums[At(left, top)];
        return sum / (double(right - left) * (bottom - top));
    }

private:
    size_t At(int x, int y) const { return size_t(y) * (m_width + 1) + x; }

    int m_width;
    int m_height;
    std::vector<double> m_sums;
};

double Area(int x, int y, int sizeTexels, Extent2D extent) {
    const auto side = [&](int at, uint32_t size) {
        return std::min(at + sizeTexels / 2 + 1, static_cast<int>(size)) - std::max(at - sizeTexels / 2, 0);
    };
    return double(side(x, extent.widthTexels)) * side(y, extent.heightTexels);
}

}  // namespace

const std::vector<uint32_t> kMeasuredWidths = {1, 3, 9, 33, 129};

const char* Name(Bias bias) {
    constexpr const char* kNames[] = {"none", "half", "mean"};
    return kNames[static_cast<size_t>(bias)];
}

Meter::Meter(Device& device, Subject subject, std::vector<uint32_t> widths)
    : m_device(device),
      m_subject(std::move(subject)),
      m_source(device, {m_subject.extent, Format::RGBA32F, "measured picture"}),
      m_table(device, m_subject.extent),
      m_widths(std::move(widths)) {
    WriteTexels(device, m_source, std::as_bytes(std::span(m_subject.texels)));
    class Mean mean(device, m_subject.extent);
    CommandList commands(device);
    const Image& texel = mean.Record(commands, m_source);
    commands.SubmitAndWait();
    ReadTexels(device, texel, std::as_writable_bytes(std::span(&m_mean, 1)));
    m_samples = References(1, false);
    if (m_subject.largestCode > 0) m_codes = References(m_subject.largestCode, m_subject.wholeCodes);
}

// The box means of the samples times `scale`; `rounded`: they are whole numbers but for the rounding of v / 255.
std::vector<Meter::Reference> Meter::References(double scale, bool rounded) const {
    const auto width = static_cast<int>(m_subject.extent.widthTexels);
    const auto height = static_cast<int>(m_subject.extent.heightTexels);
    std::vector<DoubleTable> tables;
    for (int c = 0; c < m_subject.colors; c++) {
        std::vector<double> samples;
        samples.reserve(m_subject.texels.size());
        for (const glm::vec4& texel : m_subject.texels)
            samples.push_back(rounded ? std::round(texel[c] * scale) : texel[c] * scale);
        tables.emplace_back(samples, width, height);
    }
    std::vector<Reference> references;
    for (const uint32_t sizeTexels : m_widths) {
        Reference& reference = references.emplace_back(Reference{sizeTexels, {}});
        reference.means.reserve(m_subject.texels.size() * tables.size());
        for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++)
                for (const DoubleTable& table : tables)
                    reference.means.push_back(table.Mean(x, y, static_cast<int>(sizeTexels)));
    }
    return references;
}

TableSetup Meter::SetupOf(const Case& setup) const {
    const glm::vec4 biases[] = {glm::vec4(0), glm::vec4(0.5f), m_mean};
    return {setup.precision,      biases[static_cast<size_t>(setup.bias)], setup.origin, setup.taps, setup.builder,
            m_subject.largestCode};
}

const Image& Meter::Table(const Case& setup) {
    CommandList commands(m_device);
    const Image& table = m_table.Record(commands, m_source, SetupOf(setup));
    commands.SubmitAndWait();
    return table;
}

// Colours interleaved; under U32 in codes.
std::vector<double> Meter::BoxMeans(const Case& setup, const Image& table, uint32_t sizeTexels) {
    CommandList commands(m_device);
    const Image& boxes = m_table.RecordBox(commands, table, SetupOf(setup), sizeTexels);
    commands.SubmitAndWait();
    std::vector<double> means;
    means.reserve(m_subject.texels.size() * m_subject.colors);
    if (setup.precision != Precision::U32) {
        std::vector<glm::vec4> texels(m_subject.texels.size());
        ReadTexels(m_device, boxes, std::as_writable_bytes(std::span(texels)));
        for (const glm::vec4& texel : texels)
            for (int c = 0; c < m_subject.colors; c++)
                means.push_back(texel[c]);
        return means;
    }
    std::vector<glm::uvec4> sums(m_subject.texels.size());
    ReadTexels(m_device, boxes, std::as_writable_bytes(std::span(sums)));
    const auto width = static_cast<int>(m_subject.extent.widthTexels);
    for (int i = 0; i < static_cast<int>(sums.size()); i++) {
        const double area = Area(i % width, i / width, static_cast<int>(sizeTexels), m_subject.extent);
        for (int c = 0; c < m_subject.colors; c++)
            means.push_back(sums[i][c] / area);
    }
    return means;
}

// Whole sums are compared in codes, so that no rounding of v / 255 comes between.
Measurement Meter::Measure(const Case& setup) {
    const bool whole = setup.precision == Precision::U32;
    const double unit = whole ? 1.0 / m_subject.largestCode : 1.0;
    const Image& table = Table(setup);
    Measurement measured{setup, {}, {}};
    for (const Reference& reference : whole ? m_codes : m_samples) {
        const std::vector<double> means = BoxMeans(setup, table, reference.sizeTexels);
        double signal = 0, noise = 0;
        for (size_t i = 0; i < means.size(); i++) {
            const double error = means[i] - reference.means[i];
            signal += reference.means[i] * reference.means[i];
            noise += error * error;
        }
        std::optional<double> rms;
        if (std::isfinite(noise)) rms = unit * std::sqrt(noise / static_cast<double>(means.size()));
        measured.widths.push_back({reference.sizeTexels, rms});
        if (reference.sizeTexels == 1 && rms)
            measured.snrDb = noise > 0 ? 10 * std::log10(signal / noise) : std::numeric_limits<double>::infinity();
    }
    return measured;
}

std::vector<glm::vec4> Meter::Identity(const Case& setup) {
    const std::vector<double> means = BoxMeans(setup, Table(setup), 1);
    const double unit = setup.precision == Precision::U32 ? 1.0 / m_subject.largestCode : 1.0;
    std::vector<glm::vec4> texels = m_subject.texels;
    for (size_t i = 0; i < texels.size(); i++)
        for (int c = 0; c < m_subject.colors; c++)
            texels[i][c] = static_cast<float>(unit * means[i * m_subject.colors + c]);
    return texels;
}

std::vector<Case> AllCases(uint32_t largestCode) {
    constexpr uint32_t kTaps[] = {2, 4, 8, 16};
    constexpr Bias kBiases[] = {Bias::None, Bias::Half, Bias::Mean};
    std::vector<Case> cases;
    for (const Precision precision : {Precision::Fp16, Precision::Fp24, Precision::Fp24Truncated, Precision::Fp32})
        for (const Bias bias : kBiases)
            for (const SATOrigin origin : {SATOrigin::Corner, SATOrigin::Center})
                for (const uint32_t taps : kTaps)
                    cases.push_back({precision, bias, origin, taps, Builder::Raster});
    if (largestCode > 0)
        for (const uint32_t taps : kTaps)
            cases.push_back({Precision::U32, Bias::None, SATOrigin::Corner, taps, Builder::Raster});
    for (const Bias bias : kBiases)
        cases.push_back({Precision::Fp32, bias, SATOrigin::Corner, 4, Builder::Frame});
    for (const Precision precision : {Precision::Fp16, Precision::Fp32})
        cases.push_back({precision, Bias::None, SATOrigin::Corner, 2, Builder::Lines});
    if (largestCode == 255) cases.push_back({Precision::U32, Bias::None, SATOrigin::Corner, 4, Builder::Blocks});
    return cases;
}

}  // namespace boxcar
