"""What a browser reports while it shows a page: errors, files it did not get, requests to another machine."""

from __future__ import annotations

from typing import Any

from gate.exceptions import HARMLESS_MESSAGES

LOCAL = ("file:", "data:", "blob:")


def problems_of_events(events: list[dict[str, Any]]) -> list[str]:
    """What is wrong among the events of a page."""
    return [problem for event in events if (problem := _problem_of_event(event))]


def _problem_of_event(event: dict[str, Any]) -> str:
    about = event.get("params", {})
    match event.get("method"):
        case "Runtime.exceptionThrown":
            details = about["exceptionDetails"]
            text = details.get("exception", {}).get("description", details["text"])
        case "Runtime.consoleAPICalled" if about["type"] == "error":
            text = " ".join(str(value.get("value", value.get("description", ""))) for value in about["args"])
        case "Log.entryAdded" if about["entry"]["level"] == "error":
            text = f"{about['entry']['text']} {about['entry'].get('url', '')}"
        case "Network.loadingFailed" if not about.get("canceled"):
            text = f"a request failed: {about['errorText']}"
        case "Network.requestWillBeSent" if not about["request"]["url"].startswith(LOCAL):
            text = f"asks another machine for {about['request']['url']}"
        case _:
            return ""
    return "" if any(harmless in text for harmless in HARMLESS_MESSAGES) else text
