// SPDX-License-Identifier: GPL-3.0-or-later
import { useLayoutEffect, useRef } from "preact/hooks";
import { elementsOf } from "./svg";

// A group with elements of the server in it.
export function Drawn({ svg, name }: { svg: string; name?: string }) {
  const group = useRef<SVGGElement>(null);
  useLayoutEffect(() => { group.current!.replaceChildren(...elementsOf(svg)); }, [svg]);
  return <g ref={group} class={name} />;
}
