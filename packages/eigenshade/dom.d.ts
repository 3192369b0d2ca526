// Names of the declarations, empty where a program's `lib` has no `dom`.

interface AbortSignal {}
interface Event {}
interface EventTarget {}
interface HTMLCanvasElement {}
interface OffscreenCanvas {}
interface Response {}
interface URL {}
interface WebGL2RenderingContext {}
declare namespace WebAssembly {
  interface Instance {}
}
