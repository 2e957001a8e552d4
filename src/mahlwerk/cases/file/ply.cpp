// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

#include "mahlwerk/base/text.hpp"
#include "mahlwerk/cases/file/mesh_file.hpp"

namespace mahlwerk::cases {
namespace {

enum class Encoding { ascii, little, big };

struct ScalarType {
  std::array<std::string_view, 2> names;
  std::size_t size;  // [bytes]
  char kind;         // 'i' signed, 'u' unsigned, 'f' floating point
};
constexpr ScalarType scalar_types[] = {
    {{"char", "int8"}, 1, 'i'},     {{"uchar", "uint8"}, 1, 'u'},   {{"short", "int16"}, 2, 'i'},
    {{"ushort", "uint16"}, 2, 'u'}, {{"int", "int32"}, 4, 'i'},     {{"uint", "uint32"}, 4, 'u'},
    {{"float", "float32"}, 4, 'f'}, {{"double", "float64"}, 8, 'f'}};

struct Property {
  std::string_view name;
  const ScalarType* type = nullptr;
  const ScalarType* count = nullptr;  // of a list; null: one number

  bool is_number(std::string_view called) const { return count == nullptr && name == called; }
  bool is_corners() const {
    return count != nullptr && (name == "vertex_indices" || name == "vertex_index");
  }
};
struct Element {
  std::string_view name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

const ScalarType& type_called(std::string_view name) {
  for (const ScalarType& type : scalar_types)
    if (name == type.names[0] || name == type.names[1]) return type;
  throw MeshFileError(fmt::format("its header has the type \"{}\"", name.substr(0, 40)));
}

/// Words and numbers of a PLY file, one after the other.
class PlyData {
 public:
  explicit PlyData(std::string_view bytes) : bytes_(bytes) {}

  std::string_view line() {
    if (at_ >= bytes_.size()) throw MeshFileError("it is cut off in its header");
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    const std::string_view found = trimmed(bytes_.substr(at_, end - at_));
    at_ = end + 1;
    return found;
  }
  std::size_t left() const { return bytes_.size() - std::min(at_, bytes_.size()); }
  double number(const ScalarType& type, Encoding encoding) {
    return encoding == Encoding::ascii ? written() : binary(type, encoding);
  }

