// The model as a file: a job of the server, with progress and an end.
import { by, element } from "./elements";
import { said } from "./gallery";
import { menu } from "./menu";
import { notice } from "./messages";
import { ask, post } from "./server";

interface Job {
  job: string; state: string; progress: number; error: { message: string } | null; result: { certain?: boolean } | null
}

/** Makes the menu of formats. `model`: the model as it is then, and the name of its document. */
export function offerFiles(formats: string[], model: () => { text: string; language: string; name: string }): void {
  let ended: AbortController | null = null;
  by("stop-download").onclick = () => ended?.abort();
  const show = (words: string): void => {
    by("download-running").hidden = !words;
    by("download-doing").textContent = words;
  };

  async function download(extension: string): Promise<void> {
    const { text, language, name } = model(), ending = extension.slice(1);
    if (!text.trim()) return notice(`There is nothing to download as ${ending}: the model is empty, or too long.`);
    if (ended) return notice("Another download is being made. Wait for it, or cancel it.");
    const { signal } = ended = new AbortController();
    let number = "";
    try {
      notice("");
      show(`${ending} …`);
      let job = await post<Job>("/api/files", { text, language, extension });
      number = job.job;
      while (job.state === "waiting" || job.state === "working") {
        signal.throwIfAborted();
        show(`${ending}: ${Math.round(100 * job.progress)} %`);
        job = await (await ask(`/api/jobs/${job.job}?state=${job.state}&progress=${job.progress}`, { signal })).json();
      }
      if (job.state !== "done") throw new Error(job.error?.message ?? "the server stopped it");
      const saved = name.replace(/\.\w+$/, "") + extension;
      element("a", { href: `/api/jobs/${number}/file?name=${encodeURIComponent(saved)}`, download: saved }).click();
      if (job.result?.certain === false)
        notice("The file is written. It may lack parts that are thinner than its cells.");
    } catch (error) {
      if (signal.aborted) {
        if (number) void ask(`/api/jobs/${number}`, { method: "DELETE" }).catch(() => {});
      } else notice(`No ${ending} file: ${said(error)}`);
    } finally {
      ended = null;
      show("");
    }
  }

  menu(by("download"), () => formats.map((each) => ({ words: each.slice(1), act: () => void download(each) })));
}
