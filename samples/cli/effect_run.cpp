#include "samples/cli/effect_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "samples/app/device_run.h"
#include "samples/app/light.h"
#include "samples/cli/console.h"
#include "samples/files/bytes.h"
#include "samples/files/color.h"
#include "samples/scenes/scene.h"
#include "samples/scenes/volumes.h"

namespace boxcar {
namespace {

constexpr double kLargestTime = 1e6;  // scenes move by floats

Environment ReadEnvironment(const std::string& name, bool zeroesNotFinite, std::vector<std::string>& notes) {
    if (name == "city" || name == "studio" || name == "venice") return SampleEnvironment(name);
    Picture picture = ReadPicture(name);
    for (const std::string& note : picture.notes)
        notes.push_back(fmt::format("{}: {}", InputName(name), note));
    if (!HasSrgbColors(picture.colorSpace))
        notes.push_back(fmt::format("{}: its {} not used: its colors are taken for sRGB's", InputName(name),
                                    picture.colorSpace.primaries ? "primaries are" : "ICC profile is"));
    if (zeroesNotFinite) ZeroNotFinite(picture);
    return EnvironmentFrom(std::move(picture), name);
}

MeshData ReadObject(const std::string& name, const std::string& upWord) {
    MeshData mesh = name == "bunny" || name == "teapot" ? SampleMesh(name) : ReadMesh(name);
    return upWord == "z" ? TurnedZUp(std::move(mesh)) : mesh;
}

Volume ReadScan(const std::string& name, const VolumeReading& reading) {
    if (name != "head" && name != "marschner-lobb") return ReadVolume(name, reading);
    if (reading.frame > 0) throw UsageError("--frame {}: {} holds 1 volume, which is number 0", reading.frame, name);
    return SampleVolume(name);
}

uint64_t ParseFrame(const std::string& text) {
    if (text.empty()) return 0;
    uint64_t frame = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), frame);
    if (error != std::errc() || end != text.data() + text.size())
        throw UsageError("--frame {}: expected a whole number, 0 or more", text);
    return frame;
}

EffectInputs InputsOf(const EffectInfo& info, const EffectOptions& options, std::vector<std::string>& notes) {
    EffectInputs inputs;
    if (!options.environment.empty() && !info.takesEnvironment)
        throw UsageError("--env {}: {} has no use for it", options.environment, info.name);
    if (!options.mesh.empty() && !info.takesMesh)
        throw UsageError("--mesh {}: {} has no use for it", options.mesh, info.name);
    if (!options.volume.empty() && !info.takesVolume)
        throw UsageError("--volume {}: {} has no use for it", options.volume, info.name);
    if (!options.volumeFrame.empty() && !info.takesVolume)
        throw UsageError("--frame {}: {} has no use for it", options.volumeFrame, info.name);
    if (options.upWord != "y" && !info.takesMesh)
        throw UsageError("--up {}: {} has no use for it", options.upWord, info.name);
    const bool zeroesNotFinite = options.nanWord == "zero";
    if (zeroesNotFinite && !info.takesVolume && !info.takesEnvironment)
        throw UsageError("--nan zero: {} has no use for it", info.name);
    if (info.takesVolume) {
        const std::string name = options.volume.empty() ? "head" : options.volume;
        inputs.volume = ReadScan(name, {ParseFrame(options.volumeFrame), zeroesNotFinite});
    }
    if (info.takesEnvironment)
        inputs.environment =
            ReadEnvironment(options.environment.empty() ? "venice" : options.environment, zeroesNotFinite, notes);
    if (info.takesMesh) inputs.mesh = ReadObject(options.mesh.empty() ? "bunny" : options.mesh, options.upWord);
    return inputs;
}

ParameterValues ValuesOf(const EffectInfo& info, const std::vector<Setting>& settings) {
    ParameterValues values(info.parameters);
    for (const Setting& setting : settings)
        values.Set(setting.name, setting.value);
    return values;
}

// A value that the volume does not have would make an empty picture.
void RequireIsoWithin(const Volume& volume, float iso) {
    const auto [least, largest] = std::ranges::minmax_element(volume.voxels);
    if (iso < *least || iso > *largest)
        throw UsageError("iso={:g}: the volume holds values from {:g} to {:g}", iso, *least, *largest);
}

// The mean of `side` x `side` samples for each texel of `extent`.
std::vector<glm::vec4> Means(const std::vector<glm::vec4>& samples, Extent2D extent, uint32_t side) {
    if (side == 1) return samples;
    std::vector<glm::vec4> means(extent.Texels(), glm::vec4(0));
    const size_t row = size_t{extent.widthTexels} * side;
    for (size_t i = 0; i < samples.size(); i++)
        means[i / row / side * extent.widthTexels + i % row / side] += samples[i];
    for (glm::vec4& mean : means)
        mean /= static_cast<float>(side * side);
    return means;
}

// --NAME VALUE for --set NAME=VALUE, of every parameter that there is; those of another effect are refused as with
// --set.
void AddParameterOptions(CLI::App& command, EffectOptions& options) {
    std::set<std::string> names;
    for (const EffectInfo& info : Effects())
        for (const Parameter& parameter : info.parameters)
            names.emplace(parameter.name);
    for (const std::string& name : names)
        command
            .add_option_function<std::string>(
                "--" + name,
                [&options, name](const std::string& value) { options.sets.push_back(name + "=" + value); })
            ->group("");
}

float Shown(float light) {
    constexpr float kKnee = 0.7f, kRest = 1 - kKnee;
    return light < kKnee ? light : kKnee + kRest * (1 - std::exp(-(light - kKnee) / kRest));
}

}  // namespace

