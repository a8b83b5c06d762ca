// Replays: a canvas that shows a run at a moment, and controls to choose both.
for (const box of document.querySelectorAll(".replay")) {
  const { parts, runs } = JSON.parse(box.querySelector("script").textContent);
  const canvas = box.querySelector("canvas");
  const slider = box.querySelector("input[type=range]");
  const button = box.querySelector("button");
  const clock = box.querySelector("output");
  const speed = box.querySelector("select[name=speed]");
  const choice = box.querySelector("select[name=run]");  // null where there is one run
  const layers = [...box.querySelectorAll("input[type=checkbox]")];
  const shown = (name) => layers.some((input) => input.name === name && input.checked);
  // Beside what is called dynamic, which has the colour that maps have for it, scans are grey.
  const labelled = runs.some((one) => "labels" in one);
  const kColors = { truth: "#009e73", estimate: "#0072b2", odometry: "#e69f00", scan: labelled ? "#555555" : "#d55e00", dynamic: "#e67800" };
  const kOfTracks = ["#882255", "#332288", "#117733", "#aa4499", "#44aa99", "#999933"];
  const kTrail = 5;  // [s]

  // The last index whose stamp is not after t; -1 before the first.
  const index = (stamps, t) => {
    let low = 0, high = stamps.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (stamps[middle] <= t) low = middle + 1; else high = middle;
    }
    return low - 1;
  };
  const turn = (a) => Math.atan2(Math.sin(a), Math.cos(a));
  // Where a track is at a moment; null where it does not know.
  const pose = (track, t) => {
    if (!track || track.t.length === 0) return null;
    const i = index(track.t, t);
    if (i < 0 || (i === track.t.length - 1 && t > track.t[i] + 0.5)) return null;
    if (i === track.t.length - 1) return { x: track.x[i], y: track.y[i], a: track.a[i] };
    const fraction = (t - track.t[i]) / Math.max(track.t[i + 1] - track.t[i], 1e-9);
    return { x: track.x[i] + fraction * (track.x[i + 1] - track.x[i]),
             y: track.y[i] + fraction * (track.y[i + 1] - track.y[i]),
             a: track.a[i] + fraction * turn(track.a[i + 1] - track.a[i]) };
  };

  // What is to be seen of a run, in metres.
  const boundsOf = (run) => {
    const bounds = { x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity };
    const include = (x, y) => {
      bounds.x0 = Math.min(bounds.x0, x); bounds.x1 = Math.max(bounds.x1, x);
      bounds.y0 = Math.min(bounds.y0, y); bounds.y1 = Math.max(bounds.y1, y);
    };
    for (const line of run.outlines || []) for (let i = 0; i < line.length; i += 2) include(line[i], line[i + 1]);
    if (run.map) { include(run.map.x, run.map.y); include(run.map.x + run.map.width, run.map.y + run.map.height); }
    for (const name of ["truth", "estimate"]) {
      const track = run[name];
      if (track) track.x.forEach((x, i) => include(x, track.y[i]));
    }
    if (!(bounds.x0 <= bounds.x1)) { include(0, 0); include(1, 1); }
    const margin = 0.03 * Math.max(bounds.x1 - bounds.x0, bounds.y1 - bounds.y0, 1);
    bounds.x0 -= margin; bounds.y0 -= margin; bounds.x1 += margin; bounds.y1 += margin;
    return bounds;
  };
  const imageOf = (map) => {
    const image = new Image();
    image.onload = () => draw();
    image.src = map.png;
    return image;
  };
  // A run with its parts in the place of their numbers, made when it is first looked at.
  const whole = (short) => {
    const run = { ...short };
    for (const [name, value] of Object.entries(short)) {
      if (name !== "title" && name !== "start" && name !== "end") run[name] = parts[value];
    }
    run.bounds = boundsOf(run);
    run.scanTimes = (run.scans || []).map((scan) => scan.t);
    run.image = run.map && imageOf(run.map);
    return run;
  };
  const ready = [];
  let run = null, bounds = null;

  let scale = 1;
  const px = (x) => (x - bounds.x0) * scale;
  const py = (y) => (bounds.y1 - y) * scale;
  const c = canvas.getContext("2d");

  const path = (track, until, color, dash) => {
    if (!track) return;
    c.beginPath();
    const last = index(track.t, until);
    for (let i = 0; i <= last; ++i) c.lineTo(px(track.x[i]), py(track.y[i]));
    c.strokeStyle = color; c.lineWidth = 2; c.setLineDash(dash); c.stroke(); c.setLineDash([]);
  };
  const robot = (p, color, filled) => {
    if (!p) return;
    const r = Math.max(0.25 * scale, 6);
    c.save(); c.translate(px(p.x), py(p.y)); c.rotate(-p.a);
    c.beginPath(); c.moveTo(1.5 * r, 0); c.lineTo(-r, r); c.lineTo(-0.5 * r, 0); c.lineTo(-r, -r); c.closePath();
    if (filled) { c.fillStyle = color; c.fill(); }
    c.strokeStyle = color; c.lineWidth = 2; c.stroke(); c.restore();
  };
  const drawOthers = (t) => {
    for (const other of run.others || []) {
      const p = pose(other, t);
      if (!p) continue;
      c.beginPath();
      c.arc(px(p.x), py(p.y), Math.max(other.radius * scale, 3), 0, 2 * Math.PI);
      c.fillStyle = other.kind === "person" ? "#cc79a7" : "#999"; c.fill();
      c.lineWidth = 1; c.strokeStyle = "#444"; c.stroke();
    }
  };
  // Who is followed: where he went, a disc where he is seen, a dashed ring where he is but held to be.
  const drawTracks = (t) => {
    c.font = "12px sans-serif";
    for (const track of run.tracks || []) {
      const now = index(track.t, t);
      if (now < 0 || t > track.t[now] + 0.5) continue;
      const color = kOfTracks[track.id % kOfTracks.length];
      const x = px(track.x[now]), y = py(track.y[now]);
      c.strokeStyle = c.fillStyle = color; c.lineWidth = 2;
      c.beginPath();
      for (let i = index(track.t, t - kTrail) + 1; i <= now; ++i) c.lineTo(px(track.x[i]), py(track.y[i]));
      c.stroke();
      c.beginPath();
      if (track.hidden[now]) {
        c.arc(x, y, Math.max(track.s[now] * scale, 5), 0, 2 * Math.PI);
        c.setLineDash([3, 3]); c.stroke(); c.setLineDash([]);
      } else {
        c.arc(x, y, 4, 0, 2 * Math.PI); c.fill();
      }
      c.lineWidth = 3; c.strokeStyle = "#fff";
      c.strokeText(track.id, x + 6, y - 6); c.fillText(track.id, x + 6, y - 6);
    }
  };
  const drawScan = (t, at) => {
    const i = index(run.scanTimes, t);
    if (i < 0 || !at) return;
    const scan = run.scans[i], [lx, ly, la] = scan.laser;
    const cos = Math.cos(at.a), sin = Math.sin(at.a);
    const dynamic = new Set(run.labels && shown("labels") ? run.labels[i] : []);
    scan.cm.forEach((cm, k) => {
      if (cm === 0) return;
      c.fillStyle = dynamic.has(k) ? kColors.dynamic : kColors.scan;
      const bearing = la + scan.first + k * scan.step;
      const hx = lx + cm / 100 * Math.cos(bearing), hy = ly + cm / 100 * Math.sin(bearing);
      c.fillRect(px(at.x + cos * hx - sin * hy) - 1.5, py(at.y + sin * hx + cos * hy) - 1.5, 3, 3);
    });
  };
  function draw() {
    const ratio = window.devicePixelRatio || 1;
    const width = canvas.clientWidth;
    const shape = (bounds.y1 - bounds.y0) / (bounds.x1 - bounds.x0);
    const height = Math.min(width * shape, 0.8 * Math.max(window.innerHeight, 400));
    scale = Math.min(width / (bounds.x1 - bounds.x0), height / (bounds.y1 - bounds.y0));
    canvas.style.height = `${height}px`;
    canvas.width = Math.round(width * ratio); canvas.height = Math.round(height * ratio);
    const left = (width - scale * (bounds.x1 - bounds.x0)) / 2;
    c.setTransform(ratio, 0, 0, ratio, left * ratio, 0);
    const t = Number(slider.value);
    if (run.image && run.image.complete && shown("map")) {
      c.imageSmoothingEnabled = false;
      c.drawImage(run.image, px(run.map.x), py(run.map.y + run.map.height), run.map.width * scale, run.map.height * scale);
    }
    c.strokeStyle = "#333"; c.lineWidth = 1;
    for (const line of run.outlines || []) {
      c.beginPath();
      for (let i = 0; i < line.length; i += 2) c.lineTo(px(line[i]), py(line[i + 1]));
      c.stroke();
    }
    if (shown("others")) drawOthers(t);
    const truth = pose(run.truth, t), estimate = pose(run.estimate, t);
    if (shown("odometry")) path(run.odometry, t, kColors.odometry, [2, 3]);
    if (shown("truth")) path(run.truth, t, kColors.truth, [7, 4]);
    if (shown("estimate")) path(run.estimate, t, kColors.estimate, []);
    if (shown("scans")) drawScan(t, estimate || truth);
    if (shown("tracks")) drawTracks(t);
    if (shown("truth")) robot(truth, kColors.truth, false);
    if (shown("estimate")) robot(estimate, kColors.estimate, true);
    const off = truth && estimate ? `, estimate off by ${Math.hypot(truth.x - estimate.x, truth.y - estimate.y).toFixed(2)} m` : "";
    clock.textContent = `${(t - run.start).toFixed(1)} s of ${(run.end - run.start).toFixed(1)} s${off}`;
  }

  let playing = false, before = 0;
  const step = (now) => {
    if (!playing) return;
    const t = Number(slider.value) + Number(speed.value) * (now - before) / 1000;
    before = now;
    slider.value = Math.min(t, run.end);
    draw();
    if (t >= run.end) play(false); else requestAnimationFrame(step);
  };
  const play = (on) => {
    playing = on;
    button.textContent = on ? "Pause" : "Play";
    if (!on) return;
    if (Number(slider.value) >= run.end) slider.value = run.start;
    requestAnimationFrame((now) => { before = now; step(now); });
  };
  // Another run at the same moment, as far as it lasts.
  const choose = (number) => {
    const t = run === null ? runs[number].start : Number(slider.value);
    run = ready[number] = ready[number] || whole(runs[number]);
    bounds = run.bounds;
    slider.min = run.start; slider.max = run.end; slider.value = t;
    for (const input of layers) input.disabled = !(input.name in run);
    draw();
  };
  slider.step = "any";
  button.addEventListener("click", () => play(!playing));
  slider.addEventListener("input", draw);
  if (choice !== null) choice.addEventListener("change", () => choose(choice.selectedIndex));
  for (const input of layers) input.addEventListener("change", draw);
  const keys = {
    " ": () => play(!playing),
    ArrowLeft: () => { slider.value = Number(slider.value) - 1; draw(); },
    ArrowRight: () => { slider.value = Number(slider.value) + 1; draw(); },
    ArrowUp: () => another(-1),
    ArrowDown: () => another(1),
  };
  const another = (by) => {
    if (choice === null) return;
    choice.selectedIndex = Math.min(Math.max(choice.selectedIndex + by, 0), runs.length - 1);
    choose(choice.selectedIndex);
  };
  canvas.addEventListener("keydown", (event) => {
    if (!(event.key in keys) || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    keys[event.key]();
  });
  choose(choice === null ? 0 : choice.selectedIndex);
  new ResizeObserver(draw).observe(box);
}
