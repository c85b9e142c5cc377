"""``python -m app.chart``: publish plotly.js before the first start, for read-only file systems."""

from app.chart import publish_plotly_js

publish_plotly_js()
