namespace Nowpose.ArFoundation
{
    /// <summary>Checks names of saved anchors. The name of a cell is used unchanged.</summary>
    static class AnchorNames
    {
        /// <summary>Maximum length in characters: enough for the name of a cell. The stores' own limits are not known.</summary>
        public const int Longest = 128;

        /// <summary>Returns why a name cannot be used; null if it can.</summary>
        public static string FaultOf(string name)
        {
            if (string.IsNullOrWhiteSpace(name)) return "an anchor needs a name to be kept; give the cell one";
            return name.Length <= Longest
                ? null
                : "the name of an anchor has " + name.Length + " characters, allowed are " + Longest + "; give the cell a shorter one";
        }
    }
}
