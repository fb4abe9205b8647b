export type Vector = [number, number, number];

export interface Pair {
  kind: "vertex-plane" | "vertex-face" | "edge-edge";
  /** Numbers of the bodies, in the scene's order; a plane counts behind them. */
  bodyA: number;
  bodyB: number;
  featureA: number;
  featureB: number;
  /** [m] */
  point: Vector;
  /** Out of body B, of length 1. */
  normal: Vector;
  /** Negative inside [m]. */
  depth: number;
  /** On body A [N s]. */
  impulse: Vector;
  friction: Vector;
  /** [N/m] */
  stiffness: number;
  pushes: boolean;
}

export interface Body {
  name: string;
  /** How many of the positions are its vertices. */
  vertices: number;
  /** Three vertices a face, counted within the body. */
  faces: number[];
}

export interface Options {
  /** Whose solver: 1 to 12, by default 10. */
  chapter?: number;
  /** In place of a chapter: a method of chapter 13 by its name, as "xpbd". */
  solver?: number | string;
  /** Text of the meshes that the scene names as files, by name. */
  meshes?: Record<string, string>;
}

export class Simulation {
  /** Reads a scene, an object or its JSON text; throws an Error that names the place of a mistake. */
  static create(scene: object | string, options?: Options): Promise<Simulation>;
  readonly scene: { name: string; dt: number; duration: number; bodies: Body[]; warnings: string[] };
  /** Takes some steps; throws when the run breaks. */
  step(steps?: number): this;
  /** [s] */
  readonly time: number;
  /** Energies, counts and depths of the last step. */
  readonly numbers: Record<string, number>;
  /** x, y, z of all vertices of all bodies, one behind the other [m]. */
  readonly positions: Float64Array;
  readonly pairs: Pair[];
}
