// What an equilibrium is made with beside the scene: a spin, a name, a direction, an attitude, its coordinates.

/** @type {Record<string, string>} */
export const MADE = { eliminate: "Eliminated name (empty: the library chooses)",
  direction: "Direction k: three expressions, or stereographic; empty for any",
  pointing: "Body axes along roll, pitch and yaw", point: "Its coordinates" };
/** @type {Record<string, string>} */
export const EMPTY = { pointing: "1, 2, 3" };

/**
 * An entry of a scene file as it is typed.
 * @param {any} value
 * @returns {string}
 */
export function asGiven(value = "") {
  if (Array.isArray(value)) return value.join(", ");
  return typeof value === "object" ? Object.entries(value).map((pair) => pair.join("=")).join(", ") : value;
}

/**
 * Those entries of the scene that name its equilibrium.
 * @param {{ equilibrium: string, made: Record<string, string> }} asked
 */
export function given({ equilibrium, made }) {
  /** @type {Record<string, any>} */
  const table = equilibrium && equilibrium !== "point" ? { equilibrium } : {};
  if (equilibrium === "point") table.point = (made.point ?? "").split(",").map((entry) => entry.trim());
  for (const name of ["eliminate", "direction", "pointing"]) if (made[name]?.trim()) table[name] = made[name];
  return table;
}
