// Draws a structure in space so that a reader can turn it, look through it and step through its stages. Reads what
// view_in_space.py has put into the page: places as whole numbers of a box, displacements as whole numbers of the largest.
(function () {
  "use strict";
  const view = document.getElementById("view-in-space");
  const data = JSON.parse(document.getElementById("view-in-space-data").textContent);

  function numbers(text, Kind) {
    const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    return new Kind(bytes.buffer);
  }
  const say = (words) => { view.querySelector(".stone").textContent = words; };
  const find = (name) => view.querySelector("[name=" + name + "]");

  const whole = numbers(data.places, Uint16Array);
  const count = whole.length / 3;
  const drawn = new Float32Array(whole.length);
  for (let i = 0; i < whole.length; ++i) drawn[i] = data.least[i % 3] + whole[i] * data.unit;
  const stone = numbers(data.stone_of_node, data.stones > 65535 ? Uint32Array : Uint16Array);
  const Index = count > 65535 ? Uint32Array : Uint16Array;
  const faces = numbers(data.faces, Index), edges = numbers(data.edges, Index);
  const pointNode = numbers(data.points, Index);
  const stages = data.stages.map((s) => Object.assign({}, s, {
    displacement: numbers(s.displacement, Int16Array), status: numbers(s.status, Uint8Array),
    arrows: numbers(s.arrows, Float32Array)}));

  let renderer;
  try {
    renderer = new THREE.WebGLRenderer({antialias: true, alpha: true, preserveDrawingBuffer: true});
  } catch (problem) {
    say("This browser draws no three dimensions (WebGL); the pictures below show the structure.");
    view.querySelector(".controls").style.display = "none";
    return;
  }
  const frame = view.querySelector(".frame");
  frame.appendChild(renderer.domElement);
  const scene = new THREE.Scene();
  const middle = new THREE.Vector3(...data.middle), size = data.size;
  const camera = new THREE.PerspectiveCamera(30, 1.6, size / 100, size * 100);
  camera.up.set(0, 0, 1);
  const seen = new THREE.Vector3(0.55, -1.0, 0.6).normalize();
  camera.position.copy(middle).addScaledVector(seen, 1.7 * size);
  const controls = new THREE.OrbitControls(camera, renderer.domElement);
  controls.target.copy(middle);
  controls.update();
  scene.add(new THREE.AmbientLight(0xffffff, 0.62));
  const sun = new THREE.DirectionalLight(0xffffff, 0.5);
  scene.add(sun);

  // Stones, their edges and their points share one table of places.
  const place = new THREE.BufferAttribute(drawn.slice(), 3);
  const colour = new THREE.BufferAttribute(new Float32Array(3 * count), 3);
  const geometry = (index) => {
    const g = new THREE.BufferGeometry();
    g.setAttribute("position", place);
    if (index) g.setIndex(new THREE.BufferAttribute(index, 1));
    return g;
  };
  const body = geometry(faces);
  body.setAttribute("color", colour);
  const stoneMaterial = new THREE.MeshPhongMaterial({vertexColors: THREE.VertexColors, flatShading: true, side: THREE.DoubleSide,
    shininess: 0, specular: 0x000000, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1});
  const mesh = new THREE.Mesh(body, stoneMaterial);
  scene.add(mesh);
  const lines = new THREE.LineSegments(geometry(edges), new THREE.LineBasicMaterial({color: 0x4a4338}));
  scene.add(lines);
  const asBuilt = new THREE.BufferGeometry();
  asBuilt.setAttribute("position", new THREE.BufferAttribute(drawn, 3));
  asBuilt.setIndex(new THREE.BufferAttribute(edges, 1));
  const ghost = new THREE.LineSegments(asBuilt, new THREE.LineBasicMaterial({color: 0x9a9a9a, transparent: true, opacity: 0.5}));
  scene.add(ghost);
  const kinds = [[data.open, 0xd00000], [data.slip, 0xe69f00], [data.stick, 0x0072b2]].map(([status, paint]) => {
    const points = new THREE.Points(geometry(new Index(0)), new THREE.PointsMaterial({color: paint, size: 5, sizeAttenuation: false}));
    scene.add(points);
    return {status, points};
  });
  let arrows = new THREE.Group();
  scene.add(arrows);

  function paint() {
    const chosen = data.sets[Number(find("set").value)];
    const table = chosen ? chosen.colours : null;
    for (let i = 0; i < count; ++i) {
      const c = table ? data.palette[table[stone[i]]] : data.pale;
      for (let k = 0; k < 3; ++k) colour.array[3 * i + k] = c[k] / 255;
    }
    colour.needsUpdate = true;
  }

  function stage() { return stages[Number(find("stage").value)]; }
  // The slider goes by factors of ten, from none to a hundred times what the pictures use.
  function magnification(s) {
    const at = Number(find("scale").value);
    return at === 0 ? 0 : s.scale * Math.pow(10, (at - 60) / 20);
  }

  let swing = 1;
  function move() {
    const s = stage(), factor = magnification(s) * swing, u = s.displacement, unit = s.largest / 32767;
    for (let i = 0; i < place.array.length; ++i) place.array[i] = drawn[i] + factor * unit * u[i];
    place.needsUpdate = true;
  }

  function show() {
    const s = stage();
    for (const {status, points} of kinds) {
      points.geometry.setIndex(new THREE.BufferAttribute(Index.from(pointNode.filter((_, k) => s.status[k] === status)), 1));
      points.visible = find("points").checked && !(status === data.stick && !find("closed").checked);
    }
    scene.remove(arrows);
    arrows = new THREE.Group();
    for (let k = 0; find("forces").checked && k + 5 < s.arrows.length; k += 6) {
      const force = new THREE.Vector3(s.arrows[k + 3], s.arrows[k + 4], s.arrows[k + 5]), length = force.length();
      if (length === 0) continue;
      const from = new THREE.Vector3(s.arrows[k], s.arrows[k + 1], s.arrows[k + 2]);
      const long = 0.12 * size * length;
      arrows.add(new THREE.ArrowHelper(force.normalize(), from.addScaledVector(force, -long / 2), long, 0x00734f, 0.25 * long, 0.12 * long));
    }
    scene.add(arrows);
    const through = find("through").checked || find("forces").checked;
    stoneMaterial.transparent = through;
    stoneMaterial.opacity = through ? 0.35 : 1;
    stoneMaterial.depthWrite = !through;
    stoneMaterial.needsUpdate = true;
    ghost.visible = find("built").checked;
    const times = magnification(s);
    find("stage-words").textContent = s.words;
    find("scale-words").textContent = s.mechanism ? "motion drawn as large as can be seen" : times === 0 ? "as built"
      : "displacements × " + Number(times.toPrecision(2)).toLocaleString("en").replaceAll(",", " ");
    move();
    draw();
  }

  function draw() {
    sun.position.copy(camera.position);
    renderer.render(scene, camera);
  }

  function fit() {
    const width = frame.clientWidth, height = Math.max(260, Math.min(width * 0.62, 640));
    renderer.setPixelRatio(window.devicePixelRatio || 1);
    renderer.setSize(width, height);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    draw();
  }

  let playing = null, began = 0;
  function play(now) {
    swing = Math.sin((now - began) / 700) ** 2;
    move();
    draw();
    playing = requestAnimationFrame(play);
  }
  find("play").addEventListener("click", () => {
    if (playing !== null) {
      cancelAnimationFrame(playing);
      playing = null;
      swing = 1;
      find("play").textContent = "Move";
      show();
      return;
    }
    find("play").textContent = "Stop";
    began = performance.now();
    playing = requestAnimationFrame(play);
  });

  // Which stone is it? A click that did not turn the view asks.
  let pressed = null;
  renderer.domElement.addEventListener("pointerdown", (e) => { pressed = [e.clientX, e.clientY]; });
  renderer.domElement.addEventListener("pointerup", (e) => {
    if (!pressed || Math.hypot(e.clientX - pressed[0], e.clientY - pressed[1]) > 4) return;
    const box = renderer.domElement.getBoundingClientRect();
    const at = new THREE.Vector2(2 * (e.clientX - box.left) / box.width - 1, 1 - 2 * (e.clientY - box.top) / box.height);
    const ray = new THREE.Raycaster();
    ray.setFromCamera(at, camera);
    body.computeBoundingSphere();
    const hit = ray.intersectObject(mesh)[0];
    if (!hit) return say("");
    const b = stone[hit.face.a], s = stage(), x = [0, 0, 0], u = [0, 0, 0];
    let nodes = 0;
    for (let i = 0; i < count; ++i)
      if (stone[i] === b) {
        ++nodes;
        for (let k = 0; k < 3; ++k) { x[k] += drawn[3 * i + k]; u[k] += s.displacement[3 * i + k] * s.largest / 32767; }
      }
    const text = (v, digits) => v.map((c) => Number((c / nodes).toPrecision(digits))).join(", ");
    const sets = data.sets.filter((set) => set.name && set.members.includes(b)).map((set) => set.name);
    say("Stone " + b + (sets.length ? " (" + sets.join(", ") + ")" : "") + " about (" + text(x, 4) + ") m"
        + (s.mechanism ? "" : ", moved by (" + text(u, 3) + ") m"));
  });
  for (const name of ["stage", "scale", "set", "points", "closed", "forces", "through", "built"])
    find(name).addEventListener("input", () => { if (name === "set") paint(); show(); });
  find("home").addEventListener("click", () => { controls.reset(); draw(); });
  controls.saveState();
  controls.addEventListener("change", draw);
  window.addEventListener("resize", fit);
  find("stage").value = String(stages.length - 1);
  if (stages.length < 2) find("stage").parentElement.style.display = "none";
  paint();
  show();
  fit();
  view.dataset.ready = "yes";
})();
