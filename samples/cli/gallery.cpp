#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <memory>

#include "runtime/passes/sat_verbatim_blur.h"
#include "samples/app/device_run.h"
#include "samples/app/disparity.h"
#include "samples/app/filter_picture.h"
#include "samples/app/focus_picture.h"
#include "samples/app/light.h"
#include "samples/cli/bspline_figures.h"
#include "samples/cli/commands.h"
#include "samples/cli/console.h"
#include "samples/cli/effect_figures.h"
#include "samples/cli/gallery_page.h"
#include "samples/cli/options.h"
#include "samples/cli/precision/figures.h"
#include "samples/files/bytes.h"
#include "samples/files/color.h"
#include "tools/base/printable.h"

extern "C" const uint8_t boxcar_aloeGT_png[], boxcar_aloeGT_png_end[];
extern "C" const uint8_t boxcar_aloeL_jpg[], boxcar_aloeL_jpg_end[];
extern "C" const uint8_t boxcar_building_jpg[], boxcar_building_jpg_end[];
extern "C" const uint8_t boxcar_city_exr[], boxcar_city_exr_end[];
extern "C" const uint8_t boxcar_fruits_jpg[], boxcar_fruits_jpg_end[];

namespace boxcar {
namespace {

// A picture as the device sees it.
struct Photograph {
    std::string name;
    Picture picture;
    Transfer transfer;
    std::vector<glm::vec4> texels;

    Photograph(const std::string& file, const uint8_t* begin, const uint8_t* end, Transfer how = Transfer::Srgb)
        : Photograph(DecodePicture({begin, end}, file), how, file) {}

    Photograph(Picture made, Transfer how, std::string title = "picture")
        : name(std::move(title)), picture(std::move(made)), transfer(how), texels(ToLight(picture, transfer)) {}

    Extent2D Extent() const { return {picture.widthTexels, picture.heightTexels}; }
};

// Makes the pictures, one section a function, and remembers what the page says about them.
class Gallery {
public:
    Gallery(Device& device, std::filesystem::path folder, std::string sceneSize)
        : m_device(device), m_folder(std::move(folder)), m_sceneSize(std::move(sceneSize)) {}

    void PhotographAtSeveralWidths();
    void StepsOfTheBuild();
    void TableAsAPicture();
    void VerbatimAndCorrected();
    void EdgesOfThePicture();
    void ShapesOfTheKernel();
    void WidthsFromAMap();
    void LensOnAPhotograph();
    void LinearLightAndCodes();
    void HdrEnvironment();
    void SceneEffects() { AddEffectSections(m_device, m_folder, m_sceneSize, m_sections); }
    void ThirdOrder() { AddBSplineSections(m_device, m_folder, m_fruits.picture, m_sections); }
    void Precision() { AddPrecisionSections(m_device, m_folder, m_fruits.picture, m_sections); }

    const std::vector<GallerySection>& Sections() const { return m_sections; }

private:
    using Texels = std::vector<glm::vec4>;

    // `record` appends passes that read its image and returns the one to bring back.
    Texels Run(const Photograph& photograph,
               const std::function<const Image&(CommandList& commands, const Image& source)>& record) {
        const Image source = Upload(m_device, photograph.Extent(), std::span(photograph.texels), "source");
        CommandList commands(m_device);
        const Image& result = record(commands, source);
        commands.SubmitAndWait();
        return Download<glm::vec4>(m_device, result);
    }

    Texels Filtered(const Photograph& photograph, glm::vec2 sizeTexels, FilterRequest request = {}) {
        request.minTexels = request.maxTexels = sizeTexels;
        return Filtered(photograph, request, {});
    }
    Texels Filtered(const Photograph& photograph, const FilterRequest& request, const Texels& widthMap) {
        Stats stats;
        return FilterPicture(m_device, photograph.picture, photograph.name, photograph.transfer, request, widthMap,
                             SampleType::Unorm8, stats, PrintProblem);
    }

