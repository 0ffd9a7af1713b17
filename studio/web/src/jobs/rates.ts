// SPDX-License-Identifier: GPL-3.0-or-later
// How fast counters grow, over the last half minute of looks at them.
interface Look {
  readonly time: number;
  readonly count: number;
}

const kWindow = 30_000;

export class Rates {
  private readonly looks = new Map<string, Look[]>();

  // Notes a counter and returns what it grows a second; undefined after one look, or when it was set back.
  see(name: string, time: number, count: number): number | undefined {
    const before = (this.looks.get(name) ?? []).filter((look) => time - look.time <= kWindow && look.count <= count);
    const looks = before.at(-1)?.time === time ? before : [...before, { time, count }];
    this.looks.set(name, looks);
    const first = looks[0]!;
    return time > first.time ? ((count - first.count) * 1000) / (time - first.time) : undefined;
  }
}

export const rateText = (perSecond: number | undefined): string =>
  perSecond === undefined ? "–" : perSecond < 10 ? perSecond.toFixed(1) : perSecond.toFixed(0);
