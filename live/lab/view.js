// What is seen of a scene: bodies, planes, shadows and pairs in three dimensions, drawn with three.js.
import {
  AmbientLight, BufferAttribute, BufferGeometry, CircleGeometry, Color, DirectionalLight, DoubleSide, Fog, HemisphereLight, InstancedMesh, Line, LineBasicMaterial,
  LineSegments, LinearSRGBColorSpace, Matrix4, Mesh, MeshBasicMaterial, MeshStandardMaterial, PCFSoftShadowMap, PerspectiveCamera, Plane, Quaternion, Raycaster, Scene, SphereGeometry,
  Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { keyOf, pairAt, pairCount, size } from "./pairs.js";

const MOST_MARKS = 4000;
const MARK = { pushes: new Color("#e8552d"), rests: new Color("#8a8f98"), chosen: new Color("#ffd23f") };
const NEAR_A_MARK = 16; // pixels
const NUMBERS_A_JOINT = 9, JOINT = new Color("#2b7fd4"), MOST_JOINTS = 2000; // as common/scenes/shown_scene.hpp has them

export class View {
  constructor(place) {
    this.place = place;
    this.renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFSoftShadowMap;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.canvas = this.renderer.domElement;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "img");
    place.prepend(this.canvas);
    this.camera = new PerspectiveCamera(35, 2, 0.01, 1000);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.addEventListener("change", () => { this.onmove?.(this); this.draw(); });
    this.ray = new Raycaster();
    this.listen();
    new ResizeObserver(() => this.resize()).observe(place);
  }

  // ------------------------------------------------------------------------------------------------ what is shown
  show(scene, frame) {
    this.scene?.traverse(object => { object.geometry?.dispose(); object.material?.dispose(); });
    this.scene = new Scene();
    this.described = scene;
    this.bodies = [];
    let first = 0;
    for (const body of scene.bodies) {
      this.bodies.push(this.meshOf(body, first, frame));
      first += body.vertices;
    }
    this.measure(frame);
    this.addLights();
    for (const plane of scene.planes) this.addPlane(plane);
    this.addMarks();
    this.spring = new Line(new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array(6), 3)), new LineBasicMaterial({ color: "#e0a526" }));
    this.spring.visible = false;
    this.spring.frustumCulled = false;
    this.scene.add(this.spring);
    this.theme();
    this.look(scene.camera_given ? { eye: [...scene.eye], target: [...scene.target] } : this.afar());
    this.camera.fov = scene.camera_given ? scene.field_of_view : 35;
    this.resize();
    this.update(frame);
  }

  meshOf(body, first, frame) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * body.vertices), 3));
    geometry.setIndex(new BufferAttribute(new Uint32Array(body.faces), 1));
    const material = new MeshStandardMaterial({ color: new Color().setRGB(...body.colour, LinearSRGBColorSpace), roughness: 0.62, metalness: 0.02, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1, flatShading: !body.smooth });
    const mesh = new Mesh(geometry, material);
    mesh.castShadow = mesh.receiveShadow = true;
    mesh.frustumCulled = false;
    this.scene.add(mesh);
    if (!body.smooth) this.addCreases(body, geometry, frame, first);
    return { mesh, first, count: body.vertices, smooth: body.smooth, still: body.still };
  }

  // Lines along edges whose faces lie in different planes at the start, on the vertices of the body itself.
  addCreases(body, geometry, frame, first) {
    const at = i => new Vector3().fromArray(frame.positions, 3 * (first + i)), normals = new Map(), lines = [];
    for (let f = 0; f < body.faces.length; f += 3) {
      const corners = [...body.faces.slice(f, f + 3)], [a, b, c] = corners.map(at), normal = b.sub(a).cross(c.sub(a)).normalize();
      corners.forEach((u, k) => {
        const v = corners[(k + 1) % 3], edge = u < v ? `${u} ${v}` : `${v} ${u}`;
        if (!normals.has(edge)) normals.set(edge, normal);
        else if (normals.get(edge).dot(normal) < 0.94) lines.push(u, v);
      });
    }
    const creases = new BufferGeometry().setIndex(lines).setAttribute("position", geometry.attributes.position);
    const shown = new LineSegments(creases, new LineBasicMaterial({ color: "#10151c", transparent: true, opacity: 0.45 }));
    shown.frustumCulled = false;
    this.scene.add(shown);
  }

  // The box of all that moves, or of all: it says how large shadows, marks and steps of the camera are.
  measure(frame) {
    const moving = this.bodies.filter(body => !body.still), low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (const body of moving.length ? moving : this.bodies)
      for (let i = 3 * body.first; i < 3 * (body.first + body.count); ++i) {
        low[i % 3] = Math.min(low[i % 3], frame.positions[i]);
        high[i % 3] = Math.max(high[i % 3], frame.positions[i]);
      }
    this.middle = new Vector3(...low.map((x, k) => (x + high[k]) / 2));
    this.radius = Math.max(0.05, Math.hypot(...high.map((x, k) => x - low[k])) / 2);
  }

  addLights() {
    this.scene.add(new HemisphereLight("#e8f1ff", "#6d6a66", 1.3), new AmbientLight("#ffffff", 0.2));
    const sun = new DirectionalLight("#fff4e2", 2.6), reach = 4 * this.radius;
    sun.position.copy(this.middle).add(new Vector3(0.55, 1.3, 0.75).multiplyScalar(reach));
    sun.target.position.copy(this.middle);
    sun.castShadow = true;
    sun.shadow.mapSize.set(2048, 2048);
    Object.assign(sun.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: reach / 100, far: 4 * reach });
    sun.shadow.bias = -2e-4;
    sun.shadow.normalBias = 1.2e-2 * this.radius;
    sun.shadow.radius = 5;
    this.scene.add(sun, sun.target);
  }

  addPlane({ point, normal }) {
    const ground = new Mesh(new CircleGeometry(40 * this.radius, 64), new MeshStandardMaterial({ color: "#b9b4a8", roughness: 0.95 }));
    const up = new Vector3(...normal), at = new Vector3(...point);
    at.add(this.middle.clone().sub(at).projectOnPlane(up)); // the disc lies below what moves
    ground.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), up));
    ground.position.copy(at);
    ground.receiveShadow = true;
    ground.userData.ground = true;
    this.scene.add(ground, this.gridOn(ground, up));
  }

  // Lines a metre apart, or a power of ten of that, by which the eye sees how fast things go.
  gridOn(ground, up) {
    const cell = 10 ** Math.round(Math.log10(this.radius / 1.5)), reach = 30, points = [];
    for (let i = -reach; i <= reach; ++i)
      for (let k = -reach; k < reach; ++k) points.push(i, 0, k, i, 0, k + 1, k, 0, i, k + 1, 0, i); // a piece a cell: some drivers drop a line that begins behind the eye
    const geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array(points.map(x => cell * x)), 3));
    const grid = new LineSegments(geometry, new LineBasicMaterial({ color: "#7d848e", transparent: true, opacity: 0.3, depthWrite: false }));
    grid.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), up);
    grid.position.copy(ground.position).addScaledVector(up, 2e-3 * this.radius);
    return grid;
  }

  addMarks() {
    this.marks = new InstancedMesh(new SphereGeometry(1, 12, 8), new MeshBasicMaterial({ depthTest: false, transparent: true, opacity: 0.9 }), MOST_MARKS);
    this.normals = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ color: MARK.pushes, depthTest: false, transparent: true }));
    this.normals.geometry.setAttribute("position", new BufferAttribute(new Float32Array(6 * MOST_MARKS), 3));
    this.joints = new InstancedMesh(new SphereGeometry(1, 12, 8), new MeshBasicMaterial({ color: JOINT, depthTest: false, transparent: true, opacity: 0.9 }), MOST_JOINTS);
    this.rods = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ color: JOINT, depthTest: false, transparent: true }));
    this.rods.geometry.setAttribute("position", new BufferAttribute(new Float32Array(12 * MOST_JOINTS), 3));
    for (const object of [this.joints, this.rods, this.marks, this.normals]) {
      object.frustumCulled = false;
      object.renderOrder = 2;
      object.visible = this.showsPairs ?? true;
      this.scene.add(object);
    }
  }

  theme() {
    const style = getComputedStyle(this.place), dark = document.documentElement.classList.contains("dark-mode");
    const page = new Color(style.getPropertyValue("--page-background-color").trim() || "#ffffff");
    if (!this.scene) return;
    this.scene.background = dark ? page.clone().lerp(new Color("#31435c"), 0.35) : new Color("#e6edf4");
    this.scene.fog = new Fog(this.scene.background, 14 * this.radius, 38 * this.radius);
    this.scene.traverse(object => { if (object.userData.ground) object.material.color.set(dark ? "#4c535e" : "#d3d6da"); });
    this.draw();
  }

  // --------------------------------------------------------------------------------------------- from frame to frame
  update(frame) {
    this.frame = frame;
    for (const { mesh, first, count, smooth } of this.bodies) {
      mesh.geometry.attributes.position.array.set(frame.positions.subarray(3 * first, 3 * (first + count)));
      mesh.geometry.attributes.position.needsUpdate = true;
      if (smooth) mesh.geometry.computeVertexNormals();
      mesh.geometry.boundingSphere = mesh.geometry.boundingBox = null;
    }
    this.placeMarks();
    this.placeJoints();
    this.draw();
  }

  // A ball at the joint's point on A, a line from there to its point on B, and one along its axis.
  placeJoints() {
    const numbers = this.frame.joints, count = Math.min(numbers.length / NUMBERS_A_JOINT, MOST_JOINTS), lines = this.rods.geometry.attributes.position.array, at = new Matrix4();
    const radius = 0.02 * this.camera.position.distanceTo(this.controls.target) * Math.tan(this.camera.fov * Math.PI / 360);
    for (let i = 0; i < count; ++i) {
      const [a, b, axis] = [0, 3, 6].map(from => [...numbers.subarray(NUMBERS_A_JOINT * i + from, NUMBERS_A_JOINT * i + from + 3)]);
      this.joints.setMatrixAt(i, at.makeScale(radius, radius, radius).setPosition(...a));
      lines.set([...a, ...b, ...a.map((x, k) => x - 4 * radius * axis[k]), ...a.map((x, k) => x + 4 * radius * axis[k])], 12 * i);
    }
    this.joints.count = count;
    this.joints.instanceMatrix.needsUpdate = true;
    this.rods.geometry.setDrawRange(0, 4 * count);
    this.rods.geometry.attributes.position.needsUpdate = true;
  }

  placeMarks() {
    const count = Math.min(pairCount(this.frame), MOST_MARKS), lines = this.normals.geometry.attributes.position.array, at = new Matrix4();
    let largest = 0;
    for (let i = 0; i < count; ++i) largest = Math.max(largest, size(pairAt(this.frame, i).impulse));
    const mark = 0.016 * this.camera.position.distanceTo(this.controls.target) * Math.tan(this.camera.fov * Math.PI / 360);
    for (let i = 0; i < count; ++i) {
      const pair = pairAt(this.frame, i), impulse = size(pair.impulse), chosen = this.chosen === keyOf(pair);
      const length = largest > 0 ? 0.32 * this.radius * Math.sqrt(impulse / largest) : 0;
      const radius = mark * (chosen ? 1.7 : impulse > 0 ? 1 : 0.6);
      this.marks.setMatrixAt(i, at.makeScale(radius, radius, radius).setPosition(...pair.point));
      this.marks.setColorAt(i, chosen ? MARK.chosen : impulse > 0 ? MARK.pushes : MARK.rests);
      lines.set([...pair.point, ...pair.point.map((x, k) => x + length * pair.normal[k])], 6 * i);
    }
    this.marks.count = count;
    this.marks.instanceMatrix.needsUpdate = true;
    if (this.marks.instanceColor) this.marks.instanceColor.needsUpdate = true;
    this.normals.geometry.setDrawRange(0, 2 * count);
    this.normals.geometry.attributes.position.needsUpdate = true;
  }

  showPairs(yes) {
    this.showsPairs = yes;
    for (const object of [this.joints, this.rods, this.marks, this.normals]) if (object) object.visible = yes;
    this.draw();
  }

  draw() {
    if (this.asked || !this.scene) return;
    this.asked = requestAnimationFrame(() => {
      this.asked = 0;
      this.renderer.render(this.scene, this.camera);
    });
  }

  drawNow() { this.renderer.render(this.scene, this.camera); }

  // ------------------------------------------------------------------------------------------------------- the camera
  afar() {
    const eye = this.middle.clone().add(new Vector3(0.9, 0.62, 1.5).normalize().multiplyScalar(5.2 * this.radius));
    return { eye: eye.toArray(), target: this.middle.toArray() };
  }

  look({ eye, target }) {
    this.camera.position.set(...eye);
    this.controls.target.set(...target);
    const away = this.camera.position.distanceTo(this.controls.target);
    this.camera.near = away / 200;
    this.camera.far = 100 * Math.max(away, this.radius ?? 1);
    this.camera.updateProjectionMatrix();
    this.controls.update();
  }

  looks() { return { eye: this.camera.position.toArray(), target: this.controls.target.toArray() }; }

  resize() {
    const width = this.place.clientWidth, height = this.place.clientHeight;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    // A narrow screen shows the same width as one of 3 to 2.
    this.camera.zoom = Math.min(1, this.camera.aspect / 1.25);
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  // ------------------------------------------------------------------------------------------------------ the pointer
  listen() {
    let pressed = null;
    const onScreen = event => {
      const box = this.canvas.getBoundingClientRect();
      return { x: event.clientX - box.left, y: event.clientY - box.top, box };
    };
    const aim = event => {
      const { x, y, box } = onScreen(event);
      this.ray.setFromCamera(new Vector2(2 * x / box.width - 1, 1 - 2 * y / box.height), this.camera);
    };
    this.canvas.addEventListener("pointerdown", event => {
      if (!this.scene || event.button !== 0) return;
      pressed = { ...onScreen(event), moved: false };
      aim(event);
      const [hit] = this.ray.intersectObjects(this.bodies.map(body => body.mesh), false);
      const body = hit ? this.bodies.findIndex(({ mesh }) => mesh === hit.object) : -1;
      if (body < 0 || !this.pulls || this.bodies[body].still || this.markAt(pressed) !== null) return;
      pressed.grip = { body, face: hit.faceIndex, plane: new Plane().setFromNormalAndCoplanarPoint(this.camera.getWorldDirection(new Vector3()), hit.point) };
      this.controls.enabled = false;
      this.canvas.setPointerCapture(event.pointerId);
    }, { capture: true });
    this.canvas.addEventListener("pointermove", event => {
      if (!pressed) return;
      const { x, y } = onScreen(event);
      pressed.moved ||= Math.hypot(x - pressed.x, y - pressed.y) > 4;
      if (!pressed.grip || !pressed.moved) return;
      aim(event);
      const target = this.ray.ray.intersectPlane(pressed.grip.plane, new Vector3());
      if (target) this.pull({ ...pressed.grip, target });
    });
    const release = () => {
      if (pressed && !pressed.moved) this.onchoose?.(this.markAt(pressed));
      if (this.grip) this.pull(null);
      this.controls.enabled = true;
      pressed = null;
    };
    this.canvas.addEventListener("pointerup", release);
    this.canvas.addEventListener("pointercancel", release);
  }

  pull(grip) {
    this.grip = grip;
    this.spring.visible = Boolean(grip);
    if (grip) this.placeSpring();
    this.onpull?.(this, grip && { body: grip.body, face: grip.face, target: grip.target.toArray() });
    this.draw();
  }

  placeSpring() {
    if (!this.grip) return;
    const { mesh } = this.bodies[this.grip.body], { index, attributes: { position } } = mesh.geometry, from = new Vector3();
    for (let k = 0; k < 3; ++k) from.add(new Vector3().fromBufferAttribute(position, index.getX(3 * this.grip.face + k)).divideScalar(3));
    this.spring.geometry.attributes.position.array.set([...from.toArray(), ...this.grip.target.toArray()]);
    this.spring.geometry.attributes.position.needsUpdate = true;
  }

  // The key of the nearest mark on the screen, or null.
  markAt({ x, y, box }) {
    let nearest = NEAR_A_MARK, found = null;
    if (this.marks?.visible)
      for (let i = 0; i < Math.min(pairCount(this.frame), MOST_MARKS); ++i) {
        const pair = pairAt(this.frame, i), at = new Vector3(...pair.point).project(this.camera);
        const away = Math.hypot((at.x + 1) / 2 * box.width - x, (1 - at.y) / 2 * box.height - y);
        if (at.z < 1 && away < nearest) { nearest = away; found = keyOf(pair); }
      }
    return found;
  }

  choose(key) {
    this.chosen = key;
    if (this.frame) this.placeMarks();
    this.draw();
  }

  end() {
    this.controls.dispose();
    this.renderer.dispose();
    this.canvas.remove();
  }
}
