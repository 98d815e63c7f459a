namespace Nowpose.Cli;

/// <summary>Binary search in lists whose elements are in increasing order of a key.</summary>
static class SortedSearch
{
    /// <summary>Returns the number of elements whose key is at most a given one.</summary>
    public static int CountUpTo<T, TKey>(IReadOnlyList<T> sorted, TKey key, Func<T, TKey> keyOf)
        where TKey : IComparable<TKey>
    {
        var (low, high) = (0, sorted.Count);
        while (low < high)
        {
            var middle = (low + high) / 2;
            if (keyOf(sorted[middle]).CompareTo(key) <= 0) low = middle + 1;
            else high = middle;
        }
        return low;
    }
}
