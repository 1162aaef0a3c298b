"""Filters and sorts the rows of the results table."""

from collections import Counter

from ...storage.index.part_query import FAILED


def group_of(row):
    """A row's category, or `FAILED`."""
    return FAILED if row.error_kind else row.category


class ResultsOrder:
    """All rows, and the indices of the visible rows in display order.

    Attributes
    ----------
    rows : list of PartRow
        In order of arrival.
    shown : list of int
        Indices into `rows`.
    counts : Counter
        Number of rows by category or `FAILED`, including hidden rows.

    Notes
    -----
    Sort keys are computed once per row and column, and Python re-sorts a mostly sorted list in one pass,
    so that 100,000 rows stay responsive while more arrive. A QSortFilterProxyModel would compare in Python,
    which takes seconds.
    """

    def __init__(self):
        self.words, self.hidden = (), frozenset()
        self._key, self._reverse = None, False
        self.clear()

    def clear(self):
        """Remove all rows."""
        self.rows, self.shown, self.counts = [], [], Counter()
        self._texts, self._keys = [], []

    def add(self, rows):
        """Add rows.

        Returns
        -------
        list of int
            Indices of the new visible rows, neither added to `shown` nor sorted.
        """
        first = len(self.rows)
        self.rows += rows
        self._texts += map(_searched_text, rows)
        if self._key is not None:
            self._keys += map(self._sorting_key, rows)
        self.counts.update(map(group_of, rows))
        return [index for index in range(first, len(self.rows)) if self._matches(index)]

    def remove_files(self, files):
        """Remove the rows of some files."""
        remaining = [index for index, row in enumerate(self.rows) if row.file not in files]
        self.counts.subtract(group_of(row) for row in self.rows if row.file in files)
        new_indices = {index: new for new, index in enumerate(remaining)}
        self.shown = [new_indices[index] for index in self.shown if index in new_indices]
        self.rows = [self.rows[index] for index in remaining]
        self._texts = [self._texts[index] for index in remaining]
        if self._key is not None:
            self._keys = [self._keys[index] for index in remaining]

    def select(self, words, hidden):
        """Show only rows that contain all words and whose category is not hidden.

        Parameters
        ----------
        words : iterable of str
        hidden : iterable of str
            Categories, or `FAILED`.
        """
        self.words = tuple(word.casefold() for word in words)
        self.hidden = frozenset(hidden)
        self.shown = [index for index in range(len(self.rows)) if self._matches(index)]
        self.arrange()

    def sort(self, key, reverse=False):
        """Set the sort key; equal rows keep their previous order.

        Parameters
        ----------
        key : callable or None
            Returns a text, a number or None for a PartRow; None sorts last in both directions.
            Without a key, rows are in order of arrival.
        reverse : bool
        """
        self._key, self._reverse = key, reverse
        self._keys = [] if key is None else list(map(self._sorting_key, self.rows))
        if key is None:
            self.shown.sort()
        self.arrange()

    @property
    def is_sorted_by_key(self):
        """Whether rows are sorted by a key, not in order of arrival."""
        return self._key is not None

    def arrange(self):
        """Sort the visible rows."""
        if self._key is not None:
            self.shown.sort(key=self._keys.__getitem__, reverse=self._reverse)

    def _sorting_key(self, row):
        value = self._key(row)
        if value is None:
            return float("-inf") if self._reverse else float("inf")
        return value

    def _matches(self, index):
        text = self._texts[index]
        return (all(word in text for word in self.words)
                and group_of(self.rows[index]) not in self.hidden)


def _searched_text(row):
    return "\n".join(filter(None, (row.file, row.label, row.part))).casefold()
