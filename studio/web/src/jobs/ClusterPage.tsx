// SPDX-License-Identifier: GPL-3.0-or-later
// Queue, orchestrators and workers, as `flair top` shows them.
import type { ComponentChildren } from "preact";
import { useMemo } from "preact/hooks";
import { timestampDate } from "@bufbuild/protobuf/wkt";
import { useStudio } from "../state/studio";
import { Asked } from "./Asked";
import { workersOf } from "./cluster";
import { usePolling } from "./polling";
import { Rates, rateText } from "./rates";
import { age, count, lastingText, workerText } from "./words";

// The first `texts` columns are set to the left.
function Table({
  name,
  heads,
  texts = 1,
  children,
}: {
  name: string;
  heads: readonly string[];
  texts?: number;
  children: ComponentChildren;
}) {
  return (
    <table class="figures" aria-label={name}>
      <thead>
        <tr>
          {heads.map((head, i) => (
            <th key={head} scope="col" class={i < texts ? "is-text" : ""}>
              {head}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>{children}</tbody>
    </table>
  );
}

const bad = (number: number | bigint) => (number > 0 ? "is-bad" : "");

export function ClusterPage() {
  const { clients } = useStudio(),
    rates = useMemo(() => new Rates(), []);
  const asked = usePolling("cluster", () => clients.orchestrator.getCluster({}));
  const { value } = asked;
  if (!value) return <Asked of={asked} />;
  const now = Date.now(),
    workers = workersOf(value);
  const orchestrators = value.orchestrators.map((one) => ({
    one,
    rate: rates.see(
      `o ${one.id}`,
      one.reportTime ? timestampDate(one.reportTime).getTime() : now,
      Number(one.succeededCount + one.failedCount),
    ),
  }));
  const sum = (pick: (one: (typeof orchestrators)[number]["one"]) => number | bigint) =>
    orchestrators.reduce((total, { one }) => total + Number(pick(one)), 0);
  const known = orchestrators.flatMap(({ rate }) => (rate === undefined ? [] : [rate]));
  const totals: Array<[string, string, string]> = [
    ["Waiting", count(value.queuedCount), ""],
    ["Running", `${count(sum((one) => one.runningCount))} of ${count(sum((one) => one.runningLimit))}`, ""],
    ["Jobs a second", rateText(known.length > 0 ? known.reduce((a, b) => a + b, 0) : undefined), ""],
    ["Done", count(sum((one) => one.succeededCount)), ""],
    ["Failed", count(sum((one) => one.failedCount)), bad(sum((one) => one.failedCount))],
    ["Retried", count(sum((one) => one.retriedCount)), ""],
  ];
  return (
    <>
      <Asked of={asked} />
      <dl class="totals">
        {totals.map(([label, text, name]) => (
          <div key={label}>
            <dt>{label}</dt>
            <dd class={name}>{text}</dd>
          </div>
        ))}
      </dl>
      {orchestrators.length === 0 && (
        <p class="hint">
          This machine works alone: its own store, and workers within this program. A cluster is seen with{" "}
          <code>--orchestrator</code>.
        </p>
      )}
      {orchestrators.length > 0 && (
        <Table name="Orchestrators" heads={["Orchestrator", "Running", "Done", "Failed", "Retried", "Jobs/s", "Seen"]}>
          {orchestrators.map(({ one, rate }) => (
            <tr key={one.id}>
              <td class="is-text" title={`${one.id}, ${one.build}`}>
                {one.host || one.id}
              </td>
              <td>
                {one.runningCount} of {one.runningLimit}
              </td>
              <td>{count(one.succeededCount)}</td>
              <td class={bad(one.failedCount)}>{count(one.failedCount)}</td>
              <td>{count(one.retriedCount)}</td>
              <td>{rateText(rate)}</td>
              <td class={age(one.reportTime, now) > 10 ? "is-warning" : ""}>
                {age(one.reportTime, now) < 2 ? "now" : `${lastingText(age(one.reportTime, now))} ago`}
              </td>
            </tr>
          ))}
        </Table>
      )}
      {workers.length > 0 && (
        <Table
          name="Workers"
          texts={2}
          heads={["Worker", "Address", "State", "Busy", "Calls", "Failed", "Latency", "Calls/s"]}
        >
          {workers.map((worker) => (
            <tr key={`${worker.stage} ${worker.address}`}>
              <td class="is-text">{worker.stage}</td>
              <td class="is-text is-soft" title={worker.address}>
                {worker.address}
              </td>
              <td class={`is-${workerText(worker.state)}`}>{workerText(worker.state)}</td>
              <td>{worker.busy}</td>
              <td>{count(worker.calls)}</td>
              <td class={bad(worker.failures)}>{count(worker.failures)}</td>
              <td>{worker.latency > 0 ? lastingText(worker.latency) : "–"}</td>
              <td>{rateText(rates.see(`w ${worker.stage} ${worker.address}`, now, worker.calls))}</td>
            </tr>
          ))}
        </Table>
      )}
    </>
  );
}
