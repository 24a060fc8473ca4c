"""The sections of the page, a module each; their prose stands in page/section. A section is "" where there are no records for it."""
