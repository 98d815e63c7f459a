namespace Nowpose.Gateway.Configuration;

/// <summary>Finds the known word that was probably meant.</summary>
static class Nearest
{
    /// <returns>The word with the smallest edit distance to <paramref name="word"/>; null if the distance exceeds a third of its letters.</returns>
    public static string Of(string word, IEnumerable<string> known)
    {
        var (near, letters) = known.Select(other => (other, Distance(word, other))).MinBy(pair => pair.Item2);
        return letters <= Math.Max(1, near.Length / 3) ? near : null;
    }

    // Levenshtein distance: letters added, removed or replaced.
    static int Distance(string a, string b)
    {
        // Longer words have no near match.
        if (a.Length > 64) return int.MaxValue;
        var row = Enumerable.Range(0, b.Length + 1).ToArray();
        for (var i = 1; i <= a.Length; i++)
        {
            var diagonal = row[0];
            row[0] = i;
            for (var j = 1; j <= b.Length; j++)
            {
                var replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
                diagonal = row[j];
                row[j] = Math.Min(replaced, Math.Min(row[j], row[j - 1]) + 1);
            }
        }

        return row[b.Length];
    }
}
