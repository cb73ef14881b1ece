"""The study of mirrors that gather dust at real sites."""
