import { mount } from "svelte";
import App from "./App.svelte";
import "./style.css";

const target = document.getElementById("lab");
if (target) mount(App, { target });

// Kept for visits without a network; the page needs nothing of it, so it waits until all else is there.
if (import.meta.env.PROD && "serviceWorker" in navigator)
  addEventListener("load", () => {
    navigator.serviceWorker.register("./offline.js").catch(() => undefined);
  });
