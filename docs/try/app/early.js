// A page that is kept on the visitor's machine starts the library before its own scripts have come; another one starts it
// after what is needed to show a prepared answer.
import { Analyser } from "./analyser.js";

export const analyser = new Analyser();
if (navigator.serviceWorker?.controller) analyser.start();
