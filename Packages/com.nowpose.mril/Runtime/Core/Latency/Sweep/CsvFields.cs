using System.Collections.Generic;
using System.Text;

namespace Nowpose.Latency.Sweep
{
    /// <summary>Splits one line of CSV into fields, which may be quoted.</summary>
    static class CsvFields
    {
        /// <param name="into">Receives the fields; cleared first.</param>
        public static void Split(string line, List<string> into)
        {
            into.Clear();
            for (var at = 0; at <= line.Length; at++) into.Add(at < line.Length && line[at] == '"' ? Quoted(line, ref at) : Plain(line, ref at));
        }

        static string Plain(string line, ref int at)
        {
            var start = at;
            at = line.IndexOf(',', start);
            if (at < 0) at = line.Length;
            return line.Substring(start, at - start).Trim();
        }

        static string Quoted(string line, ref int at)
        {
            var field = new StringBuilder();
            for (at++; at < line.Length; at++)
            {
                if (line[at] != '"') field.Append(line[at]);
                else if (at + 1 < line.Length && line[at + 1] == '"') field.Append(line[at++]);
                else break;
            }
            // Text between the closing quote and the comma belongs to the field, so that no input is lost.
            at++;
            return field.Append(at < line.Length ? Plain(line, ref at) : "").ToString();
        }
    }
}
