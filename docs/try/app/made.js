// What an equilibrium is made with beside the scene: a spin, a name, a direction, an attitude, its coordinates.
export const MADE = { eliminate: "Eliminated name (empty: the library chooses)",
  direction: "Direction k: three expressions, or stereographic; empty for any",
  pointing: "Body axes along roll, pitch and yaw", point: "Its coordinates" };
const EMPTY = { pointing: "1, 2, 3" };
const at = (id) => document.getElementById(id);

// An entry of a scene file as it is typed.
export function asGiven(value = "") {
  if (Array.isArray(value)) return value.join(", ");
  return typeof value === "object" ? Object.entries(value).map((pair) => pair.join("=")).join(", ") : value;
}

// Those entries of the scene that name its equilibrium.
export function given({ equilibrium, made }) {
  const table = equilibrium && equilibrium !== "point" ? { equilibrium } : {};
  if (equilibrium === "point") table.point = (made.point ?? "").split(",").map((entry) => entry.trim());
  for (const name of ["eliminate", "direction", "pointing"]) if (made[name]?.trim()) table[name] = made[name];
  return table;
}

// The row for what the equilibrium that is chosen is made with.
export function making(state, { made_with: name }) {
  at("spin-row").hidden = name !== "spin";
  at("made-row").hidden = !(name in MADE);
  if (!(name in MADE)) return;
  at("made-label").textContent = MADE[name];
  at("made").name = name;
  at("made").value = state.made[name] ?? EMPTY[name] ?? "";
}
