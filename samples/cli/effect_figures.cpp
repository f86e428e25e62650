#include "samples/cli/effect_figures.h"

#include <fmt/format.h>

#include <cmath>

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
    bool hasPsnr = false;
    std::string_view volume = "";
    std::string_view extent = "";  // of its own
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
     "studio",
     "",
     1},
    {"glossy-environment",
     "The same by cones of one size on the sphere, in integers.",
     "32 of two words",
     {{"lobe", "box"}, {"width", "4"}, {"source", "scene"}},
     "studio",
     "",
     1},
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
    {"soft-shadow", "A lamp half a unit wide, seven away.", "80 of two words"},
    {"soft-shadow", "Three times as wide.", "80 of two words", {{"light-size", "1.5"}}},
    {"soft-shadow", "The same map, one texel of it.", "1", {{"method", "hard"}}},
    {"texture-filtering",
     "The nearest texel.",
     "1",
     {{"scene", "ellipsoid"}, {"filter", "nearest"}},
     "",
     "",
     1,
     true},
    {"texture-filtering",
     "A mip map of plain means, trilinear.",
     "8",
     {{"scene", "ellipsoid"}, {"filter", "mip"}},
     "",
     "",
     1,
     true},
    {"texture-filtering",
     "Up to 16 samples of the mip map along the footprint.",
     "up to 128",
     {{"scene", "ellipsoid"}, {"filter", "anisotropic"}},
     "",
     "",
     1,
     true},
    {"texture-filtering",
     "One table, the rectangle round the footprint.",
     "16",
     {{"scene", "ellipsoid"}, {"filter", "table"}},
     "",
     "",
     1,
     true},
    {"texture-filtering",
     "256 samples a pixel.",
     "256",
     {{"scene", "ellipsoid"}, {"filter", "reference"}},
     "",
     "",
     1,
     false},
    {"texture-filtering", "The nearest texel.", "1", {{"scene", "planes"}, {"filter", "nearest"}}, "", "", 1, true},
    {"texture-filtering", "Four texels.", "4", {{"scene", "planes"}, {"filter", "bilinear"}}, "", "", 1, true},
    {"texture-filtering",
     "A mip map of plain means, trilinear.",
     "8",
     {{"scene", "planes"}, {"filter", "mip"}},
     "",
     "",
     1,
     true},
    {"texture-filtering",
     "A mip map of weighted means, trilinear.",
     "8",
     {{"scene", "planes"}, {"filter", "mip-filtered"}},
     "",
     "",
     1,
     true},
    {"texture-filtering",
     "Up to 16 samples of the mip map along the footprint.",
     "up to 128",
     {{"scene", "planes"}, {"filter", "anisotropic"}},
     "",
     "",
     1,
     true},
    {"texture-filtering",
     "One table, the rectangle round the footprint.",
     "16",
     {{"scene", "planes"}, {"filter", "table"}},
     "",
     "",
     1,
     true},
    {"texture-filtering",
     "256 samples a pixel.",
     "256",
     {{"scene", "planes"}, {"filter", "reference"}},
     "",
     "",
     1,
     false},
    {"depth-of-field", "Seven layers of depth on either side of the focus.", "at most 480", {{"lens", "0.4"}}},
    {"depth-of-field",
     "One table of the picture: the sharp bunny glows into the background, near things have hard rims.",
     "128",
     {{"lens", "0.4"}, {"method", "single"}}},
    {"depth-of-field", "Three levels of a mip map combined.", "24", {{"lens", "0.4"}, {"method", "mips"}}},
    {"depth-of-field",
     "A mip map looked up at random places round the pixel: noise instead of blocks.",
     "8",
     {{"lens", "0.4"}, {"method", "noise"}}},
    {"depth-of-field",
     "256 views from all over the lens.",
     "256",
     {{"lens", "0.4"}, {"method", "accumulation"}},
     "",
     "",
     1},
    {"depth-of-field", "In layers, focused behind.", "at most 480", {{"lens", "0.4"}, {"focus", "12"}}},
    {.effect = "isosurface",
     .caption = "The signal of Marschner and Lobb, trilinear (Fig. 20-4).",
     .loads = "1 a step and 19",
     .settings = {{"filter", "trilinear"}, {"iso", "127.5"}, {"elevation", "45"}},
     .volume = "marschner-lobb"},
    {.effect = "isosurface",
     .caption = "The same, tricubic.",
     .loads = "8 a step and 64",
     .settings = {{"iso", "127.5"}, {"elevation", "45"}},
     .volume = "marschner-lobb"},
    {.effect = "isosurface",
     .caption = "A brain, trilinear, 640 x 480.",
     .loads = "1 a step and 19",
     .settings = {{"filter", "trilinear"}},
     .extent = "640x480"},
    {.effect = "isosurface", .caption = "Tricubic, 640 x 480.", .loads = "8 a step and 64", .extent = "640x480"},
    {.effect = "isosurface",
     .caption = "Trilinear, near.",
     .loads = "1 a step and 19",
     .settings = {{"filter", "trilinear"}, {"zoom", "5"}}},
    {.effect = "isosurface", .caption = "Tricubic, near.", .loads = "8 a step and 64", .settings = {{"zoom", "5"}}},
    {.effect = "isosurface",
     .caption = "A color for each pair of curvatures, of gradient and Hessian on the fly (Fig. 20-5).",
     .loads = "8 a step and 64",
     .settings = {{"shade", "curvature"}}},
    {.effect = "isosurface",
     .caption = "The larger curvature: red where it bends outwards, blue where even it bends inwards.",
     .loads = "8 a step and 64",
     .settings = {{"shade", "maximum"}}},
    {.effect = "isosurface",
     .caption = "Ridges light, valleys dark.",
     .loads = "8 a step and 64",
     .settings = {{"shade", "ridges"}}},
};

