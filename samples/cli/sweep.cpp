#include <fmt/format.h>
#include <stb_easy_font.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "samples/cli/commands.h"
#include "samples/cli/effect_run.h"
#include "samples/cli/outputs.h"

namespace boxcar {
namespace {

constexpr uint32_t kLabelTexels = 22;  // height of the line under each picture
constexpr int kLetterScale = 2;
constexpr uint64_t kMaxPictures = 256;

struct SweepOptions : EffectOptions {
    std::string output;
    std::string formatWord;
};

struct Swept {
    std::string name;
    std::vector<std::string> values;
};

Swept ParseSwept(const std::string& text) {
    const Setting setting = ParseSetting(text);
    Swept swept{setting.name, {}};
    size_t begin = 0;
    for (size_t comma = 0; comma != std::string::npos; begin = comma + 1) {
        comma = setting.value.find(',', begin);
        swept.values.push_back(setting.value.substr(begin, comma - begin));
    }
    return swept;
}

// Pictures in rows, each with a line of text under it: black on white, which are 0 and 1 as codes and as light.
class ContactSheet {
public:
    ContactSheet(Extent2D tile, uint32_t columns, uint32_t rows, SampleType sampleType)
        : m_tile(tile),
          m_picture{columns * tile.widthTexels, rows * (tile.heightTexels + kLabelTexels), 3, sampleType, {}} {
        m_picture.samples.assign(size_t{3} * m_picture.widthTexels * m_picture.heightTexels, 1.0f);
    }

    void Add(const Picture& tile, uint32_t column, uint32_t row, const std::string& label) {
        const uint32_t left = column * m_tile.widthTexels, top = row * (m_tile.heightTexels + kLabelTexels);
        for (uint32_t y = 0; y < m_tile.heightTexels; y++)
            for (uint32_t x = 0; x < m_tile.widthTexels; x++)
                for (uint32_t c = 0; c < 3; c++)
                    At(left + x, top + y, c) = tile.samples[(size_t{y} * m_tile.widthTexels + x) * 3 + c];
        Write(label, left + 4, top + m_tile.heightTexels + 4, left + m_tile.widthTexels);
    }

    const Picture& Finished() const { return m_picture; }

private:
    struct FontVertex {
        float x, y, z;
        unsigned char color[4];
    };

    float& At(uint32_t x, uint32_t y, uint32_t channel) {
        return m_picture.samples[(size_t{y} * m_picture.widthTexels + x) * 3 + channel];
    }

    // stb's font is made of upright rectangles.
    void Write(std::string text, uint32_t left, uint32_t top, uint32_t right) {
        std::vector<FontVertex> corners(text.size() * 4 * 16 + 4);
        const int rectangles = stb_easy_font_print(0, 0, text.data(), nullptr, corners.data(),
                                                   static_cast<int>(corners.size() * sizeof(FontVertex)));
        for (int i = 0; i < rectangles; i++) {
            const FontVertex &from = corners[static_cast<size_t>(4 * i)],
                             &to = corners[static_cast<size_t>(4 * i + 2)];
            const auto scaled = [](float edge) { return static_cast<uint32_t>(kLetterScale * edge); };
            for (uint32_t y = top + scaled(from.y); y < std::min(top + scaled(to.y), m_picture.heightTexels); y++)
                for (uint32_t x = left + scaled(from.x); x < std::min(left + scaled(to.x), right); x++)
                    for (uint32_t c = 0; c < 3; c++)
                        At(x, y, c) = 0;
        }
    }

    Extent2D m_tile;
    Picture m_picture;
};

void Sweep(const SweepOptions& options) {
    std::vector<Setting> fixed;
    std::vector<Swept> swept;
    for (const std::string& set : options.sets) {
        Swept one = ParseSwept(set);
        if (one.values.size() > 1)
            swept.push_back(std::move(one));
        else
            fixed.push_back({one.name, one.values[0]});
    }
    for (size_t i = 0; i < options.sets.size(); i++)
        for (size_t k = 0; k < i; k++)
            if (ParseSetting(options.sets[i]).name == ParseSetting(options.sets[k]).name)
                throw UsageError("--set {}: it is set twice", ParseSetting(options.sets[i]).name);
    if (swept.empty() || swept.size() > 2)
        throw UsageError(
            "{} lists in --set: sweep takes one (a row) or two (columns and rows), as in --set width=1,9,33",
            swept.size());
    if (swept.size() == 1) swept.push_back({"", {""}});
    const auto columns = static_cast<uint32_t>(swept[0].values.size()),
               rows = static_cast<uint32_t>(swept[1].values.size());
    if (uint64_t{columns} * rows > kMaxPictures)
        throw UsageError("{} x {} pictures: a sheet holds at most {}", columns, rows, kMaxPictures);
    const Job job = PlanJobs({{options.effect + ".png"}, options.output, options.formatWord}).at(0);
    RequireWritable(job.output, job.format, 3);
    RequireFolder(job.output);

    ParameterValues values(FindEffect(options.effect).parameters);
    for (const Setting& setting : fixed)
        values.Set(setting.name, setting.value);
    for (const Swept& one : swept)
        for (const std::string& value : one.values)
            if (!one.name.empty()) values.Set(one.name, value);

    CheckedDevice device(options.device);
    std::unique_ptr<ContactSheet> sheet;
    const SampleType sampleType = SampleTypeFor(job.format, SampleType::Unorm8);
    const bool terminal = isatty(STDERR_FILENO);
    for (uint32_t row = 0; row < rows; row++)
        for (uint32_t column = 0; column < columns; column++) {
            if (terminal) fmt::print(stderr, "\r[{}/{}]", row * columns + column + 1, columns * rows);
            std::vector<Setting> settings = fixed;
            settings.push_back({swept[0].name, swept[0].values[column]});
            std::string label = fmt::format("{}={}", swept[0].name, swept[0].values[column]);
            if (!swept[1].name.empty()) {
                settings.push_back({swept[1].name, swept[1].values[row]});
                label += fmt::format("  {}={}", swept[1].name, swept[1].values[row]);
            }
            EffectRun run(*device, options, settings);
            if (!sheet) {
                run.PrintNotes();
                const auto [width, height] = run.Extent();
                if (uint64_t{width} * columns > 16384 || uint64_t{height + kLabelTexels} * rows > 16384)
                    throw UsageError("{} x {} pictures of {} x {} texels: a sheet has at most 16384 a side", columns,
                                     rows, width, height);
                sheet = std::make_unique<ContactSheet>(run.Extent(), columns, rows, sampleType);
            }
            sheet->Add(run.Render(options.timeSeconds, sampleType), column, row, label);
        }
    if (terminal) fmt::print(stderr, "\r\033[K");
    WritePicture(sheet->Finished(), job.output, job.format, sampleType);
    device.RequireClean();
}

}  // namespace

Command AddSweepCommand(CLI::App& app) {
    const auto options = std::make_shared<SweepOptions>();
    CLI::App& command = *app.add_subcommand("sweep", "An effect at several values of a parameter, side by side");
    command.footer(
        "A list in --set makes a row of pictures; two lists make columns and rows. Each is as render makes it.\n\n"
        "Example:\n  boxcar sweep planar-reflection --set roughness=0.02,0.1,0.4 --size 320x200 -o contact.png");
    AddEffectOptions(command, *options);
    AddSamplesOption(command, *options);
    command.add_option("-o,--output", options->output, "The sheet")->required()->type_name("OUT");
    AddFormatOption(command, options->formatWord);
    return {&command, [options] { Sweep(*options); }};
}

}  // namespace boxcar