    // Writes `texels` as an 8-bit PNG and returns its figure.
    Figure Save(const std::string& file, const Texels& texels, const Photograph& like, const std::string& caption,
                Transfer transfer = Transfer::Srgb) {
        return SaveFigure(m_folder, file, FromLight(texels, like.picture, transfer, SampleType::Unorm8), caption);
    }

    Device& m_device;
    std::filesystem::path m_folder;
    std::string m_sceneSize;
    std::vector<GallerySection> m_sections;

    const Photograph m_fruits{"fruits.jpg", boxcar_fruits_jpg, boxcar_fruits_jpg_end};
    const Photograph m_building{"building.jpg", boxcar_building_jpg, boxcar_building_jpg_end};
};

std::vector<glm::vec4> Scaled(std::vector<glm::vec4> texels, glm::vec4 factor) {
    for (glm::vec4& texel : texels)
        texel *= factor;
    return texels;
}

glm::vec4 Largest(const std::vector<glm::vec4>& texels) {
    glm::vec4 largest(1e-20f);
    for (const glm::vec4& texel : texels)
        largest = glm::max(largest, texel);
    return largest;
}

void Gallery::PhotographAtSeveralWidths() {
    GallerySection section{
        "One photograph, several widths",
        "Crow 1984; Hensley 2005, sect. 2",
        "Each texel becomes the mean of a box round it. One table serves every width, and each costs the same: 16 "
        "loads a "
        "texel. Look at the rim: it neither darkens nor brightens, because the box is clipped to the picture.",
        {},
        {}};
    section.figures.push_back(Save("fruits_1.png", m_fruits.texels, m_fruits, "The photograph (width 1)."));
    for (const float width : {5.0f, 17.0f, 65.0f})
        section.figures.push_back(Save(fmt::format("fruits_{:g}.png", width), Filtered(m_fruits, {width, width}),
                                       m_fruits, fmt::format("{0:g} x {0:g} texels.", width)));
    section.figures.push_back(Save("building_1.png", m_building.texels, m_building, "Another photograph."));
    section.figures.push_back(Save("building_49x1.png", Filtered(m_building, {49, 1}), m_building,
                                   "49 x 1 texels: width and height are free of one another."));
    m_sections.push_back(std::move(section));
}

void Gallery::StepsOfTheBuild() {
    GallerySection section{"The table after each pass",
                           "Hensley 2005, Fig. 3; Scheuermann 2005 (the 4 x 4 example)",
                           "Recursive doubling: each pass adds to a texel the one 1, 2, 4, .. texels to its left, "
                           "then above it. The numbers "
                           "were read back from the device; the last grid is Scheuermann's table.",
                           {},
                           {}};

    const std::vector<std::vector<float>> example = {{2, 3, 2, 1}, {3, 0, 1, 2}, {1, 3, 1, 0}, {1, 4, 2, 2}};
    Photograph small = m_fruits;
    small.picture.widthTexels = small.picture.heightTexels = 4;
    small.texels.clear();
    for (const auto& row : example)
        for (const float value : row)
            small.texels.emplace_back(value);
    section.grids.push_back({"source", example});
    SummedAreaTable smallTable(m_device, {.extent = small.Extent(), .taps = 2});
    for (uint32_t pass = 1; pass <= smallTable.Passes(); pass++) {
        const Texels texels = Run(small, [&](CommandList& commands, const Image& image) -> const Image& {
            return *smallTable.RecordFirst(commands, image, pass).low;
        });
        NumberGrid grid{fmt::format("after pass {} of {}, 2 taps", pass, smallTable.Passes()), {}};
        for (size_t y = 0; y < 4; y++) {
            auto& row = grid.rows.emplace_back();
            for (size_t x = 0; x < 4; x++)
                row.push_back(texels[4 * y + x].r);
        }
        section.grids.push_back(std::move(grid));
    }

    SummedAreaTable table(m_device, {.extent = m_fruits.Extent(), .taps = 8});
    for (uint32_t pass = 1; pass <= table.Passes(); pass++) {
        const Texels texels = Run(m_fruits, [&](CommandList& commands, const Image& image) -> const Image& {
            return *table.RecordFirst(commands, image, pass).low;
        });
        section.figures.push_back(Save(
            fmt::format("build_pass_{}.png", pass), Scaled(texels, 1.0f / Largest(texels)), m_fruits,
            fmt::format("After pass {} of {}, 8 taps; each channel divided by its largest sum, {:.4g} for green.",
                        pass, table.Passes(), Largest(texels).g)));
    }
    m_sections.push_back(std::move(section));
}

void Gallery::TableAsAPicture() {
    GallerySection section{
        "The table as a picture",
        "Green 2003 (\"Summed Area Table (scaled)\")",
        "Sums grow to the right and down, so the table is black at the top left and brightest at the bottom right. "
        "Less "
        "its mean, the picture's table rises and falls instead, and stays small: that is what keeps float32 precise.",
        {},
        {}};
    SummedAreaTable table(m_device, {.extent = m_fruits.Extent()});
    Mean mean(m_device, m_fruits.Extent());
    const Texels plain = Run(m_fruits, [&](CommandList& commands, const Image& image) -> const Image& {
        return *table.Record(commands, image).low;
    });
    section.figures.push_back(
        Save("table.png", Scaled(plain, 1.0f / Largest(plain)), m_fruits,
             fmt::format("The table; white is {:.0f} for red, {:.0f} for green, {:.0f} for blue.", Largest(plain).r,
                         Largest(plain).g, Largest(plain).b)));

    Texels centered = Run(m_fruits, [&](CommandList& commands, const Image& image) -> const Image& {
        return *table.Record(commands, image, &mean.Record(commands, image)).low;
    });
    float largest = 0;
    for (const glm::vec4& texel : centered)
        for (int c = 0; c < 3; c++)
            largest = std::max(largest, std::abs(texel[c]));
    for (glm::vec4& texel : centered)
        texel = 0.5f + 0.5f / largest * texel;
    section.figures.push_back(Save(
        "table_less_mean.png", centered, m_fruits,
        fmt::format("The table of the picture less its mean; gray is 0, white {:.0f}.", largest), Transfer::Raw));
    m_sections.push_back(std::move(section));
}

void Gallery::VerbatimAndCorrected() {
    constexpr float kWidth = 9;
    constexpr float kGain = 8;
    GallerySection section{
        "The printed lookup and the corrected one",
        "Scheuermann 2005 (tex2D_SAT_blur)",
        "As printed, the lookup divides by an area in uv (W x H times too bright; undone here so that there is "
        "something "
        "to see), lies a whole texel too far to the right and down for odd widths, and is not clipped: the right and "
        "bottom rims go dark. The corrected one keeps the rim and the place.",
        {},
        {}};
    SummedAreaTable table(m_device, {.extent = m_fruits.Extent()});
    SatVerbatimBlur verbatim(m_device, m_fruits.Extent());
    const float texelCount = static_cast<float>(m_fruits.Extent().Texels());
    const Texels printed =
        Scaled(Run(m_fruits,
                   [&](CommandList& commands, const Image& image) -> const Image& {
                       return verbatim.Record(commands, *table.Record(commands, image).low, {kWidth, kWidth});
                   }),
               glm::vec4(1 / texelCount));
    const Texels corrected = Filtered(m_fruits, {kWidth, kWidth});
    Texels difference = corrected;
    for (size_t i = 0; i < difference.size(); i++)
        difference[i] = glm::min(kGain * glm::abs(corrected[i] - printed[i]), glm::vec4(1));
    section.figures.push_back(Save("verbatim.png", printed, m_fruits, "As printed, divided by W x H; 9 x 9 texels."));
    section.figures.push_back(Save("corrected.png", corrected, m_fruits, "Corrected: SATSampleBox, 9 x 9 texels."));
    section.figures.push_back(
        Save("verbatim_difference.png", difference, m_fruits,
             "Their difference in linear light, times 8: contours from the shift, a white frame at the "
             "right and the bottom from the missing clip, lines where the lookup, which lies on the "
             "border of two texels, is rounded to the other one.",
             Transfer::Raw));
    m_sections.push_back(std::move(section));
}

void Gallery::EdgesOfThePicture() {
    GallerySection section{
        "Four edges",
        "Crow 1984 (repeated textures); Hensley 2005, sect. 3",
        "What lies outside the picture: nothing, so that the box shrinks (clip); black (zero); the "
        "picture again (repeat): look how the sky comes in at the bottom; its mirror "
        "image (mirror).",
        {},
        {}};
    for (const auto& [edge, word] : {std::pair(SATEdge::Clip, "clip"), std::pair(SATEdge::Zero, "zero"),
                                     std::pair(SATEdge::Repeat, "repeat"), std::pair(SATEdge::Mirror, "mirror")})
        section.figures.push_back(Save(fmt::format("edge_{}.png", word),
                                       Filtered(m_building, {129, 129}, {.edge = edge}), m_building,
                                       fmt::format("129 x 129 texels, {}.", word)));
    m_sections.push_back(std::move(section));
}

void Gallery::ShapesOfTheKernel() {
    GallerySection section{"Box, tent, parabola, disc",
                           "Hensley 2005, sect. 2 (Heckbert's repeated integration); discs: beyond the papers",
                           "One bright texel under each kernel, enlarged 8 times and scaled to its brightest: a box "
                           "of 9 texels, and two and "
                           "three of them in a row, from tables of second and third order in 64-bit integers. Three "
                           "boxes are almost round: "
                           "that is why --shape gauss takes them. A disc is a stack of boxes of equal height.",
                           {},
                           {}};
    constexpr uint32_t kSide = 33, kZoom = 8;
    Picture impulse{kSide, kSide, 3, SampleType::Unorm8, std::vector<float>(3 * kSide * kSide, 0.0f)};
    for (size_t c = 0; c < 3; c++)
        impulse.samples[3 * (kSide * kSide / 2) + c] = 1;
    const Photograph texel(impulse, Transfer::Raw);
    const Photograph zoomed(Picture{kSide * kZoom, kSide * kZoom, 3, SampleType::Unorm8,
                                    std::vector<float>(3 * kSide * kSide * kZoom * kZoom, 0.0f)},
                            Transfer::Raw);
    const auto show = [&](const std::string& file, const Texels& filtered, const std::string& caption) {
        const Texels scaled = Scaled(filtered, glm::vec4(1 / Largest(filtered).r));
        Texels large;
        for (uint32_t y = 0; y < kSide * kZoom; y++)
            for (uint32_t x = 0; x < kSide * kZoom; x++)
                large.push_back(scaled[y / kZoom * kSide + x / kZoom]);
        section.figures.push_back(Save(file, large, zoomed, caption));
    };
    show("kernel_box.png", Filtered(texel, {9, 9}, {.order = 1, .edge = SATEdge::Zero}), "Box, 9 x 9.");
    show("kernel_tent.png", Filtered(texel, {9, 9}, {.order = 2, .edge = SATEdge::Zero}),
         "Tent: two boxes, 17 x 17.");
    show("kernel_parabolic.png", Filtered(texel, {9, 9}, {.order = 3, .edge = SATEdge::Zero}),
         "Parabolic: three, 25 x 25.");
    show("kernel_disc.png", Filtered(texel, {25, 25}, {.boxes = 16, .edge = SATEdge::Zero}),
         "Disc of 16 boxes, 25 x 25.");

    section.figures.push_back(Save("shape_box.png", Filtered(m_fruits, {25, 25}), m_fruits,
                                   "The photograph under a box of 25: edges double, highlights turn to squares."));
    section.figures.push_back(
        Save("shape_gauss.png", Filtered(m_fruits, glm::vec2(1.923f * 7.2f), {.order = 3}), m_fruits,
             "A Gaussian of the same variance, sigma 7.2, as a parabolic kernel 4.2 % from it."));
    m_sections.push_back(std::move(section));
}

void Gallery::WidthsFromAMap() {
    GallerySection section{"A width for every texel",
                           "Crow 1984; Hensley 2005, sect. 2",
                           "The cost does not depend on the width, so each texel may have its own: here discs from 1 "
                           "texel at a third of the height to 60 at the bottom, like a lens turned down on a model.",
                           {},
                           {}};
    Texels widths;
    const Extent2D extent = m_building.Extent();
    for (uint32_t y = 0; y < extent.heightTexels; y++)
        for (uint32_t x = 0; x < extent.widthTexels; x++) {
            const float at = static_cast<float>(y) / static_cast<float>(extent.heightTexels);
            widths.emplace_back(std::min(1.0f, 1.5f * std::abs(at - 0.33f)), 0, 0, 0);
        }
    const Texels filtered =
        Filtered(m_building, {.boxes = 16, .minTexels = glm::vec2(1), .maxTexels = glm::vec2(60)}, widths);
    for (glm::vec4& width : widths)
        width = glm::vec4(glm::vec3(width.r), 1);
    section.figures.push_back(
        Save("map.png", widths, m_building, "The map: black is 1 texel, white 60.", Transfer::Raw));
    section.figures.push_back(Save("map_filtered.png", filtered, m_building, "The photograph under its discs."));
    m_sections.push_back(std::move(section));
}

void Gallery::LensOnAPhotograph() {
    GallerySection section{
        "Depth of field on a photograph",
        "Hensley 2005, sect. 5.4 (Fig. 9)",
        "Each texel under its own circle of confusion, from the photograph's disparity. One table of the whole "
        "picture, so what is sharp bleeds: look "
        "for the green haze round the leaves.",
        {},
        {}};
    const Photograph aloe("aloeL.jpg", boxcar_aloeL_jpg, boxcar_aloeL_jpg_end);
    const Photograph depth("aloeGT.png", boxcar_aloeGT_png, boxcar_aloeGT_png_end, Transfer::Raw);
    std::vector<float> disparity;
    for (const glm::vec4& texel : depth.texels)
        disparity.push_back(texel.r > 0 ? texel.r : NAN);
    FillUnknown(disparity, depth.Extent());
    Texels widths;
    for (const float value : disparity)
        widths.emplace_back(value, value, value, value);
    section.figures.push_back(
        Save("lens_disparity.png", widths, aloe, "Disparity: brighter is nearer; holes filled.", Transfer::Raw));

    Stats stats;
    const Texels focused =
        FocusPicture(m_device, aloe.picture, aloe.name, aloe.transfer,
                     {.lens = {0.5f, 100}, .largestTexels = 60, .boxes = 8}, widths, SampleType::Unorm8, stats);
    section.figures.push_back(
        Save("lens.png", focused, aloe, "Focused on the front leaf and the pot: --focus 0.5 --aperture 100."));
    m_sections.push_back(std::move(section));
}

void Gallery::LinearLightAndCodes() {
    GallerySection section{
        "Linear light and raw codes",
        "beyond the papers",
        "A mean of sRGB codes is not the mean of the light: bright spots on dark ground lose their "
        "energy. The filter works in linear light unless it is told --transfer raw.",
        {},
        {}};
    const Photograph codes("fruits.jpg", boxcar_fruits_jpg, boxcar_fruits_jpg_end, Transfer::Raw);
    section.figures.push_back(
        Save("linear_light.png", Filtered(m_fruits, {33, 33}), m_fruits, "33 x 33 texels in linear light."));
    section.figures.push_back(Save("raw_codes.png", Filtered(codes, {33, 33}), codes,
                                   "33 x 33 texels over the codes: darker.", Transfer::Raw));
    m_sections.push_back(std::move(section));
}

void Gallery::HdrEnvironment() {
    GallerySection section{
        "A high dynamic range environment",
        "Hensley 2005, sect. 5.1",
        "Half-float light, filtered as it stands and shown as v / (1 + v): what glossy reflections are made of.",
        {},
        {}};
    const Photograph city("city.exr", boxcar_city_exr, boxcar_city_exr_end);
    const auto shown = [](Texels texels) {
        for (glm::vec4& texel : texels)
            texel = glm::vec4(glm::vec3(texel) / (1.0f + glm::vec3(texel)), texel.a);
        return texels;
    };
    section.figures.push_back(Save("city_1.png", shown(city.texels), city, "The environment (width 1)."));
    for (const float width : {9.0f, 33.0f})
        section.figures.push_back(Save(fmt::format("city_{:g}.png", width), shown(Filtered(city, {width, width})),
                                       city, fmt::format("{0:g} x {0:g} texels.", width)));
    m_sections.push_back(std::move(section));
}

struct GalleryOptions {
    std::string folder;
    std::string sceneSize = "480x300";
    DeviceOptions device;
};

void MakeGallery(const GalleryOptions& options) {
    const std::string& folder = options.folder;
    ParseExtent(options.sceneSize);  // before any work
    CheckedDevice device(options.device);
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw Error("{}: cannot make this folder: {}", folder, error.message());

    Gallery gallery(*device, folder, options.sceneSize);
    constexpr void (Gallery::*kSections[])() = {&Gallery::PhotographAtSeveralWidths,
                                                &Gallery::StepsOfTheBuild,
                                                &Gallery::TableAsAPicture,
                                                &Gallery::VerbatimAndCorrected,
                                                &Gallery::EdgesOfThePicture,
                                                &Gallery::ShapesOfTheKernel,
                                                &Gallery::WidthsFromAMap,
                                                &Gallery::LensOnAPhotograph,
                                                &Gallery::LinearLightAndCodes,
                                                &Gallery::HdrEnvironment,
                                                &Gallery::SceneEffects,
                                                &Gallery::ThirdOrder,
                                                &Gallery::Precision};
    const bool terminal = isatty(STDERR_FILENO);
    for (size_t i = 0; i < std::size(kSections); i++) {
        if (terminal) fmt::print(stderr, "\r[{}/{}]", i + 1, std::size(kSections));
        (gallery.*kSections[i])();
    }
    if (terminal) fmt::print(stderr, "\r\033[K");
    const std::string page = (std::filesystem::path(folder) / "index.html").string();
    const std::string html = GalleryPage(gallery.Sections(), device->Info().name + ", " + device->Info().driver);
    WriteFileAtomically(page, {reinterpret_cast<const uint8_t*>(html.data()), html.size()});
    device.RequireClean();
    // A script takes the name as it is; a terminal would act on what is in it.
    PrintDocument((isatty(STDOUT_FILENO) ? Printable(page) : page) + "\n");
}

}  // namespace

Command AddGalleryCommand(CLI::App& app) {
    const auto options = std::make_shared<GalleryOptions>();
    CLI::App& command =
        *app.add_subcommand("gallery", "Make the papers' figures as pictures, with a page to look at them");
    command.footer("Example:\n  boxcar gallery -o gallery\n\nPrints the path of the page.");
    command.add_option("-o,--output", options->folder, "Folder; made if it is missing")->required()->type_name("DIR");
    command.add_option("--size", options->sceneSize, "Of the rendered effects")
        ->type_name("WxH")
        ->capture_default_str();
    AddDeviceOptions(command, options->device);
    return {&command, [options] { MakeGallery(*options); }};
}

}  // namespace boxcar