// Of the texture alone, against 256 samples a pixel: light is divided out (alpha is that of white), and pixels on the
// silhouette, which have a neighbour without any, take no part. Peak 1.
double PsnrOfTexture(Device& device, EffectOptions options, std::vector<Setting> settings) {
    const std::vector<glm::vec4> texels = EffectRun(device, options, settings).Samples(0);
    settings.push_back({"filter", "reference"});
    EffectRun run(device, options, settings);
    const std::vector<glm::vec4> reference = run.Samples(0);
    const auto [width, height] = run.Extent();
    double sum = 0, count = 0;
    for (size_t i = width + 1; i + width + 1 < texels.size(); i++) {
        bool isCovered = true;
        for (const size_t neighbour : {i - width - 1, i - width + 1, i + width - 1, i + width + 1})
            isCovered = isCovered && texels[neighbour].a > 0 && texels[i].a > 0;
        if (!isCovered) continue;
        sum += std::pow(texels[i].g / texels[i].a - reference[i].g / reference[i].a, 2);
        count++;
    }
    return -10 * std::log10(sum / count);
}

double Milliseconds(const std::vector<PassTime>& passes) {
    double sum = 0;
    for (const PassTime& pass : passes)
        sum += pass.milliseconds;
    return sum;
}

}  // namespace

void AddEffectSections(Device& device, const std::filesystem::path& folder, const std::string& size,
                       std::vector<GallerySection>& sections) {
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
            options.extent = figure.extent.empty() ? size : figure.extent;
            options.environment = figure.environment;
            options.mesh = figure.mesh;
            options.volume = figure.volume;
            std::vector<PassTime> passes;
            EffectRun timed(device, options, figure.settings);
            timed.Render(0, SampleType::Unorm8);  // shaders are compiled when first used
            Picture picture = timed.Render(0, SampleType::Unorm8, &passes);
            options.samples = figure.samples;
            if (figure.samples > 1)
                picture = EffectRun(device, options, figure.settings).Render(0, SampleType::Unorm8);
            const std::string file = fmt::format("{}_{}.png", info.name, section.figures.size());
            std::string caption = fmt::format("{} {:.0f} ms a frame; {} loads a pixel.", figure.caption,
                                              Milliseconds(passes), figure.loads);
            if (figure.hasPsnr) {
                options.samples = 1;
                caption += fmt::format(" PSNR {:.1f} dB.", PsnrOfTexture(device, options, figure.settings));
            }
            section.figures.push_back(SaveFigure(folder, file, picture, caption));
        }
        sections.push_back(std::move(section));
    }
}

}  // namespace boxcar
