"""Which of many results are shown, and in which order."""

from collections import Counter

from ..storage.part_query import FAILED


def group_of(row):
    """A row's category, or `FAILED`."""
    return FAILED if row.error_kind else row.category


class ResultOrder:
    """Rows, and the numbers of those that are shown, in the order in which they are.

    Attributes
    ----------
    rows : list of PartRow
        In the order in which they came.
    shown : list of int
        Indices into `rows`.
    counts : Counter
        Rows by category or `FAILED`, shown or not.

    Notes
    -----
    Keys are made once per row and column, and a sorted list to which some were added is sorted
    again in one pass, so 100,000 rows can grow and be sorted while somebody looks at them.
    Comparing in Python, as a QSortFilterProxyModel would call for, takes seconds.
    """

    def __init__(self):
        self.words, self.hidden = (), frozenset()
        self._key, self._reverse = None, False
        self.clear()

    def clear(self):
        """Forget all rows."""
        self.rows, self.shown, self.counts = [], [], Counter()
        self._texts, self._keys = [], []

    def add(self, rows):
        """Add rows.

        Returns
        -------
        list of int
            Those of them that are to be shown, not yet among `shown` and not in order.
        """
        first = len(self.rows)
        self.rows += rows
        self._texts += map(_searched_text, rows)
        if self._key is not None:
            self._keys += map(self._sorting_key, rows)
        self.counts.update(map(group_of, rows))
        return [index for index in range(first, len(self.rows)) if self._matches(index)]

    def remove_files(self, files):
        """Forget the rows of some files."""
        kept = [index for index, row in enumerate(self.rows) if row.file not in files]
        self.counts.subtract(group_of(row) for row in self.rows if row.file in files)
        place = {index: at for at, index in enumerate(kept)}
        self.shown = [place[index] for index in self.shown if index in place]
        self.rows = [self.rows[index] for index in kept]
        self._texts = [self._texts[index] for index in kept]
        if self._key is not None:
            self._keys = [self._keys[index] for index in kept]

    def select(self, words, hidden):
        """Show only rows that hold all words and whose category is not hidden.

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
        """Sort by a key from now on; what is equal by it stays as it was sorted before.

        Parameters
        ----------
        key : callable or None
            From a PartRow to a text, or a number or None, which comes last both ways; None for
            the order in which the rows came.
        reverse : bool
        """
        self._key, self._reverse = key, reverse
        self._keys = [] if key is None else list(map(self._sorting_key, self.rows))
        if key is None:
            self.shown.sort()
        self.arrange()

    @property
    def is_sorted_by_key(self):
        """Whether rows are shown in another order than that in which they came."""
        return self._key is not None

    def arrange(self):
        """Put the shown rows in order."""
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
