// SPDX-License-Identifier: GPL-3.0-or-later
import { useStudio } from "../state/studio";
import { Icon } from "./Icon";

// Above the page while the server is gone; what is shown stays.
export function Banner() {
  const { connection } = useStudio();
  if (connection.value !== "away") return null;
  return (
    <div class="banner" role="status">
      <Icon name="warning" />
      <span>The studio's server does not answer. What you see is kept; it is tried again every few seconds.</span>
    </div>
  );
}
