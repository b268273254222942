// SPDX-License-Identifier: MIT
// WebGL: triangles and lines, lit from above, with the mesh's edges where these do not run together.
const gl = canvas.getContext("webgl2", {antialias: true, preserveDrawingBuffer: true});
const vertexText = `#version 300 es
in vec3 at; in vec4 ink; uniform mat4 view; uniform vec3 focus; uniform float up, lift, nearer; out vec3 tint, place, world, corner;
void main() {
  place = at; world = vec3(at.xy - focus.xy, (at.z + lift - focus.z) * up); tint = ink.rgb;
  gl_Position = view * vec4(world, 1.0); gl_Position.z -= nearer * gl_Position.w;
  int k = gl_VertexID % 3, hide = int(ink.a * 255.0 + 0.5);
  corner = vec3(k == 0, k == 1, k == 2) + vec3((hide & 1) / 1, (hide & 2) / 2, (hide & 4) / 4);
}`;
// Of plane[0] and plane[1] the part beyond both is cut away; wall >= 0 draws that plane's own cut, which is there alone.
const fragmentText = `#version 300 es
precision highp float; in vec3 tint, place, world, corner; out vec4 colour;
uniform vec4 plane[2]; uniform int planes, wall; uniform vec3 right, back; uniform float lines, shaded, opacity, glow, dense, slack;
void main() {
  bool first = planes > 0 && dot(plane[0].xyz, place) > plane[0].w + slack, second = planes < 2 || dot(plane[1].xyz, place) > plane[1].w + slack;
  if (wall < 0 ? first && second : wall == 0 ? !second : !first) discard;
  vec3 n = normalize(cross(dFdx(world), dFdy(world)));
  if (dot(n, back) < 0.0) n = -n;
  float light = mix(1.0, min(1.0, 0.83 + 0.17 * n.z - 0.11 * dot(n, right)), shaded);
  vec3 w = max(fwidth(corner), vec3(1e-6)), e = smoothstep(vec3(0.3), vec3(1.3), corner / w / dense);
  float height = 3.0 / (w.x + w.y + w.z) / dense, dark = lines * 0.42 * clamp((height - 3.0) / 22.0, 0.0, 1.0);
  colour = vec4(mix(tint, vec3(1.0), 0.22 * glow) * light * mix(1.0 - dark, 1.0, min(min(e.x, e.y), e.z)), opacity);
}`;
let program = null;
const places = {};
const uniform = name => places[name] || (places[name] = gl.getUniformLocation(program, name));
function setUpPaint() {
  const shader = (type, text) => {
    const s = gl.createShader(type);
    gl.shaderSource(s, text); gl.compileShader(s);
    if (!gl.getShaderParameter(s, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(s));
    return s;
  };
  program = gl.createProgram();
  gl.attachShader(program, shader(gl.VERTEX_SHADER, vertexText));
  gl.attachShader(program, shader(gl.FRAGMENT_SHADER, fragmentText));
  gl.linkProgram(program); gl.useProgram(program);
  gl.enable(gl.DEPTH_TEST); gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
}

/** Vertices with places and inks, in ranges that are drawn with one lift and one opacity; `rows` says what each triangle is part of. */
class Batch {
  constructor(type) { this.type = type; this.at = new Float32Array(3 * 1024); this.ink = new Uint8Array(4 * 1024); this.rows = new Int32Array(1024); this.begin(); }
  begin() { this.count = 0; this.ranges = []; }
  range(about) { this.ranges.push(Object.assign({first: this.count, count: 0}, about)); }
  add(x, y, z, tint, hide, row) {
    if (3 * this.count === this.at.length)
      for (const key of ["at", "ink", "rows"]) { const more = new this[key].constructor(2 * this[key].length); more.set(this[key]); this[key] = more; }
    const n = this.count++;
    this.at[3 * n] = x; this.at[3 * n + 1] = y; this.at[3 * n + 2] = z;
    this.ink[4 * n] = tint[0]; this.ink[4 * n + 1] = tint[1]; this.ink[4 * n + 2] = tint[2]; this.ink[4 * n + 3] = hide;
    this.rows[n] = row; ++this.ranges[this.ranges.length - 1].count;
  }
  point(v, tint, row) { this.add(points[3 * v], points[3 * v + 1], points[3 * v + 2], tint, 0, row); }
  /** To the graphics card. */
  end() {
    if (!this.place) { this.place = gl.createBuffer(); this.colour = gl.createBuffer(); }
    for (const [buffer, data] of [[this.place, this.at.subarray(0, 3 * this.count)], [this.colour, this.ink.subarray(0, 4 * this.count)]]) { gl.bindBuffer(gl.ARRAY_BUFFER, buffer); gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW); }
  }
  draw(ranges, how) {
    if (!ranges.length) return;
    for (const [name, buffer, size, type, share] of [["at", this.place, 3, gl.FLOAT, false], ["ink", this.colour, 4, gl.UNSIGNED_BYTE, true]]) {
      const where = gl.getAttribLocation(program, name);
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer); gl.enableVertexAttribArray(where); gl.vertexAttribPointer(where, size, type, share, 0, 0);
    }
    gl.uniform1i(uniform("wall"), how.wall === undefined ? -1 : how.wall);
    for (const key of ["nearer", "lines", "shaded", "slack"]) gl.uniform1f(uniform(key), how[key] || 0);
    for (const r of ranges) {
      gl.uniform1f(uniform("lift"), r.lift || 0); gl.uniform1f(uniform("opacity"), r.opacity === undefined ? 1 : r.opacity); gl.uniform1f(uniform("glow"), r.glow ? 1 : 0);
      gl.drawArrays(this.type, r.first, r.count);
    }
  }
}
