// SPDX-License-Identifier: GPL-3.0-or-later
// What went wrong with a call, in the server's own words where it had any.
import { Code, ConnectError } from "@connectrpc/connect";

export function sentenceOf(error: unknown): string {
  if (isAway(error)) return "The server does not answer.";
  // The field's path is for programs.
  return ConnectError.from(error).rawMessage.replace(/^[a-z_]+(\.[a-z_]+|\[\d+\])*: /, "") || "Something went wrong.";
}

// Nobody answered: the server is gone, or the network is.
export function isAway(error: unknown): boolean {
  if (error instanceof TypeError) return true;
  const problem = ConnectError.from(error);
  return problem.code === Code.Unavailable || problem.cause instanceof TypeError;
}

// The server does not know this page: it was started anew.
export function isRefused(error: unknown): boolean {
  const { code } = ConnectError.from(error);
  return code === Code.Unauthenticated || code === Code.PermissionDenied;
}

// Somebody else has changed the document.
export const isConflict = (error: unknown): boolean => ConnectError.from(error).code === Code.Aborted;

// Nothing is wrong: there is nothing to undo, or everything is settled.
export const isNothingToDo = (error: unknown): boolean => ConnectError.from(error).code === Code.FailedPrecondition;

// Whoever asked gave up.
export const isCancelled = (error: unknown): boolean => ConnectError.from(error).code === Code.Canceled;

export const isUnknownCall = (error: unknown): boolean => ConnectError.from(error).code === Code.Unimplemented;
