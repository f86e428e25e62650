#include "samples/cli/effect_figures.h"

#include <fmt/format.h>

#include "samples/cli/effect_run.h"

namespace boxcar {
namespace {

struct EffectFigure {
    std::string_view effect;
    std::string_view caption;
    std::string_view loads;  // a pixel of the effect's last pass
    std::vector<Setting> settings = {};
    std::string_view environment = "";
    std::string_view mesh = "";
    uint32_t samples = 2;  // along a pixel's side, so that edges look well; times are for one
};

const EffectFigure kFigures[] = {
    {"glossy-environment", "Four boxes one in the other, 24 texels wide.", "128 of two words"},
    {"glossy-environment",
     "The width from a texture (Fig. 5); moving objects are drawn into the cube map.",
     "128 of two words",
     {{"gloss", "texture"}, {"source", "scene"}, {"width", "40"}},
     "city"},
    {"glossy-environment",
     "One box of four corners a face (Fig. 6).",
     "32 of two words",
     {{"lobe", "box"}},
     "city",
     "teapot"},
    {"glossy-environment",
     "A tent: tables of second order.",
     "72 of two words",
     {{"lobe", "tent"}},
     "city",
     "teapot"},
    {"glossy-environment",
     "A parabolic kernel: tables of third order.",
     "128 of two words",
     {{"lobe", "parabolic"}},
     "city",
     "teapot"},
    {"glossy-environment",
     "As printed: floats, one size in texels, every texel alike. Noise in the dark, for the lamps are in every sum.",
     "32",
     {{"lobe", "papers"}, {"width", "4"}, {"source", "scene"}},
     "studio"},
    {"glossy-environment",
     "The same by cones of one size on the sphere, in integers.",
     "32 of two words",
     {{"lobe", "box"}, {"width", "4"}, {"source", "scene"}},
     "studio"},
    {"phong-environment", "Two boxes on the normal, two on the reflection (Fig. 7).", "128 of two words"},
    {"phong-environment",
     "Six of each, a sharper highlight.",
     "384 of two words",
     {{"boxes", "6"}, {"exponent", "300"}},
     "city",
     "teapot"},
    {"paraboloid-direct",
     "Two triangles a wall: lines that should be curves are straight.",
     "1",
     {{"subdivisions", "0"}}},
    {"paraboloid-direct", "Each cut in four four times over: cured.", "1", {{"subdivisions", "4"}}},
    {"planar-reflection", "A ray's cone as wide as 0.12 of its length.", "17"},
    {"planar-reflection", "Three times as rough.", "17", {{"roughness", "0.36"}}, "", "teapot"},
    {"translucency", "Three objects, each over a table of what is behind it.", "17"},
    {"translucency", "Etched more.", "17", {{"etching", "0.3"}}, "", "teapot"},
    {"depth-of-field", "Seven layers of depth on either side of the focus.", "at most 480", {{"lens", "0.4"}}},
    {"depth-of-field",
     "One table of the picture: the sharp bunny glows into the background, near things have hard rims.",
     "128",
     {{"lens", "0.4"}, {"method", "single"}}},
    {"depth-of-field", "A mip map.", "8", {{"lens", "0.4"}, {"method", "mips"}}},
    {"depth-of-field",
     "A mip map looked up at random places round the pixel: noise instead of blocks.",
     "8",
     {{"lens", "0.4"}, {"method", "noise"}}},
    {"depth-of-field", "256 views from all over the lens.", "256", {{"lens", "0.4"}, {"method", "accumulation"}}},
    {"depth-of-field", "In layers, focused behind.", "at most 480", {{"lens", "0.4"}, {"focus", "12"}}},
};

double Milliseconds(const std::vector<PassTime>& passes) {
    double sum = 0;
    for (const PassTime& pass : passes)
        sum += pass.milliseconds;
    return sum;
}

}  // namespace

void AddEffectSections(Device& device, const std::filesystem::path& folder, std::vector<GallerySection>& sections) {
    for (const EffectInfo& info : Effects()) {
        GallerySection section{std::string(info.what),
                               fmt::format("{}: boxcar render {}", info.paper, info.name),
                               fmt::format("Look for this: {}.", info.lookFor),
                               {},
                               {}};
        for (const EffectFigure& figure : kFigures) {
            if (figure.effect != info.name) continue;
            EffectOptions options;
            options.effect = info.name;
            options.extent = "480x300";
            options.environment = figure.environment;
            options.mesh = figure.mesh;
            std::vector<PassTime> passes;
            EffectRun timed(device, options, figure.settings);
            timed.Render(0, SampleType::Unorm8);  // shaders are compiled when first used
            timed.Render(0, SampleType::Unorm8, &passes);
            options.samples = figure.samples;
            const Picture picture = EffectRun(device, options, figure.settings).Render(0, SampleType::Unorm8);
            const std::string file = fmt::format("{}_{}.png", info.name, section.figures.size());
            WritePicture(picture, (folder / file).string(), FileFormat::Png, SampleType::Unorm8);
            section.figures.push_back({file, fmt::format("{} {:.0f} ms a frame; {} loads a pixel.", figure.caption,
                                                         Milliseconds(passes), figure.loads)});
        }
        sections.push_back(std::move(section));
    }
}

}  // namespace boxcar
