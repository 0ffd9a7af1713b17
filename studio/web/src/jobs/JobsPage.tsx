// SPDX-License-Identifier: GPL-3.0-or-later
export default function JobsPage(_: { id: string }) { return <main class="stage" />; }