void AddEffectOptions(CLI::App& command, EffectOptions& options) {
    command.add_option("EFFECT", options.effect, "Name of an effect (boxcar list)")->required();
    command.add_option("--size", options.extent, "Width and height in texels (default 640x360)")->type_name("WxH");
    command.add_option("--time", options.timeSeconds, "Time of the scene, seconds (default 0)")->type_name("S");
    command.add_option("--set", options.sets, "Sets a parameter, as --NAME VALUE does; may come several times")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    command
        .add_option("--env", options.environment,
                    "Light from all around: an equirectangular picture, or city, studio, venice (default)")
        ->type_name("F");
    command
        .add_option(
            "--mesh", options.mesh,
            "Object: an OBJ file, or bunny (default), teapot; made as large as the picture and the scene let it be")
        ->type_name("F");
    command.add_option("--up", options.upWord, "The object's axis that goes up: y (default) or z")
        ->check(CLI::IsMember({"y", "z"}))
        ->type_name("A");
    command
        .add_option("--volume", options.volume,
                    "Volume: a NIfTI file (.nii, or .hdr beside .img; packed or not), or head (default), "
                    "marschner-lobb; it is drawn as the body stands: sform, else qform, else voxel sizes alone")
        ->type_name("F");
    command.add_option("--frame", options.volumeFrame, "Which volume of a series in time; 0 (default) is the first")
        ->type_name("N");
    command
        .add_option("--nan", options.nanWord,
                    "What to do with NaN and infinity in a volume or environment: refuse (default) or zero")
        ->check(CLI::IsMember({"refuse", "zero"}))
        ->type_name("N");
    AddParameterOptions(command, options);
    AddDeviceOptions(command, options.device);
}

void AddSamplesOption(CLI::App& command, EffectOptions& options) {
    command
        .add_option("--samples", options.samples,
                    "Samples along each side of a pixel: 1 (default) to 8; more smooth the edges")
        ->type_name("N");
}

Setting ParseSetting(const std::string& text) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) throw UsageError("--set {}: expected NAME=VALUE", text);
    return {text.substr(0, equals), text.substr(equals + 1)};
}

std::vector<Setting> SettingsOf(const EffectOptions& options) {
    std::vector<Setting> settings;
    for (const std::string& set : options.sets)
        settings.push_back(ParseSetting(set));
    return settings;
}

EffectRun::EffectRun(Device& device, const EffectOptions& options, const std::vector<Setting>& settings)
    : m_device(device),
      m_info(FindEffect(options.effect)),
      m_extent(ParseExtent(options.extent)),
      m_samples(options.samples),
      m_inputs(InputsOf(m_info, options, m_notes)),
      m_values(ValuesOf(m_info, settings)) {
    if (!(std::abs(options.timeSeconds) <= kLargestTime))
        throw UsageError("--time {:g}: expected seconds, at most {:.0f}", options.timeSeconds, kLargestTime);
    if (m_samples < 1 || m_samples > 8) throw UsageError("--samples {}: expected 1 to 8", m_samples);
    if (std::max(m_extent.widthTexels, m_extent.heightTexels) * m_samples > device.Limits().maxSideTexels)
        throw UsageError("--size {} --samples {}: the device draws at most {} samples a side", options.extent,
                         m_samples, device.Limits().maxSideTexels);
    if (m_info.takesVolume) {
        const Volume& volume = m_inputs.volume;
        const std::string name = options.volume.empty() ? "head" : InputName(options.volume);
        RequireIsoWithin(volume, m_values["iso"]);
        m_volumeLine = fmt::format("{}: {}", name, volume.what);
        if (volume.framesInFile > 1 && options.volumeFrame.empty())
            m_notes.push_back(
                fmt::format("{}: {} volumes, of which the first is drawn; --frame 1 to {} draws another", name,
                            volume.framesInFile, volume.framesInFile - 1));
        if (volume.hasShear) m_notes.push_back(fmt::format("{}: its sform shears it; it is drawn without", name));
    }
    m_inputs.extent = {m_samples * m_extent.widthTexels, m_samples * m_extent.heightTexels};
    m_effect = m_info.make(device, m_inputs, m_values);
}

void EffectRun::PrintNotes() const {
    for (const std::string& note : m_notes)
        PrintProblem(note);
}

std::vector<glm::vec4> EffectRun::Samples(double timeSeconds, std::vector<PassTime>* passes) {
    CommandList commands(m_device, passes ? CommandList::Timing::On : CommandList::Timing::Off);
    const Image& image = m_effect->Record(commands, {timeSeconds, m_values});
    commands.SubmitAndWait();
    if (passes) *passes = commands.PassTimes();
    std::vector<glm::vec4> samples = Download<glm::vec4>(m_device, image);
    RequireFiniteSums(samples, std::string(m_info.name));
    return samples;
}

Picture EffectRun::Render(double timeSeconds, SampleType sampleType, std::vector<PassTime>* passes) {
    std::vector<glm::vec4> samples = Samples(timeSeconds, passes);
    if (m_info.isHighRange && sampleType != SampleType::Float32)
        for (glm::vec4& sample : samples)
            sample = {Shown(sample.x), Shown(sample.y), Shown(sample.z), sample.w};
    const Picture like{m_extent.widthTexels, m_extent.heightTexels, 3, SampleType::Float32, {}};
    return FromLight(Means(samples, m_extent, m_samples), like, Transfer::Srgb, sampleType);
}

}  // namespace boxcar
