// SPDX-License-Identifier: GPL-3.0-or-later
"use strict";
(function () {
  const root = document.getElementById("viewer"), model = JSON.parse(document.getElementById("model").textContent);
  const bytes = text => Uint8Array.from(atob(text), c => c.charCodeAt(0)).buffer;
  const points = new Float32Array(bytes(model.points)), corners = new Uint32Array(bytes(model.corners)), sides = new Int32Array(bytes(model.sides));
  const canvas = root.querySelector("canvas"), list = root.querySelector(".list"), stretch = root.querySelector("input[type=range]");
  const gl = canvas.getContext("webgl2", {antialias: true});
  if (!gl) { root.querySelector(".hint").textContent = "This browser has no WebGL 2: the turnable picture cannot be drawn."; return; }

  const shader = (type, text) => {
    const s = gl.createShader(type);
    gl.shaderSource(s, text); gl.compileShader(s);
    if (!gl.getShaderParameter(s, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(s));
    return s;
  };
  const program = gl.createProgram();
  gl.attachShader(program, shader(gl.VERTEX_SHADER, `#version 300 es
    in vec3 at; in vec3 ink; uniform mat4 view; uniform vec3 undo; out vec3 tint, place, corner;
    void main() {
      gl_Position = view * vec4(at, 1.0); place = gl_Position.xyz * undo; tint = ink;
      int k = gl_VertexID % 3; corner = vec3(k == 0, k == 1, k == 2);
    }`));
  gl.attachShader(program, shader(gl.FRAGMENT_SHADER, `#version 300 es
    precision highp float; in vec3 tint, place, corner; out vec4 colour; uniform float lines;
    void main() {
      vec3 n = normalize(cross(dFdx(place), dFdy(place)));
      vec3 w = fwidth(corner), e = smoothstep(vec3(0.0), 1.2 * w, corner);
      float edge = mix(1.0, min(min(e.x, e.y), e.z), lines);
      colour = vec4(tint * (0.45 + 0.55 * abs(n.z)) * mix(0.55, 1.0, edge), 1.0);
    }`));
  gl.linkProgram(program);
  gl.useProgram(program);
  gl.enable(gl.DEPTH_TEST);
  const place = gl.createBuffer(), ink = gl.createBuffer();
  const attribute = (name, buffer, type, normalised) => {
    const where = gl.getAttribLocation(program, name);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(where);
    gl.vertexAttribPointer(where, 3, type, normalised, 0, 0);
  };
  attribute("at", place, gl.FLOAT, false);
  attribute("ink", ink, gl.UNSIGNED_BYTE, true);

  const rgb = text => [1, 3, 5].map(i => parseInt(text.slice(i, i + 2), 16));
  const shownRegions = new Set(model.regions.map(r => r.id)), shownSurfaces = new Set();
  const colourOf = new Map(model.regions.concat(model.surfaces).map(x => [x.id, rgb(x.colour)]));
  let count = 0;
  function build() {
    const at = [], colours = [];
    for (let f = 0; f < corners.length / 3; ++f) {
      const [surface, minus, plus] = sides.subarray(3 * f, 3 * f + 3);
      const a = shownRegions.has(minus), b = shownRegions.has(plus);
      let tint = null;
      if (shownSurfaces.has(surface)) tint = colourOf.get(surface);
      else if (a !== b) tint = colourOf.get(a ? minus : plus);
      if (!tint) continue;
      for (let k = 0; k < 3; ++k) {
        const v = 3 * corners[3 * f + k];
        at.push(points[v], points[v + 1], points[v + 2]);
        colours.push(tint[0], tint[1], tint[2]);
      }
    }
    count = at.length / 3;
    gl.bindBuffer(gl.ARRAY_BUFFER, place); gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(at), gl.STATIC_DRAW);
    gl.bindBuffer(gl.ARRAY_BUFFER, ink); gl.bufferData(gl.ARRAY_BUFFER, new Uint8Array(colours), gl.STATIC_DRAW);
    draw();
  }

  let turn = -0.6, tilt = 0.45, zoom = 1;
  const lines = root.querySelector("input[name=lines]");
  function draw() {
    const w = canvas.clientWidth, h = canvas.clientHeight, dense = window.devicePixelRatio || 1;
    canvas.width = w * dense; canvas.height = h * dense;
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(0.97, 0.97, 0.96, 1); gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const up = Number(stretch.value), s = model.size;
    const half = 0.5 * Math.hypot(s[0], s[1], s[2] * up) || 1, f = zoom / half, across = h / w;
    const c = Math.cos(turn), d = Math.sin(turn), e = Math.cos(tilt), g = Math.sin(tilt);
    gl.uniformMatrix4fv(gl.getUniformLocation(program, "view"), false, [
      f * across * c, f * d * g, f * 0.2 * d * e, 0, -f * across * d, f * c * g, f * 0.2 * c * e, 0, 0, f * e * up, -f * 0.2 * g * up, 0, 0, 0, 0, 1]);
    gl.uniform3f(gl.getUniformLocation(program, "undo"), 1 / across, 1, 5);
    gl.uniform1f(gl.getUniformLocation(program, "lines"), lines.checked ? 1 : 0);
    gl.drawArrays(gl.TRIANGLES, 0, count);
  }

  const title = text => { const h = document.createElement("h3"); h.textContent = text; list.append(h); };
  const entry = (item, shown) => {
    const label = document.createElement("label"), box = document.createElement("input"), swatch = document.createElement("i");
    box.type = "checkbox"; box.checked = shown.has(item.id); swatch.style.background = item.colour;
    box.onchange = () => { if (box.checked) shown.add(item.id); else shown.delete(item.id); build(); };
    label.append(box, swatch, item.name); list.append(label);
  };
  title("Units"); model.regions.forEach(r => entry(r, shownRegions));
  title("Surfaces"); model.surfaces.forEach(s => entry(s, shownSurfaces));
  stretch.value = model.stretch; stretch.max = Math.max(10, 2 * model.stretch);
  stretch.oninput = draw; lines.onchange = draw;
  canvas.onpointermove = e => {
    if (!e.buttons) return;
    turn -= e.movementX * 0.01; tilt = Math.max(-1.57, Math.min(1.57, tilt + e.movementY * 0.01)); draw();
  };
  canvas.addEventListener("wheel", e => { e.preventDefault(); zoom *= Math.exp(-e.deltaY * 0.001); draw(); }, {passive: false});
  window.addEventListener("resize", draw);
  build();
})();
