"""The memory of a page: values that were set by hand, the link that holds them, files, and background jobs.

Nothing here knows a page. The record of a session is used as ``session.part(...)``.
"""

from app.session.record import KEY, PageState, Session, channel, current, keep_opened, opened, part

__all__ = ["KEY", "PageState", "Session", "channel", "current", "keep_opened", "opened", "part"]
