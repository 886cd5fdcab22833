// Draws a surface with the graphics card; null where the browser has no WebGL.
import {
  AmbientLight,
  BufferAttribute,
  BufferGeometry,
  ColorManagement,
  DirectionalLight,
  DoubleSide,
  LinearSRGBColorSpace,
  Mesh,
  MeshLambertMaterial,
  Scene,
  WebGLRenderer,
} from "three";

const full = Math.PI; // the intensity of a light that gives a white surface all of its colour

export function webgl_painter(canvas) {
  if (!document.createElement("canvas").getContext("webgl2")) return null;
  ColorManagement.enabled = false; // colours are shown as they are given
  const renderer = new WebGLRenderer({ canvas, alpha: true, antialias: true });
  renderer.outputColorSpace = LinearSRGBColorSpace;
  const geometry = new BufferGeometry();
  const scene = new Scene();
  const lamp = new DirectionalLight(0xffffff, 0.65 * full);
  const mesh = new Mesh(geometry, new MeshLambertMaterial({ vertexColors: true, side: DoubleSide }));
  mesh.frustumCulled = false; // its bounds are not kept up to date
  scene.add(new AmbientLight(0xffffff, 0.4 * full), lamp, mesh);
  return {
    name: "webgl",
    resize(width, height) {
      renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
      renderer.setSize(width, height, false);
    },
    set_surface({ positions, triangles }) {
      geometry.setAttribute("position", new BufferAttribute(positions, 3));
      if (geometry.index?.array !== triangles) geometry.setIndex(new BufferAttribute(triangles, 1));
      geometry.computeVertexNormals();
    },
    set_colours(bytes) {
      geometry.setAttribute("color", new BufferAttribute(bytes, 3, true));
    },
    paint(camera) {
      lamp.position.copy(camera.position);
      renderer.render(scene, camera);
    },
  };
}
