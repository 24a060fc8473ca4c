"""The report of voxc bench: records of measurements as one page that needs nothing else, and as comma-separated values.

records and searches read what a folder holds; catalogue makes of it what all sections need; charts draws by Matplotlib;
sections has a module for each section of the page, and page puts them together.
"""
