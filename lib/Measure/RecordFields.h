// The keys of a record, once: the same list is traversed to write a record and to read it.
#pragma once

#include "voxc/Measure/Record.h"

namespace voxc::measure {

/// How `fields` tells of each member: `required` is always there, `optional` only if it has a value, and a
/// `section` is an object whose members follow.
template <typename T>
concept FieldVisitor = requires(T &visitor) { visitor.isFieldVisitor; };

void fields(FieldVisitor auto &v, auto &model, const ModelPart *) {
  v.required("name", model.name);
  v.required("input", model.input);
  v.required("digest", model.digest);
  v.optional("size", model.size);
  v.optional("voxels", model.voxels);
  v.optional("picture", model.picture);
}

void fields(FieldVisitor auto &v, auto &format, const FormatPart *) {
  v.required("label", format.label);
  v.required("name", format.name);
  v.required("passes", format.passes);
  v.required("digest", format.digest);
}

void fields(FieldVisitor auto &v, auto &device, const DevicePart *) {
  v.required("name", device.name);
  v.required("kind", device.kind);
  v.required("driver", device.driver);
  v.optional("threads", device.threads);
  v.required("clock", device.clock);
}

void fields(FieldVisitor auto &v, auto &rays, const RaysPart *) {
  v.required("name", rays.name);
  v.required("kind", rays.kind);
  v.required("count", rays.count);
  v.optional("size", rays.size);
  v.required("digest", rays.digest);
  v.optional("order", rays.order);
}

void fields(FieldVisitor auto &v, auto &failure, const Failure *) {
  v.required("stage", failure.stage);
  v.required("reason", failure.reason);
  v.optional("words", failure.words);
}

void fields(FieldVisitor auto &v, auto &volume, const VolumePart *) {
  v.optional("words", volume.words);
  v.optional("bytes", volume.bytes);
  v.optional("bytes_per_voxel", volume.bytesPerVoxel);
  v.optional("file_bytes", volume.fileBytes);
  v.optional("level_words", volume.levelWords);
}

void fields(FieldVisitor auto &v, auto &predicted, const PredictedPart *) {
  v.optional("words", predicted.words);
  v.optional("mrays_per_s", predicted.mraysPerS);
  v.optional("turns", predicted.turns);
  v.optional("lines", predicted.lines);
}

void fields(FieldVisitor auto &v, auto &build, const BuildPart *) {
  v.optional("load_seconds", build.loadSeconds);
  v.optional("compile_seconds", build.compileSeconds);
  v.optional("build_seconds", build.buildSeconds);
  v.optional("build_cpu_seconds", build.buildCpuSeconds);
  v.optional("write_seconds", build.writeSeconds);
  v.optional("peak_rss_bytes", build.peakRssBytes);
}

void fields(FieldVisitor auto &v, auto &kernel, const KernelPart *) {
  v.optional("compile_seconds", kernel.compileSeconds);
  v.optional("upload_seconds", kernel.uploadSeconds);
  v.optional("first_dispatch_seconds", kernel.firstDispatchSeconds);
}

void fields(FieldVisitor auto &v, auto &speed, const Speed *) {
  v.required("min", speed.min);
  v.required("median", speed.median);
  v.required("max", speed.max);
  v.required("spread", speed.spread);
}

void fields(FieldVisitor auto &v, auto &speed, const SpeedPart *) {
  v.optional("rounds", speed.rounds);
  v.optionalSection("mrays_per_s", speed.mraysPerS);
  v.optionalSection("mrays_per_cpu_s", speed.mraysPerCpuS);
  v.optionalSection("mrays_per_device_s", speed.mraysPerDeviceS);
  v.optional("steady", speed.steady);
  v.optional("order", speed.order);
}

void fields(FieldVisitor auto &v, auto &work, const WorkPart *) {
  v.optional("hits", work.hits);
  v.optional("rays", work.rays);
  v.optional("steps_per_ray", work.stepsPerRay);
  v.optional("words_per_ray", work.wordsPerRay);
}

void fields(FieldVisitor auto &v, auto &error, const ErrorPart *) {
  v.optional("rays", error.rays);
  v.optional("missed", error.missed);
  v.optional("ghost", error.ghost);
  v.optional("wrong", error.wrong);
  v.optional("boundary", error.boundary);
  v.optional("colour", error.colour);
  v.optional("max_dt", error.maxDt);
  v.optional("rms_dt", error.rmsDt);
  v.optional("max_ulp_dt", error.maxUlpDt);
}

void fields(FieldVisitor auto &v, auto &madeBy, const MadeByPart *) {
  v.required("voxc", madeBy.voxc);
  v.required("llvm", madeBy.llvm);
  v.required("processor", madeBy.processor);
  v.optional("cores", madeBy.cores);
  v.required("command", madeBy.command);
}

/// Sections that may be empty are left out then.
void fields(FieldVisitor auto &v, auto &record, const Record *) {
  v.required("cell", record.cell);
  v.section("model", record.model);
  v.section("format", record.format);
  v.optional("resolution", record.resolution);
  v.required("precision", record.precision);
  v.section("device", record.device);
  v.section("rays", record.rays);
  v.status("status", record.failure);
  v.optionalSection("failure", record.failure);
  v.section("volume", record.volume);
  v.section("build", record.build);
  v.section("kernel", record.kernel);
  v.section("speed", record.speed);
  v.section("work", record.work);
  v.section("error", record.error);
  v.optionalSection("predicted", record.predicted);
  v.section("made_by", record.madeBy);
}

} // namespace voxc::measure
