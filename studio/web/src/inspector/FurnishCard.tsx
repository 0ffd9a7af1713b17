// SPDX-License-Identifier: GPL-3.0-or-later
// While a job furnishes a room in which something stands: how far it is; and what became of it.
import { useEffect, useRef } from "preact/hooks";
import { JobState } from "../gen/flair/v1/job_pb";
import { cancelJob } from "../jobs/cancel";
import { undo } from "../state/commands";
import { isWorking, stagesOf } from "../state/jobs";
import type { OpenRoom } from "../state/open_room";
import { useStudio } from "../state/studio";
import { stageWords, withStop } from "./words";

// Tells once how a job ended that was seen to run.
function useEnding(room: OpenRoom): void {
  const { jobId, jobState, jobError } = room.document.value;
  const running = useRef("");
  useEffect(() => {
    if (isWorking(room.document.peek())) running.current = jobId;
    else if (running.current === jobId && jobId) {
      running.current = "";
      if (jobState === JobState.SUCCEEDED)
        room.tell("Furnished anew.", [{ label: "Back to what was before", run: () => void undo(room) }]);
      else if (jobState === JobState.CANCELLED) room.tell("Nothing was furnished: the room is as it was.");
      else room.tell(withStop(`Furnishing failed: ${jobError || "the job ended"}`), [{ label: "All right", run: () => {} }]);
    }
  }, [jobId, jobState]);
}

export function FurnishCard({ room }: { room: OpenRoom }) {
  const studio = useStudio();
  useEnding(room);
  const { jobId } = room.document.value;
  if (!isWorking(room.document.value)) return null;
  const stages = stagesOf(studio.jobs.events.value.get(jobId) ?? []);
  const last = stages.at(-1);
  return (
    <section class="furnish-card" role="status">
      <span class="spinner" />
      <span>Furnishing: {last ? stageWords(last.stage).toLowerCase() : "starting"}</span>
      <button class="button" onClick={() => void cancelJob(studio, jobId)}>Cancel</button>
    </section>
  );
}
