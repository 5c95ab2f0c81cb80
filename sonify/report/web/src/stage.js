// Canvas with a camera that is rotated about the origin by mouse, touch and keys; drawn only after changes.
import * as THREE from 'three'
import { OrbitControls } from 'three/addons/controls/OrbitControls.js'

export const theme = (name) => new THREE.Color(getComputedStyle(document.documentElement).getPropertyValue(name).trim())

export class Stage {
  constructor(canvas, distance) {
    this.canvas = canvas
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true })
    this.scene = new THREE.Scene()
    this.scene.background = theme('--tint')
    this.camera = new THREE.PerspectiveCamera(32, 1, distance / 100, 100 * distance)
    this.camera.up.set(0, 0, 1)
    this.camera.position.set(0.6 * distance, 0.53 * distance, 0.6 * distance)
    const sun = new THREE.DirectionalLight(0xffffff, 2.2)
    sun.position.set(distance, -distance, 2 * distance)
    this.scene.add(sun, new THREE.HemisphereLight(0xffffff, 0x888888, 1.6))
    this.controls = new OrbitControls(this.camera, canvas)
    this.controls.enablePan = false
    this.controls.enableZoom = false
    this.controls.addEventListener('change', () => (this.stale = true))
    canvas.addEventListener('keydown', (event) => this.#key(event))
    new ResizeObserver(() => (this.stale = true)).observe(canvas)
    this.stale = true
  }

  #key(event) {
    const turn = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key]
    const nearer = { '+': 0.9, '=': 0.9, '-': 1 / 0.9 }[event.key]
    if (!turn && !nearer) return
    event.preventDefault()
    event.stopPropagation()
    const place = new THREE.Spherical().setFromVector3(this.camera.position.clone().applyAxisAngle(X, -Math.PI / 2))
    place.theta += turn?.[0] ?? 0
    place.phi = Math.min(Math.max(place.phi + (turn?.[1] ?? 0), 0.05), Math.PI - 0.05)
    place.radius *= nearer ?? 1
    this.camera.position.setFromSpherical(place).applyAxisAngle(X, Math.PI / 2)
    this.controls.update()
    this.stale = true
  }

  /** Release the graphics memory; a browser allows few contexts. */
  close() {
    this.controls.dispose()
    this.renderer.dispose()
    this.renderer.forceContextLoss()
  }

  draw() {
    if (!this.stale) return
    const { clientWidth: width, clientHeight: height } = this.canvas
    if (!width || !height) return
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2))
    this.renderer.setSize(width, height, false)
    this.camera.aspect = width / height
    this.camera.updateProjectionMatrix()
    this.renderer.render(this.scene, this.camera)
    this.stale = false
  }
}

const X = new THREE.Vector3(1, 0, 0)
