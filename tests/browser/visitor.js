// A visitor in a hurry: changes the page at random moments, and writes down what it shows unmarked meanwhile.
({ seed, changes, fields, numbers, places }) => {
  const at = (id) => document.getElementById(id), seen = new Map();
  let state = seed, moments = 0;
  const random = () => {                                // mulberry32
    state = state + 0x6D2B79F5 | 0;
    let t = Math.imul(state ^ state >>> 15, state | 1);
    t ^= t + Math.imul(t ^ t >>> 7, t | 61);
    return ((t ^ t >>> 14) >>> 0) / 4294967296;
  };
  const one = (all) => all[Math.floor(random() * all.length)];
  const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

  const marked = (place) => Boolean(place.closest("main [aria-busy=true]"));
  const unmarked = (place) => place?.checkVisibility({ visibilityProperty: true }) && !marked(place);
  const latex = (place) => [...place.querySelectorAll("annotation")].map((one) => one.textContent);
  const inputs = (place) => Object.fromEntries([...place.querySelectorAll("input[id]")].map(
    (input) => [input.id.slice(6), input.value]));

  // The question that stands on the page: what its fields say.
  function question() {
    const made = at("made-row").hidden ? ["", ""] : [at("made").name, at("made").value];
    return JSON.stringify({ texts: ["potential", "orbit", "inertia", "gyrostatic_momentum"].map((id) => at(id).value),
      equilibrium: document.querySelector("#equilibria :checked")?.value ?? "", spin: at("spin").value, made,
      values: inputs(at("values")) });
  }

  function look() {
    moments += 1;
    const asked = question();
    const say = (what, answer) => {
      const key = JSON.stringify([asked, what, answer]);
      if (!seen.has(key)) seen.set(key, [asked, what, answer]);
    };
    if (unmarked(at("conditions"))) say("conditions", latex(at("conditions")));
    if (unmarked(at("values"))) say("names", Object.keys(inputs(at("values"))));
    if (!marked(at("error"))) say("error", at("error").textContent);
    if (!marked(at("wrong"))) say("wrong", at("wrong").textContent);
    if (unmarked(at("verdict")) && document.querySelector(".badge")) {
      say("verdict", [document.querySelector(".badge").textContent.trim(), latex(at("reasons"))]);
    }
    for (const place of ["between", "blocks"]) if (unmarked(at(place)) && latex(at(place)).length) say(place, latex(at(place)));
    if (unmarked(at("here")) && at("here").textContent) say("here", at("here").textContent);
    if (unmarked(at("copied"))) say("copied", at("copied").value);
    const axes = ["across", "upwards"].map((id) => at(id).value);
    if (unmarked(at("no-chart")) && at("no-chart").textContent) say("no-chart", [axes, at("no-chart").textContent]);
    if (unmarked(at("chart"))) say("chart", [axes, colours(axes)]);
    if (unmarked(at("motion"))) {
      say("motion", [inputs(at("more")), at("push").value, at("motion").parentElement.querySelector("#state").textContent]);
    }
  }

  function colours(axes) {
    const key = [...document.querySelectorAll(".key span")].map((span) => [
      getComputedStyle(span).backgroundColor.match(/\d+/g).slice(0, 3).join(), span.className]);
    const ranges = axes.map((name) => {
      const { low, high } = at(`value-${name}`)?.closest(".value").dataset ?? {};
      return [name, low ?? null, high ?? null];
    });
    return { key, ranges, values: inputs(at("values")), cells: cells(places) };
  }

  const set = (input, text, event = "input") => {
    if (!input) return;
    input.value = text;
    input.dispatchEvent(new Event(event));
  };
  const links = [location.hash];
  const ACTIONS = [
    [40, () => set(one([...document.querySelectorAll("#values input[id]")]), one(numbers))],
    [8, () => {
      const slider = one([...document.querySelectorAll("#values [type=range]")]);
      set(slider, slider && Number(slider.min) + random() * (slider.max - slider.min));
    }],
    [15, () => set(at("potential"), one(fields))],
    [3, () => set(at("inertia"), one(["I1, I1, I3", "I1, I2, I3", "2, 1, 3/2", "I1, I1"]))],
    [3, () => set(at("orbit"), one(["", "omega0", "mu=398600, radius=6778"]))],
    [12, () => set(at("example"), one([...document.querySelectorAll("#example option:enabled")]).value, "change")],
    [10, () => one([...document.querySelectorAll("#equilibria input")])?.click()],
    [3, () => set(at("spin"), one(["omega3_0", "pi3_0"]), "change")],
    [4, () => {
      const select = one([at("across"), at("upwards")]);
      set(select, one([...select.options])?.value ?? "", "change");
    }],
    [4, () => {
      const { x, y, width } = at("chart").getBoundingClientRect();
      const place = { clientX: x + width * random(), clientY: y + width * random(), bubbles: true };
      for (const kind of ["pointerdown", "pointerup"]) at("chart").dispatchEvent(new PointerEvent(kind, place));
    }],
    [3, () => at("chart").dispatchEvent(new KeyboardEvent("keydown", { key: one(["+", "+", "-"]) }))],
    [1, () => at("whole").click()],
    [2, () => set(at("push"), one(["0.05", "0.1", "0.2"]))],
    [3, () => one([...document.querySelectorAll("[data-copy]")]).click()],
    [1, () => at(one(["opened", "derivation"])).toggleAttribute("open")],
    [2, () => links.push(location.hash)],
    [2, () => { location.hash = one(links); }]];
  const sum = ACTIONS.reduce((all, [weight]) => all + weight, 0);
  function act() {
    let rest = random() * sum;
    for (const [weight, action] of ACTIONS) if ((rest -= weight) < 0) return action();
  }

  const busy = () => document.body.ariaBusy === "true" || document.querySelector("main [aria-busy=true]");
  async function settled() {
    for (let n = 0; n < 600 && busy(); n++) await sleep(50);
  }

  return (async () => {
    const observer = new MutationObserver(look);
    observer.observe(document.body, { subtree: true, childList: true, characterData: true, attributes: true });
    let on = true;
    const frames = () => { look(); if (on) requestAnimationFrame(frames); };
    frames();
    for (let n = 0; n < changes; n++) {
      act();
      look();
      const chance = random();
      if (chance < 0.6) await sleep(100 * random());
      else if (chance < 0.75) await sleep(400 * random());
      else if (chance < 0.83) await settled();          // else at once
    }
    await settled();
    look();
    on = false;
    observer.disconnect();
    return { moments, seen: [...seen.values()] };
  })();
}
