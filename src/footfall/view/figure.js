// One player: a take on a canvas, and the labels around it.

class Player {
  constructor(figure, take) {
    this.take = take;
    this.canvas = figure.querySelector("canvas");
    this.slip = figure.querySelector(".slip");
    this.badges = [...figure.querySelectorAll(".foot")];
    this.gl = this.canvas.getContext("webgl2", { alpha: false, antialias: true, stencil: true });
    if (!this.gl) {
      this.canvas.insertAdjacentHTML("afterend",
        '<p class="broken">This browser offers no WebGL 2; the pictures below show the same.</p>');
      return;
    }
    this.build();
  }

  build() {
    const gl = this.gl;
    const mesh = data.mesh;
    this.body = program(gl, BODY_VERTEX(this.take.joints), BODY_FRAGMENT);
    this.bodyArray = gl.createVertexArray();
    gl.bindVertexArray(this.bodyArray);
    attribute(gl, this.body, "position", unpack(mesh.positions, Int16Array), 3, gl.SHORT);
    attribute(gl, this.body, "normal", unpack(mesh.normals, Int8Array), 3, gl.BYTE);
    attribute(gl, this.body, "joint", unpack(mesh.joints, Uint8Array), 1, gl.UNSIGNED_BYTE);
    attribute(gl, this.body, "tone", unpack(mesh.tones, Uint8Array), 1, gl.UNSIGNED_BYTE);
    attribute(gl, this.body, "other", unpack(mesh.others, Uint8Array), 1, gl.UNSIGNED_BYTE);
    attribute(gl, this.body, "share", unpack(mesh.shares, Uint8Array), 1, gl.UNSIGNED_BYTE);
    this.rest = Float32Array.from(unpack(mesh.rest, Int16Array));
    const triangles = unpack(mesh.triangles, Uint16Array);
    this.count = triangles.length;
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, triangles, gl.STATIC_DRAW);
    this.ground = program(gl, GROUND_VERTEX, GROUND_FRAGMENT);
    this.groundArray = gl.createVertexArray();
    gl.bindVertexArray(this.groundArray);
    attribute(gl, this.ground, "corner", new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]), 2, gl.FLOAT);
    this.mark = program(gl, MARK_VERTEX, MARK_FRAGMENT);
    this.marks = groundMarks(this.take);
    this.markArray = gl.createVertexArray();
    gl.bindVertexArray(this.markArray);
    attribute(gl, this.mark, "place", this.marks.places, 2, gl.FLOAT);
    attribute(gl, this.mark, "paint", this.marks.paints, 4, gl.FLOAT);
    gl.bindVertexArray(null);
  }

  // State of a foot at a time: whether it is commanded to carry, and how it slides.
  foot(side, time) {
    const { supports } = this.take;
    const symbol = supports[clamp(Math.floor(time * data.rate), 0, supports.length - 1)];
    const at = clamp(Math.round(time * data.rate), 0, this.take.slid.length / 2 - 1);
    const slid = this.take.slid[2 * at + side] / 1e4;
    const before = this.take.slid[2 * Math.max(at - 4, 0) + side] / 1e4;
    const speed = Math.max(0, slid - before) * data.rate / 4;
    return {
      down: symbol === "D" || symbol === (side ? "R" : "L"),
      sliding: clamp((speed - 0.08) / 0.15, 0, 1),
      slid,
    };
  }

  draw(time, camera) {
    const feet = [this.foot(0, time), this.foot(1, time)];
    this.label(time, feet);
    if (!this.gl) return;
    const gl = this.gl;
    const scale = Math.min(window.devicePixelRatio || 1, 2);
    const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight].map(
      (size) => Math.max(1, Math.round(size * scale)));
    if (this.canvas.width !== width || this.canvas.height !== height) {
      Object.assign(this.canvas, { width, height });
    }
    const frame = clamp(time * this.take.fps, 0, this.take.frames - 1);
    const base = Math.floor(frame);
    const center = [this.take.centers[2 * base], this.take.centers[2 * base + 1]];
    const target = [center[0], 0.82, center[1]];
    const eye = [
      target[0] + camera.distance * Math.cos(camera.pitch) * Math.sin(camera.yaw),
      target[1] + camera.distance * Math.sin(camera.pitch),
      target[2] + camera.distance * Math.cos(camera.pitch) * Math.cos(camera.yaw)];
    const view = times(perspective(0.6, width / height, 0.05, 120), lookAt(eye, target));
    gl.viewport(0, 0, width, height);
    gl.clearColor(...rgb(css("--sky")), 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    this.drawGround(view, center);
    this.drawMarks(view, time);
    this.drawBody(view, eye, this.pose(frame), feet);
  }

  drawGround(view, center) {
    const gl = this.gl;
    gl.useProgram(this.ground.made);
    gl.uniformMatrix4fv(this.ground.at("view"), false, view);
    gl.uniform2fv(this.ground.at("center"), center);
    for (const name of ["ground", "grid", "sky"]) {
      gl.uniform3fv(this.ground.at(name), rgb(css(`--${name}`)));
    }
    gl.bindVertexArray(this.groundArray);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
  }

  drawMarks(view, time) {
    const gl = this.gl;
    gl.useProgram(this.mark.made);
    gl.uniformMatrix4fv(this.mark.at("view"), false, view);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    gl.disable(gl.DEPTH_TEST);
    gl.bindVertexArray(this.markArray);
    gl.drawArrays(gl.TRIANGLES, 0, this.marks.until(time * data.rate));
    gl.enable(gl.DEPTH_TEST);
    gl.depthMask(true);
    gl.disable(gl.BLEND);
  }

  drawBody(view, eye, pose, feet) {
    const gl = this.gl;
    const at = this.body.at;
    gl.useProgram(this.body.made);
    gl.uniformMatrix4fv(at("view"), false, view);
    gl.uniform1f(at("unit"), data.mesh.unit);
    gl.uniform4fv(at("turned"), pose.turned);
    gl.uniform3fv(at("placed"), pose.placed);
    gl.uniform3fv(at("rest"), this.rest);
    gl.uniform3fv(at("light"), LIGHT);
    gl.uniform3fv(at("eye"), eye);
    gl.uniform3fv(at("tones"), TONES.flat());
    const slip = rgb(css("--slip"));
    const flash = 0.8 + 0.2 * Math.cos(performance.now() / 60);
    const glow = feet.map((foot, side) => {
      if (foot.sliding > 0.05) return [...slip, (0.55 + 0.45 * foot.sliding) * flash];
      return [...rgb(css(side ? "--right" : "--left")), foot.down ? 1 : 0];
    });
    gl.uniform4fv(at("glow"), glow.flat());
    gl.bindVertexArray(this.bodyArray);
    gl.enable(gl.STENCIL_TEST);
    gl.stencilFunc(gl.EQUAL, 0, 255);
    gl.stencilOp(gl.KEEP, gl.KEEP, gl.INCR);
    gl.enable(gl.BLEND);
    gl.uniform1i(at("flat_"), 1);
    gl.drawElements(gl.TRIANGLES, this.count, gl.UNSIGNED_SHORT, 0);
    gl.disable(gl.STENCIL_TEST);
    gl.disable(gl.BLEND);
    gl.uniform1i(at("flat_"), 0);
    gl.drawElements(gl.TRIANGLES, this.count, gl.UNSIGNED_SHORT, 0);
  }

  // Joints between two frames: places linearly, rotations the short way round.
  pose(frame) {
    const { joints, frames, roots, places, rotations } = this.take;
    const base = Math.min(Math.floor(frame), frames - 1);
    const next = Math.min(base + 1, frames - 1);
    const share = frame - base;
    const turned = new Float32Array(4 * joints);
    const placed = new Float32Array(3 * joints);
    for (let j = 0; j < joints; j++) {
      const [a, b] = [4 * (base * joints + j), 4 * (next * joints + j)];
      let cosine = 0;
      for (let i = 0; i < 4; i++) cosine += rotations[a + i] * rotations[b + i];
      const sign = cosine < 0 ? -share : share;
      for (let i = 0; i < 4; i++) {
        turned[4 * j + i] = ((1 - share) * rotations[a + i] + sign * rotations[b + i]) / 32767;
      }
      for (let i = 0; i < 3; i++) {
        const at = (f) => roots[3 * f + i] + places[3 * (f * joints + j) + i] * data.mesh.unit;
        placed[3 * j + i] = (1 - share) * at(base) + share * at(next);
      }
    }
    return { turned, placed };
  }

  label(time, feet) {
    const at = clamp(Math.round(time * data.rate), 0, this.take.slid.length / 2 - 1);
    const total = this.take.total[at];
    this.slip.innerHTML = `planted feet have slid <b>${(100 * total).toFixed(0)} cm</b>`;
    this.slip.classList.toggle("bad", total > 0.15);
    feet.forEach((foot, side) => {
      this.badges[side].classList.toggle("down", foot.down);
      this.badges[side].classList.toggle("slides", foot.down && foot.sliding > 0.05);
    });
  }
}
