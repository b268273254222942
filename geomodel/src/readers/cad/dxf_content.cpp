// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/cad/dxf_content.hpp"

#include <algorithm>
#include <cmath>

#include "readers/text/text.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double most_copied = 20e6;  // points and copies
constexpr std::size_t most_nested = 64;

/// Transforms points of an inserted DXF block to one of its copies, in one column and row.
class Placing {
 public:
  Placing(const DxfInsert& insert, const Vec3& base, std::int64_t column, std::int64_t row)
      : insert_(insert),
        base_(base),
        cos_(std::cos(insert.rotation)),
        sin_(std::sin(insert.rotation)),
        shift_{static_cast<double>(column) * insert.column_step, static_cast<double>(row) * insert.row_step, 0} {
    if (insert.rotation == 0) cos_ = 1, sin_ = 0;
  }
  bool mirrors() const { return insert_.scale.x * insert_.scale.y * insert_.scale.z < 0; }
  Vec3 point(const Vec3& p) const {
    Vec3 q = p - base_;
    for (std::size_t k = 0; k < 3; ++k) q[k] = q[k] * insert_.scale[k] + shift_[k];
    return insert_.at + Vec3{cos_ * q.x - sin_ * q.y, sin_ * q.x + cos_ * q.y, q.z};
  }
  std::vector<Vec3> points(const std::vector<Vec3>& given) const {
    std::vector<Vec3> placed;
    for (const Vec3& p : given) placed.push_back(point(p));
    return placed;
  }

 private:
  const DxfInsert& insert_;
  Vec3 base_;
  double cos_, sin_;
  Vec3 shift_;
};

class Inserter {
 public:
  Inserter(const InputFile& file, const std::map<std::string, DxfBlock>& blocks) : file_(file), blocks_(blocks) {}

  DxfContent expand(const DxfContent& content) {
    DxfContent all = content;
    all.inserts.clear();
    for (const DxfInsert& insert : content.inserts) {
      const auto block = blocks_.find(insert.block);
      if (block == blocks_.end()) {
        ++all.passed_over["INSERT of the block " + in_quotes(insert.block) + ", which is not in the file,"];
        continue;
      }
      if (std::find(open_.begin(), open_.end(), insert.block) != open_.end() || open_.size() == most_nested)
        file_.fail(insert.line,
                   "the block " + in_quotes(insert.block) + " holds itself, or blocks are nested without end");
      open_.push_back(insert.block);
      const DxfContent inner = expand(block->second.content);
      open_.pop_back();
      count_copies(inner, insert);
      for (std::int64_t row = 0; row < insert.n_rows; ++row)
        for (std::int64_t column = 0; column < insert.n_columns; ++column)
          copy(inner, Placing(insert, block->second.base, column, row), insert, all);
    }
    return all;
  }

 private:
  /// Counts the copies of a DXF block before any is made, because a few bytes can request an unlimited number.
  void count_copies(const DxfContent& inner, const DxfInsert& insert) {
    double n = 1;
    for (const auto& [layer, corners] : inner.corners) n += static_cast<double>(corners.size());
    for (const auto& [layer, points] : inner.lines) n += static_cast<double>(points.size());
    for (const auto& [layer, points] : inner.points) n += static_cast<double>(points.size());
    n_copied_ += n * static_cast<double>(insert.n_columns) * static_cast<double>(insert.n_rows);
    if (n_copied_ > most_copied)
      file_.fail(insert.line, "inserted blocks would make more than " +
                                  std::to_string(static_cast<std::size_t>(most_copied)) + " points");
  }

  void copy(const DxfContent& inner, const Placing& placing, const DxfInsert& insert, DxfContent& all) {
    const auto layer_of = [&](const std::string& layer) { return layer == "0" ? insert.layer : layer; };
    for (const auto& [layer, corners] : inner.corners) {
      std::vector<Vec3> placed = placing.points(corners);
      if (placing.mirrors())
        for (std::size_t i = 0; i + 2 < placed.size(); i += 3) std::swap(placed[i + 1], placed[i + 2]);
      std::vector<Vec3>& target = all.corners[layer_of(layer)];
      target.insert(target.end(), placed.begin(), placed.end());
    }
    for (const auto& [layer, points] : inner.lines) all.lines.emplace_back(layer_of(layer), placing.points(points));
    for (const auto& [layer, points] : inner.points)
      for (const Vec3& p : points) all.points[layer_of(layer)].push_back(placing.point(p));
    for (const auto& [name, n] : inner.passed_over) all.passed_over[name] += n;
  }

  const InputFile& file_;
  const std::map<std::string, DxfBlock>& blocks_;
  std::vector<std::string> open_;  ///< names of the DXF blocks that are being expanded, outermost first
  double n_copied_ = 0;
};

}  // namespace

void insert_blocks(const InputFile& file, DxfContent& content, const std::map<std::string, DxfBlock>& blocks) {
  if (!content.inserts.empty()) content = Inserter(file, blocks).expand(content);
}

}  // namespace geomesh::geomodel
