namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Compares file names with numbers. Consecutive digits count as one number, so 2 comes before 10.</summary>
sealed class NumberedNames : IComparer<string>
{
    public int Compare(string a, string b)
    {
        int i = 0, j = 0;
        while (i < a.Length && j < b.Length)
        {
            int order;
            if (char.IsAsciiDigit(a[i]) && char.IsAsciiDigit(b[j]))
            {
                ReadOnlySpan<char> first = NumberAt(a, ref i), second = NumberAt(b, ref j);
                order = first.Length != second.Length ? first.Length - second.Length : first.SequenceCompareTo(second);
            }
            else
            {
                order = a[i++] - b[j++];
            }
            if (order != 0) return order;
        }
        var rest = (a.Length - i) - (b.Length - j);
        // At this point, the names can differ only by leading zeros.
        return rest != 0 ? rest : string.CompareOrdinal(a, b);
    }

    // Reads a number of any length, without leading zeros.
    static ReadOnlySpan<char> NumberAt(string name, ref int at)
    {
        var start = at;
        while (at < name.Length && char.IsAsciiDigit(name[at])) at++;
        return name.AsSpan(start, at - start).TrimStart('0');
    }
}
