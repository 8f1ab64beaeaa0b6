// Buttons that take the view elsewhere: a picture, the full screen, a link to the moment.
import { element } from "./dom.js";
import { fragmentOf, momentOf } from "./link.js";

/** How long (ms) a sentence about what a button did is shown. */
const SHOWN = 4000;

/** Where buttons say what they did. */
export function speaker() {
  const said = element("output", { class: "said" });
  const say = (words) => {
    said.textContent = words;
    setTimeout(() => (said.textContent = ""), SHOWN);
  };
  return { said, say };
}

/** The button that saves the view of a plan. */
export const pictureButton = (view, data, shown) =>
  element("button", { type: "button", title: "Save the view as a PNG", click: () => savePicture(view, data, shown) }, "Picture");

function savePicture(view, { result }, shown) {
  const name = `${result.scene}-${shown.values.time.toFixed(2)}s.png`;
  view.picture((picture) => {
    const address = URL.createObjectURL(picture);
    element("a", { href: address, download: name }).click();
    URL.revokeObjectURL(address);
  });
}

/** The button that shows something on the whole screen; none where the browser does not do that. */
export function fullScreenButton(stage) {
  if (!document.fullscreenEnabled) return null;
  const isFull = () => document.fullscreenElement === stage;
  const button = element("button", { type: "button", click: () => (isFull() ? document.exitFullscreen() : stage.requestFullscreen()) });
  const name = () => (button.textContent = isFull() ? "Leave full screen" : "Full screen");
  document.addEventListener("fullscreenchange", name);
  name();
  return button;
}

/** The button that copies a link to the moment; none within a notebook, where the page has no address. */
export const linkButton = (view, shown, say) =>
  location.protocol === "about:"
    ? null
    : element("button", { type: "button", title: "Copy a link to this moment", click: () => copyLink(view, shown, say) }, "Link");

async function copyLink(view, shown, say) {
  shown.set({ playing: false });
  // The address is the link also where a page may not write to the clipboard.
  location.replace(fragmentOf(shown.values, view.viewpoint()));
  try {
    await navigator.clipboard.writeText(location.href);
    say("Link copied");
  } catch {
    say("The address of this window is the link");
  }
}

/** Shows the moment that the address names, now and whenever it changes; the plots do so without a view, too. */
export function followAddress(stage, view, { motions }, shown) {
  const follow = () => {
    const moment = momentOf(location.hash, motions, shown.values);
    if (moment === null) return;
    shown.set(moment.values);
    if (moment.viewpoint !== null) view?.lookFrom(moment.viewpoint);
    stage.scrollIntoView({ block: "nearest" });
  };
  addEventListener("hashchange", follow);
  follow();
}
