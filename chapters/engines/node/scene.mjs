// What the engines of npm share: node ENGINE.mjs FOLDER SCENE.json; FOLDER has node_modules. A frame is a line of JSON on stdout.
import { readFileSync, writeSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const [, , folder, file] = process.argv;
export const scene = JSON.parse(readFileSync(file));
export const load = name => import(pathToFileURL(createRequire(join(folder, "_")).resolve(name)));
export const triples = flat => Array.from({ length: flat.length / 3 }, (_, i) => flat.slice(3 * i, 3 * i + 3));

/// Steps the scene and prints its frames; poses are read by pose(number of a body): [x, y, z, w, x, y, z].
export function run(step, pose) {
    const still = scene.bodies.map(body => [...body.position, ...body.orientation]);
    const print = ms => {
        const poses = scene.bodies.map((body, i) => body.moves ? pose(i) : still[i]);
        const line = Buffer.from(JSON.stringify({ ms, poses }) + "\n");
        for (let at = 0; at < line.length;) {
            try { at += writeSync(1, line, at); } catch (error) { if (error.code !== "EAGAIN") throw error; }
        }
    };
    print(0);
    for (let frame = 0; frame < scene.steps; ++frame) {
        const before = process.cpuUsage();
        for (let i = 0; i < scene.way.substeps; ++i) step();
        const spent = process.cpuUsage(before);
        print((spent.user + spent.system) / 1000);
    }
}
