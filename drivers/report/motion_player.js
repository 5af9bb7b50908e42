// Draws the motion of a structure step by step: motion_player.py says what the numbers are.
(() => {
  const data = JSON.parse(document.getElementById("motion-data").textContent);
  const root = document.getElementById("motion"), canvas = root.querySelector("canvas"), pen = canvas.getContext("2d");
  const control = (name) => root.querySelector("[name=" + name + "]"), words = root.querySelector("output");
  const numbers = (text, Kind) => new Kind(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer);
  const Index = data.index === 4 ? Uint32Array : Uint16Array;
  const places = numbers(data.places, Uint16Array), corners = numbers(data.corners, Index), counts = numbers(data.counts, Uint32Array);
  const colour = numbers(data.colour, Uint8Array), edges = numbers(data.edges, Index), ends = numbers(data.ends, Index);
  const pieces = numbers(data.pieces, Uint32Array);
  const frames = data.frames.map((frame) => ({ ...frame, u: numbers(frame.u, Int16Array), open: numbers(frame.open, Uint8Array) }));
  const x = new Float64Array(places.length), built = new Float64Array(places.length);
  const [left, right, bottom, top] = data.box;
  const longest = Math.max(...frames.flatMap((frame) => frame.arrows.map((arrow) => Math.hypot(arrow[2], arrow[3]))), 1e-300);
  let shown = frames.length - 1, playing = 0, drawnAt = 0;

  const magnification = () => data.scale * Math.pow(10, (control("scale").value - 50) / 50);
  const rounded = (value) => value >= 10 ? Math.round(value).toLocaleString("en").replaceAll(",", " ") : value.toPrecision(2);

  function line(of, a, b) { pen.moveTo(of[2 * a], of[2 * a + 1]); pen.lineTo(of[2 * b], of[2 * b + 1]); }

  function place(frame, factor, to, unit) {
    for (let k = 0; k < places.length; k += 2) {
      to[k] = (data.least[0] + data.unit * places[k] + factor * data.largest * (frame ? frame.u[k] : 0) - left) * unit;
      to[k + 1] = (top - data.least[1] - data.unit * places[k + 1] - factor * data.largest * (frame ? frame.u[k + 1] : 0)) * unit;
    }
  }

  function fill() {
    let at = 0;
    for (let k = 0; k < counts.length; ++k) {
      pen.beginPath();
      for (let n = 0; n < counts[k]; ++n, ++at) pen.lineTo(x[2 * corners[at]], x[2 * corners[at] + 1]);
      pen.closePath();
      pen.fillStyle = data.colours[colour[k]];
      pen.fill();
    }
  }

  function arrow([ax, ay, fx, fy], unit, thick) {
    const force = Math.hypot(fx, fy), length = 0.1 * (right - left) * unit * force / longest;
    const tip = [(ax - left) * unit, (top - ay) * unit], way = [fx / force, -fy / force], head = 6 * thick;
    const tail = [tip[0] - length * way[0], tip[1] - length * way[1]];
    pen.beginPath();
    pen.moveTo(...tail);
    pen.lineTo(...tip);
    for (const side of [-0.5, 0.5]) {
      pen.moveTo(...tip);
      pen.lineTo(tip[0] - head * (way[0] + side * way[1]), tip[1] - head * (way[1] - side * way[0]));
    }
    pen.stroke();
  }

  function draw() {
    const ratio = window.devicePixelRatio || 1, width = Math.max(1, canvas.parentElement.clientWidth);
    const unit = Math.min(width / (right - left), 560 / (top - bottom)) * ratio, thick = ratio;
    canvas.width = Math.round((right - left) * unit);
    canvas.height = Math.round((top - bottom) * unit);
    canvas.style.width = canvas.width / ratio + "px";
    const frame = frames[shown], factor = magnification();
    place(frame, factor, x, unit);
    place(null, 0, built, unit);
    pen.lineCap = "round";
    pen.lineWidth = 0.6 * thick;
    pen.strokeStyle = "#8c8c8c";
    pen.beginPath();
    for (let k = 0; k < edges.length; k += 2) line(built, edges[k], edges[k + 1]);
    pen.stroke();
    fill();
    pen.strokeStyle = "#6f6655";
    pen.beginPath();
    for (let k = 0; k < edges.length; k += 2) line(x, edges[k], edges[k + 1]);
    pen.stroke();
    pen.strokeStyle = "#c8321e";
    pen.lineWidth = 2 * thick;
    pen.beginPath();
    const middle = (point, c) => (x[2 * ends[2 * point] + c] + x[2 * ends[2 * point + 1] + c]) / 2;
    for (let k = 0; k < pieces.length; k += 2) {
      const [a, b] = [pieces[k], pieces[k + 1]], half = [(middle(a, 0) + middle(b, 0)) / 2, (middle(a, 1) + middle(b, 1)) / 2];
      for (const point of [a, b]) if (frame.open[point]) { pen.moveTo(middle(point, 0), middle(point, 1)); pen.lineTo(...half); }
    }
    pen.stroke();
    pen.strokeStyle = "#0072b2";
    for (const force of frame.arrows) arrow(force, unit, thick);
    control("frame").value = shown;
    words.textContent = frame.words + "; drawn × " + rounded(factor);
  }

  function stop() {
    playing = 0;
    control("play").textContent = "Play";
  }
  function step(by) {
    stop();
    shown = (shown + by + frames.length) % frames.length;
    draw();
  }
  function tick(now) {
    if (!playing) return;
    if (now - drawnAt >= 1000 * data.seconds) {
      drawnAt = now;
      if (shown + 1 >= frames.length) stop();
      else { ++shown; draw(); }
    }
    requestAnimationFrame(tick);
  }
  control("play").addEventListener("click", () => {
    if (playing) return stop();
    if (shown + 1 >= frames.length) shown = 0;
    playing = 1;
    drawnAt = performance.now();
    control("play").textContent = "Stop";
    draw();
    requestAnimationFrame(tick);
  });
  control("back").addEventListener("click", () => step(-1));
  control("on").addEventListener("click", () => step(1));
  control("frame").addEventListener("input", () => { stop(); shown = Number(control("frame").value); draw(); });
  control("scale").addEventListener("input", draw);
  window.addEventListener("resize", draw);
  window.addEventListener("beforeprint", draw);
  draw();
  root.dataset.drawn = "yes";
})();
