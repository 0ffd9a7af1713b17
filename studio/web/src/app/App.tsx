// SPDX-License-Identifier: GPL-3.0-or-later
// The page: documents at the left, the room in the middle, what there is to say of it at the right.
import { lazy, Suspense } from "preact/compat";
import { Start } from "../brief/Start";
import { Progress } from "../brief/Progress";
import { Inspector } from "../inspector/Inspector";
import { Plan } from "../plan/Plan";
import { isWorking } from "../state/jobs";
import type { OpenRoom } from "../state/open_room";
import { route } from "../state/route";
import { useStudio } from "../state/studio";
import { VariantStrip } from "../variants/VariantStrip";
import { Banner } from "./Banner";
import { FileDrop } from "./FileDrop";
import { KeysDialog } from "./KeysDialog";
import { MessageBar } from "./MessageBar";
import { usePageKeys } from "./keys";
import { Sidebar } from "./Sidebar";
import { Tips } from "./Tips";
import { TopBar } from "./TopBar";

const Scene = lazy(() => import("../three/Scene"));
const RoomEditor = lazy(() => import("../room/RoomEditor"));
const JobsPage = lazy(() => import("../jobs/JobsPage"));

function Panes({ room }: { room: OpenRoom }) {
  const panes = useStudio().settings.panes.value;
  return (
    <div class={`panes is-${panes}`}>
      {panes !== "3d" && <Plan key={room.id} room={room} />}
      {panes !== "plan" && (
        <Suspense fallback={<div class="scene is-loading">Loading the view...</div>}>
          <Scene key={room.id} room={room} />
        </Suspense>
      )}
    </div>
  );
}

function RoomPage({ room }: { room: OpenRoom }) {
  const hasRoom = room.layout.value?.graph?.room !== undefined;
  if (!hasRoom || (isWorking(room.document.value) && room.pieces.value.size === 0))
    return (
      <main class="stage">
        <Progress room={room} />
      </main>
    );
  return (
    <>
      <main class="stage has-variants" aria-label="Room">
        <Panes room={room} />
        <VariantStrip key={room.id} room={room} />
      </main>
      <Inspector key={room.id} room={room} />
    </>
  );
}

function Middle() {
  const room = useStudio().open.value;
  if (route.value.page === "document") return room ? <RoomPage room={room} /> : <main class="stage" aria-busy="true" />;
  const { page, id } = route.value;
  if (page === "draw")
    return (
      <Suspense fallback={<main class="stage" aria-busy="true" />}>
        <RoomEditor key={id} id={id} />
      </Suspense>
    );
  if (page === "jobs")
    return (
      <Suspense fallback={<main class="stage" aria-busy="true" />}>
        <JobsPage id={id} />
      </Suspense>
    );
  return (
    <main class="stage is-start">
      <Start />
    </main>
  );
}

export function App() {
  const studio = useStudio();
  usePageKeys(studio);
  return (
    <div class={`page is-sidebar-${studio.settings.sidebar.value}`}>
      <TopBar />
      <Banner />
      <div class="body">
        <Sidebar />
        <Middle />
      </div>
      <MessageBar />
      <Tips />
      <KeysDialog />
      <FileDrop />
    </div>
  );
}
