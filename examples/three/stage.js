// What the pages share: a canvas with a camera that goes around, and the controls.

import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { lightPreset, materialPreset, presetNames } from "eigenshade";

/** A world on a canvas; a drag moves the camera around it. Call `frame` once, with what each frame does. */
export function stage(canvas) {
  const renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
  renderer.toneMapping = THREE.ACESFilmicToneMapping;
  renderer.setClearColor(0x222222);
  const world = new THREE.Scene();
  const camera = new THREE.PerspectiveCamera(35, 1, 0.1, 50);
  camera.position.set(0, 0.6, 5.5);
  const orbit = new OrbitControls(camera, canvas);
  const frame = (before = () => {}) =>
    renderer.setAnimationLoop((time) => {
      const { clientWidth, clientHeight } = canvas;
      const size = renderer.getSize(new THREE.Vector2());
      if (size.x !== clientWidth || size.y !== clientHeight) {
        renderer.setPixelRatio(devicePixelRatio);
        renderer.setSize(clientWidth, clientHeight, false);
        camera.aspect = clientWidth / clientHeight;
        camera.updateProjectionMatrix();
      }
      orbit.update();
      before(time);
      renderer.render(world, camera);
    });
  return { renderer, world, camera, frame };
}

/**
 * Fills the lists of a form, and calls `changed` with its values now and after each change: the
 * coefficients of a light, with at most so many sources, or material that is new, the turn in
 * radians.
 */
export async function controls(form, changed, sources = 0) {
  const names = await presetNames();
  const lists = { light: "lobby", material: "gold-metallic-paint" };
  for (const [kind, first] of Object.entries(lists)) {
    form[kind].append(...names[kind].map((name) => new Option(name, name, name === first, name === first)));
  }
  const shown = {};
  let asked = 0;
  const show = async () => {
    const [light, material, turn] = [form.light.value, form.material.value, ++asked];
    const [loadedLight, loadedMaterial] = await Promise.all([lightPreset(light, { sources }), materialPreset(material)]);
    // What was chosen since then is shown instead.
    if (turn !== asked) return;
    changed({
      light: shown.light !== light && loadedLight,
      material: shown.material !== material && loadedMaterial,
      turn: (form.turn.valueAsNumber * Math.PI) / 180,
      bumps: form.bumps.checked,
    });
    Object.assign(shown, { light, material });
  };
  const fault = ({ message }) => (document.querySelector("[role=alert]").textContent = message);
  form.addEventListener("input", () => show().catch(fault));
  form.addEventListener("submit", (event) => event.preventDefault());
  await show();
}
