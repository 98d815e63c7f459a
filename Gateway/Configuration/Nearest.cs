namespace Nowpose.Gateway.Configuration;

/// <summary>Finds the known word that a misspelt word probably means.</summary>
static class Nearest
{
    /// <returns>
    /// The known word with the smallest edit distance to <paramref name="word"/>. Null if more than one letter differs and the distance
    /// exceeds a third of the known word's length.
    /// </returns>
    public static string Of(string word, IEnumerable<string> known)
    {
        var (near, letters) = known.Select(other => (other, Distance(word, other))).MinBy(pair => pair.Item2);
        return letters <= Math.Max(1, near.Length / 3) ? near : null;
    }

    // Returns the Levenshtein distance: the minimum number of letters to add, remove or replace.
    static int Distance(string a, string b)
    {
        // Bounds the computing time for arbitrary input.
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
