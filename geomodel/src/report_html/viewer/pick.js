// SPDX-License-Identifier: MIT
// What lies under a pixel: the nearest triangle on the ray that is not cut away.
function nearestOn(ray, batch, cutting, wall, best) {
  const p = batch.at, [dx, dy, dz] = ray.along;
  for (const r of batch.ranges) {
    if (r.opacity !== undefined && r.opacity < 0.15) continue;
    const ox = ray.from[0], oy = ray.from[1], oz = ray.from[2] - (r.lift || 0);
    for (let n = r.first; n < r.first + r.count; n += 3) {
      const i = 3 * n, ax = p[i], ay = p[i + 1], az = p[i + 2];
      const ux = p[i + 3] - ax, uy = p[i + 4] - ay, uz = p[i + 5] - az, vx = p[i + 6] - ax, vy = p[i + 7] - ay, vz = p[i + 8] - az;
      const hx = dy * vz - dz * vy, hy = dz * vx - dx * vz, hz = dx * vy - dy * vx, det = ux * hx + uy * hy + uz * hz;
      if (det === 0) continue;
      const sx = ox - ax, sy = oy - ay, sz = oz - az, u = (sx * hx + sy * hy + sz * hz) / det;
      if (u < 0 || u > 1) continue;
      const qx = sy * uz - sz * uy, qy = sz * ux - sx * uz, qz = sx * uy - sy * ux, v = (dx * qx + dy * qy + dz * qz) / det;
      if (v < 0 || u + v > 1) continue;
      const t = (vx * qx + vy * qy + vz * qz) / det;
      if (t <= 0 || t >= best.t) continue;
      const at = [ox + t * dx, oy + t * dy, oz + t * dz];
      if (!isCutAway(at, cutting, wall)) best = {t, at, region: r.region, surface: r.surface, row: batch.rows[n], wall};
    }
  }
  return best;
}
/** The region or surface at a pixel with its place; null where there is none. */
function pick(x, y) {
  const ray = rayAt(x, y), cutting = facingPlanes();
  let best = nearestOn(ray, faces, cutting, -1, {t: Infinity});
  best = nearestOn(ray, sheets, cutting, -1, best);
  cutting.forEach((_, i) => { best = nearestOn(ray, walls[i], cutting, i, best); });
  if (best.t === Infinity) return null;
  const q = quantity();
  if (q && best.region) best.value = q.points ? NaN : valueOf(q, (best.wall >= 0 ? q.cells : q.faces)[best.row]);
  return best;
}
