namespace Nowpose.Anchoring
{
    /// <summary>What a marker is called in a message: payloads may be long, and hold line breaks.</summary>
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
