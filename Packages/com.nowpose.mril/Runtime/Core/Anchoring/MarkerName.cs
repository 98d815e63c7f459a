namespace Nowpose.Anchoring
{
    /// <summary>Formats the name of a marker for messages: shortens long payloads and replaces line breaks.</summary>
    static class MarkerName
    {
        const int Most = 24;

        public static string Of(string payload)
        {
            var start = payload.Length > Most ? payload.Substring(0, Most - 1) + "…" : payload;
            var letters = start.ToCharArray();
            for (var i = 0; i < letters.Length; i++)
                if (char.IsControl(letters[i])) letters[i] = ' ';
            return "marker '" + new string(letters) + "'";
        }
    }
}