 private:
  double written() {
    const std::size_t from = bytes_.find_first_not_of(" \t\r\n", std::min(at_, bytes_.size()));
    if (from == std::string_view::npos) throw MeshFileError("it is cut off");
    const std::size_t end = std::min(bytes_.find_first_of(" \t\r\n", from), bytes_.size());
    at_ = end;
    double value = 0;
    const auto [stop, error] = std::from_chars(bytes_.data() + from, bytes_.data() + end, value);
    if (error != std::errc{} || stop != bytes_.data() + end)
      throw MeshFileError(fmt::format("\"{}\" is not a number",
                                      bytes_.substr(from, std::min<std::size_t>(end - from, 40))));
    return value;
  }
  double binary(const ScalarType& type, Encoding encoding) {
    if (at_ + type.size > bytes_.size()) throw MeshFileError("it is cut off");
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < type.size; ++k) {
      const std::size_t from = encoding == Encoding::little ? type.size - 1 - k : k;
      bits = bits << 8 | static_cast<unsigned char>(bytes_[at_ + from]);
    }
    at_ += type.size;
    if (type.kind == 'f')
      return type.size == 4
                 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
                 : std::bit_cast<double>(bits);
    const std::size_t bytes = std::max<std::size_t>(type.size, 1);
    const std::uint64_t sign = std::uint64_t{1} << (8 * bytes - 1);
    if (type.kind == 'i' && (bits & sign) != 0)
      return -static_cast<double>((~bits + 1) & ((sign << 1) - 1));
    return static_cast<double>(bits);
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
};

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return words;
}

struct PlyHeader {
  std::optional<Encoding> encoding;
  std::vector<Element> elements;
};

void add_property(PlyHeader& header, const std::vector<std::string_view>& words) {
  if (header.elements.empty()) throw MeshFileError("its header has a property of no element");
  Property property;
  if (words.size() == 5 && words[1] == "list")
    property = {words[4], &type_called(words[3]), &type_called(words[2])};
  else if (words.size() == 3)
    property = {words[2], &type_called(words[1]), nullptr};
  else
    throw MeshFileError("its header has a property without type or name");
  header.elements.back().properties.push_back(property);
}

void read_format(PlyHeader& header, const std::vector<std::string_view>& words) {
  if (header.encoding) throw MeshFileError("its header has two lines \"format\"");
  if (words.size() == 3 && words[2] == "1.0") {
    if (words[1] == "ascii") header.encoding = Encoding::ascii;
    if (words[1] == "binary_little_endian") header.encoding = Encoding::little;
    if (words[1] == "binary_big_endian") header.encoding = Encoding::big;
  }
  if (header.encoding) return;
  std::string said;
  for (std::size_t k = 1; k < words.size(); ++k)
    said += (k > 1 ? " " : "") + std::string(words[k].substr(0, 40));
  throw MeshFileError(
      fmt::format("its format is \"{}\", not \"ascii 1.0\", \"binary_little_endian 1.0\" or "
                  "\"binary_big_endian 1.0\"",
                  said));
}

void add_element(PlyHeader& header, const std::vector<std::string_view>& words) {
  std::size_t count = 0;
  const auto [end, error] =
      std::from_chars(words[2].data(), words[2].data() + words[2].size(), count);
  if (error != std::errc{} || end != words[2].data() + words[2].size())
    throw MeshFileError("its header has an element without a number");
  header.elements.push_back({words[1], count, {}});
}

/// Refuses an element of which the file is too short for as many as its header gives, and one that
/// cannot be a vertex or a face. A number has a digit and a blank in ASCII, a list at least its
/// count.
void check_element(const Element& element, Encoding encoding, std::size_t left) {
  std::size_t least = 0;  // [bytes] of one
  for (const Property& property : element.properties) {
    const ScalarType* type = property.count != nullptr ? property.count : property.type;
    least += encoding == Encoding::ascii ? 2 : type->size;
  }
  const std::size_t ended = left + 1;  // the last number of an ASCII file needs no blank
  if (least > 0 && element.count > ended / least)
    throw MeshFileError(
        fmt::format("its header gives {} of the element \"{}\", more than its length has room for",
                    element.count, element.name.substr(0, 40)));
  if (element.name == "vertex")
    for (const std::string_view axis : {"x", "y", "z"}) {
      const auto times = std::ranges::count_if(
          element.properties, [&](const Property& p) { return p.is_number(axis); });
      if (times != 1)
        throw MeshFileError(fmt::format("its vertices have {} {} instead of one each of x, y and z",
                                        times == 0 ? "no" : "several", axis));
    }
  if (element.name == "face" &&
      std::ranges::count_if(element.properties, &Property::is_corners) != 1)
    throw MeshFileError("its faces have not one list \"vertex_indices\"");
}

PlyHeader read_header(PlyData& data) {
  PlyHeader header;
  data.line();  // ply
  for (;;) {
    const std::vector<std::string_view> words = words_of(data.line());
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header") return header;
    if (words[0] == "format") {
      read_format(header, words);
    } else if (words[0] == "element" && words.size() == 3) {
      add_element(header, words);
    } else if (words[0] == "property") {
      add_property(header, words);
    } else {
      throw MeshFileError(fmt::format("its header has the line \"{}\"", words[0].substr(0, 40)));
    }
  }
}

std::int64_t whole(double value, const std::string& what) {
  if (!(value >= 0 && value <= 1e15) || value != std::floor(value))
    throw MeshFileError(fmt::format("{} is not a whole number", what));
  return static_cast<std::int64_t>(value);
}

/// The numbers of a property of one vertex or face.
std::vector<double> numbers_of(PlyData& data, const Property& property, Encoding encoding) {
  std::size_t count = 1;
  if (property.count != nullptr)
    count = static_cast<std::size_t>(whole(data.number(*property.count, encoding), "a count"));
  std::vector<double> all;
  for (std::size_t k = 0; k < count; ++k) all.push_back(data.number(*property.type, encoding));
  return all;
}

void read_vertex(PlyData& data, const Element& element, Encoding encoding, PolygonList& polygons) {
  Vec3 p;
  for (const Property& property : element.properties) {
    const std::vector<double> numbers = numbers_of(data, property, encoding);
    if (property.is_number("x")) p.x = numbers[0];
    if (property.is_number("y")) p.y = numbers[0];
    if (property.is_number("z")) p.z = numbers[0];
  }
  if (!std::isfinite(p.x + p.y + p.z))
    throw MeshFileError(
        fmt::format("vertex {} has a coordinate that is not a number", polygons.vertices() + 1));
  polygons.add_vertex(p.x, p.y, p.z);
}

void read_face(PlyData& data, const Element& element, Encoding encoding, std::size_t number,
               PolygonList& polygons) {
  const std::string what = fmt::format("face {}", number);
  for (const Property& property : element.properties) {
    const std::vector<double> numbers = numbers_of(data, property, encoding);
    if (!property.is_corners()) continue;
    std::vector<std::int64_t> corners;
    for (const double n : numbers) corners.push_back(whole(n, "a corner of " + what));
    polygons.add_polygon(corners, what);
  }
}

}  // namespace

std::vector<geometry::Corners> read_ply(std::string_view bytes, double scale) {
  PlyData data(bytes);
  const PlyHeader header = read_header(data);
  if (!header.encoding) throw MeshFileError("its header has no line \"format\"");
  const Encoding encoding = *header.encoding;
  PolygonList polygons(scale);
  for (const Element& element : header.elements) {
    check_element(element, encoding, data.left());
    if (element.properties.empty()) continue;
    for (std::size_t i = 0; i < element.count; ++i) {
      if (element.name == "vertex")
        read_vertex(data, element, encoding, polygons);
      else if (element.name == "face")
        read_face(data, element, encoding, i + 1, polygons);
      else
        for (const Property& property : element.properties) numbers_of(data, property, encoding);
    }
  }
  return std::move(polygons).triangles();
}

}  // namespace mahlwerk::cases
