// Records as JSON and back.
#include "voxc/Measure/Record.h"

#include "Measure/Json.h"
#include "Measure/RecordFields.h"
#include "voxc/Measure/Digest.h"
#include "voxc/Measure/Repeats.h"

#include <algorithm>
#include <cmath>

namespace voxc::measure {
namespace {

constexpr const char *kMeasured = "measured", *kFailed = "failed";

class Writer {
public:
  static constexpr bool isFieldVisitor = true;
  explicit Writer(Json &object) : object_(object) {}

  void required(const char *key, const auto &value) { object_[key] = value; }

  void optional(const char *key, const auto &value) {
    if (value)
      object_[key] = *value;
  }

  template <typename Part> void section(const char *key, const Part &part) {
    Json inner = Json::object();
    Writer writer(inner);
    fields(writer, part, static_cast<const Part *>(nullptr));
    if (!inner.empty())
      object_[key] = std::move(inner);
  }

  void optionalSection(const char *key, const auto &part) {
    if (part)
      section(key, *part);
  }

  void status(const char *key, const std::optional<Failure> &failure) {
    object_[key] = failure ? kFailed : kMeasured;
  }

private:
  Json &object_;
};

bool read(const Json &json, std::string &value) {
  return json.is_string() && (value = json.get<std::string>(), true);
}
bool read(const Json &json, bool &value) { return json.is_boolean() && (value = json.get<bool>(), true); }
bool read(const Json &json, std::uint64_t &value) {
  return json.is_number_unsigned() && (value = json.get<std::uint64_t>(), true);
}
bool read(const Json &json, double &value) {
  return json.is_number() && std::isfinite(value = json.get<double>());
}
template <typename Value> bool read(const Json &json, std::vector<Value> &values) {
  const auto take = [&](const Json &element) { return read(element, values.emplace_back()); };
  return json.is_array() && std::ranges::all_of(json, take);
}
template <std::size_t count> bool read(const Json &json, std::array<std::uint64_t, count> &values) {
  if (!json.is_array() || json.size() != count)
    return false;
  for (std::size_t i = 0; i < count; ++i)
    if (!read(json[i], values[i]))
      return false;
  return true;
}

template <typename Value> bool read(const Json &json, std::optional<Value> &value) {
  return read(json, value.emplace());
}

/// Reads a record; the first thing that is not as it should be is kept.
class Reader {
public:
  static constexpr bool isFieldVisitor = true;
  Reader(const Json &object, std::string where, std::string &problem)
      : object_(object), where_(std::move(where)), problem_(problem) {}

  void required(const char *key, auto &value) {
    const auto entry = object_.find(key);
    if (entry == object_.end())
      complain(key, "is missing");
    else if (!read(*entry, value))
      complain(key, "has a value of another type than the schema says");
  }

  void optional(const char *key, auto &value) {
    const auto entry = object_.find(key);
    // null is as good as absent: a failure may say that it does not know its words.
    if (entry != object_.end() && !entry->is_null())
      required(key, value);
  }

  template <typename Part> void section(const char *key, Part &part) {
    static const Json kNothing = Json::object();
    const auto entry = object_.find(key);
    const Json &inner = entry == object_.end() ? kNothing : *entry;
    if (!inner.is_object())
      return complain(key, "should be an object");
    Reader reader(inner, where_ + key + ".", problem_);
    fields(reader, part, static_cast<const Part *>(nullptr));
  }

  void optionalSection(const char *key, auto &part) {
    if (object_.contains(key))
      section(key, part.emplace());
  }

  void status(const char *key, const std::optional<Failure> &) {
    std::string value;
    required(key, value);
    const bool failed = object_.contains("failure");
    if (problem_.empty() && value != (failed ? kFailed : kMeasured))
      complain(key, failed ? "should be \"failed\", for there is a failure" : "should be \"measured\"");
  }

private:
  void complain(const std::string &key, const std::string &text) {
    if (problem_.empty())
      problem_ = "\"" + where_ + key + "\" " + text;
  }

  const Json &object_;
  std::string where_; ///< The keys that lead here, each with a point behind it.
  std::string &problem_;
};

} // namespace

const std::optional<Speed> &speedOf(const Record &record) {
  return record.device.clock == "gpu" ? record.speed.mraysPerDeviceS : record.speed.mraysPerCpuS;
}

std::optional<Speed> speedOf(std::uint64_t rays, const std::vector<double> &seconds) {
  if (seconds.empty() || std::ranges::min(seconds) <= 0)
    return std::nullopt;
  std::vector<double> speeds;
  speeds.reserve(seconds.size());
  for (const double time : seconds)
    speeds.push_back(static_cast<double>(rays) / time * 1e-6);
  return Speed{std::ranges::min(speeds), median(speeds), std::ranges::max(speeds), spread(speeds)};
}

std::string titleOf(const RaysPart &rays) {
  if (!rays.order)
    return rays.name;
  return rays.name + (*rays.order == "given" ? " as given" : " " + *rays.order);
}

std::string cellDigest(const Record &record) {
  Digest digest;
  digest.add(record.model.name).add(record.model.digest).add(record.format.label).add(record.format.digest);
  for (const std::string &pass : record.format.passes)
    digest.add(pass);
  digest.add(record.precision).add(record.device.name).add(record.device.kind).add(record.device.driver);
  digest.add(std::to_string(record.device.threads.value_or(0))).add(record.rays.digest);
  if (record.rays.order)
    digest.add(*record.rays.order);
  return digest.hex();
}

bool areEqual(const Speed &a, const Speed &b) {
  return std::abs(a.median - b.median) <= std::max(a.max - a.min, b.max - b.min);
}

std::string toLine(const Record &record) {
  Json json{{"schema", kSchema}};
  Writer writer(json);
  fields(writer, record, static_cast<const Record *>(nullptr));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Expected<Record> parseRecord(std::string_view line) {
  const Json json = Json::parse(line, nullptr, false);
  if (!json.is_object())
    return Error::input("a record should be a JSON object");
  if (!json.contains("schema") || json["schema"] != kSchema)
    return Error::input("a record should have \"schema\": " + std::to_string(kSchema) +
                        ", the one that is read");
  Record record;
  std::string problem;
  Reader reader(json, "", problem);
  fields(reader, record, static_cast<const Record *>(nullptr));
  if (!problem.empty())
    return Error::input(problem);
  return record;
}

} // namespace voxc::measure
