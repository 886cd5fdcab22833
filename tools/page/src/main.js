// Begins the live page: the data tell of which kind it is.
import uplot_style from "uplot/dist/uPlot.min.css";
import { unpacked } from "./data.js";
import { element } from "./dom.js";
import { ModesPage } from "./modes/page.js";
import { RunPage } from "./run/page.js";
import { ScanPage } from "./scan/page.js";
import { StatesPage } from "./states/page.js";
import style from "./style.css";

function page_of(parts, size) {
  if (parts.has("scan.csv")) return new ScanPage(parts);
  if (parts.has("states.csv")) return new StatesPage(parts);
  return parts.has("modes.csv") ? new ModesPage(parts) : new RunPage(parts, size);
}

async function begin() {
  const place = document.getElementById("explore"), script = document.getElementById("sbeh-data");
  document.head.append(element("style", {}, uplot_style + style));
  try {
    if (!("DecompressionStream" in globalThis))
      throw new Error("this browser is too old for it: it lacks DecompressionStream (there since 2023)");
    const parts = await unpacked(script);
    const page = page_of(parts, script.textContent.length);
    place.replaceChildren(page.element);
    if (parts.has("series.csv")) document.querySelector(".charts")?.closest("section").setAttribute("hidden", "");
    place.dataset.state = "live";
  } catch (error) {
    place.dataset.state = "failed";
    place.replaceChildren(
      element(
        "p",
        { class: "failed", role: "alert" },
        `The results cannot be explored here: ${error.message}. The pictures and tables below are as they should be. ` +
          "If the file is damaged, copy it again, or make it again with sbeh report.",
      ),
    );
    console.error(error);
  }
}

begin();
