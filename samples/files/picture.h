// Pictures in and out of files. This folder is the only place that knows file formats.
//
// Non-goals: conversion between color spaces (see ColorSpace for what is kept), metadata other than EXIF's rotation,
// animations, EXR layers, reading part of a picture.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace boxcar {

enum class SampleType { Unorm8, Unorm16, Float32 };
enum class FileFormat { Png, Jpeg, Hdr, Exr, Pfm };

// CIE x and y of red, green, blue and white.
using Primaries = std::array<float, 8>;

// What the numbers of a picture mean as colors, where that is not sRGB (float files: linear light of sRGB's
// primaries). Nothing is converted to other primaries: a blur of linear light is right in any, so they are kept as
// they are from file to file.
struct ColorSpace {
    double gamma = 0;                         // light = sample^(1 / gamma), from PNG's gAMA; 0: the sRGB curve
    std::optional<Primaries> primaries = {};  // from PNG's cHRM, EXR's chromaticities, HDR's PRIMARIES
    std::vector<uint8_t> iccProfile = {};     // of PNG and JPEG, for RGB or gray as the picture is
};

// A picture in memory. Values are the file's, as they stand: v / 255, v / 65535 or the float; not linearized, colors
// not multiplied by alpha.
struct Picture {
    uint32_t widthTexels = 0;
    uint32_t heightTexels = 0;
    uint32_t channels = 0;                    // 1 gray, 2 gray and alpha, 3 RGB, 4 RGBA
    SampleType stored = SampleType::Float32;  // how the file holds a sample; EXR and HDR count as Float32
    std::vector<float> samples;               // rows top to bottom, channels interleaved
    ColorSpace colorSpace = {};
    std::vector<std::string> notes = {};  // what of the file is not in the picture, a line each, to follow "PATH: "
};

// What a picture may be at most; looked at in the file's header, before memory for texels is taken.
struct PictureLimits {
    uint32_t maxSideTexels = 16384;
    uint64_t maxBytes = uint64_t{1} << 30;  // of width x height x 16: the picture as one RGBA32F image of a device
};

// Whether the last channel is alpha.
bool HasAlpha(const Picture& picture);

// "PNG", "JPEG", ..
std::string_view FormatName(FileFormat format);

// The format of a name's ending: .png, .jpg, .jpeg, .hdr, .exr or .pfm, in any case. Throws Error: another ending, or
// none.
FileFormat FormatFromName(const std::string& path);

// The same for the bare word, as in `--format png`.
FileFormat FormatFromWord(const std::string& word);

// Reads a picture. The content says which format it is, not the name.
//
//   path    a file, or "-" for standard input
//   format  if given, the content must be that
//
// PNG: all kinds but Apple's CgBI; palettes and 1, 2, 4 bits become 8 bits, tRNS becomes alpha; turned upright as
// eXIf says. Color space: iCCP, else sRGB, else gAMA and cHRM; cICP, and a profile's curve unlike sRGB's, are notes.
//
// JPEG: 8 bits, sequential and progressive, Huffman and arithmetic coding; turned upright as EXIF says. Gray, YCbCr,
// RGB, CMYK and YCCK; the latter two become RGB as (1 - ink) (1 - black), inverted where Adobe's marker is.
//
// HDR: RGBE, flat and in both run-length codings, any orientation; EXPOSURE, COLORCORR and GAMMA are notes.
//
// EXR: flat, scan lines or tiles (the finest level), every compression; channels R G B [A], Y [A], Y RY BY [A] or a
// single one of any name, others are left out; of several parts the first that has them, with a note. The picture is
// the display window: 0 where the file has no data; data outside it are left out, with a note, but not all of them.
//
// PFM: 1 or 3 channels, both byte orders, the scale's size unused. Its header ends with one space character, or with
// spaces up to a line end (CR LF too): where that leaves a doubt, the file's length decides.
//
// Bytes after the picture are no fault.
//
// Throws Error, one line that begins with the path: it cannot be read, is empty, cut off, damaged, of no known
// format, or over a limit. What is returned is a whole picture, but for one case that cannot be told: arithmetic
// coding of JPEG leaves out zeros at the end of its data, so data that break off before an end marker pass for that.
Picture ReadPicture(const std::string& path, const PictureLimits& limits = {}, std::optional<FileFormat> format = {});

// The same from memory; `name` stands for the path in errors.
Picture DecodePicture(std::span<const uint8_t> file, const std::string& name, const PictureLimits& limits = {});

// How `format` holds the samples of a picture that was `stored` so: PNG keeps 16 bits and makes floats 8, JPEG is 8,
// EXR and PFM are float.
SampleType SampleTypeFor(FileFormat format, SampleType stored);

// Throws Error where WritePicture would for this format and number of channels, so that it can be known before the
// work: HDR is not written; JPEG and PFM hold no alpha. The line begins with the path.
void RequireWritable(const std::string& path, FileFormat format, uint32_t channels);

// Whether colors are those of sRGB, but for the gamma.
bool HasSrgbColors(const ColorSpace& space);

// What of `space`, beyond sRGB, a file of `format` cannot hold, as a line to follow "PATH: "; empty where it holds
// all.
std::string LostColorSpace(const ColorSpace& space, FileFormat format);

// Writes a picture: PNG of 8 or 16 bits, JPEG (quality 95, color not subsampled), EXR (32-bit float, ZIP, R G B [A]
// or Y [A]), PFM (little-endian, bottom row first, 1 or 3 channels). Its color space goes along as far as the format
// holds it: PNG iCCP, gAMA and cHRM, JPEG the ICC profile, EXR the chromaticities.
//
//   path        as of WriteFileAtomically, which says when it throws Error
//   sampleType  PNG: Unorm8 or Unorm16; JPEG: Unorm8; EXR and PFM: Float32. For integers samples are clamped to [0,1]
//               and rounded to nearest; NaN becomes 0.
void WritePicture(const Picture& picture, const std::string& path, FileFormat format, SampleType sampleType);

// One channel of whole numbers, rows from the top.
struct UintChannel {
    std::string name;
    std::vector<uint32_t> samples;
};

// Writes an EXR of UINT channels (ZIP). `path` as of WriteFileAtomically, which says when it throws Error.
void WriteUintExr(const std::vector<UintChannel>& channels, uint32_t widthTexels, uint32_t heightTexels,
                  const std::string& path);

}  // namespace boxcar
