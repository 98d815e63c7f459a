namespace Nowpose.ArFoundation
{
    /// <summary>What an anchor may be kept as: a cell's name as it is.</summary>
    static class AnchorNames
    {
        /// <summary>A cell has a name, no text; what stores take beyond was not found out.</summary>
        public const int Longest = 128;

        /// <summary>Null when it may be.</summary>
        public static string FaultOf(string name)
        {
            if (string.IsNullOrWhiteSpace(name)) return "an anchor needs a name to be kept; give the cell one";
            return name.Length <= Longest
                ? null
                : "the name of an anchor has " + name.Length + " characters, allowed are " + Longest + "; give the cell a shorter one";
        }
    }
}
