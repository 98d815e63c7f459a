using System.Text;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Formats events as CSV (RFC 4180) for spreadsheets.</summary>
static class EventText
{
    const string Header = "id,kind,which,what,reason,level,since_utc,until_utc,text";

    // First characters that make a spreadsheet interpret a string as a formula. Such strings are quoted, because names come from clients.
    static readonly char[] FormulaStarts = ['=', '+', '-', '@', '\t', '\r'];

    public static string Csv(IEnumerable<EventView> events)
    {
        var text = new StringBuilder(Header).Append("\r\n");
        foreach (var one in events)
        {
            text.Append(one.Id);
            foreach (var field in new[] { one.Kind, one.Which, one.What, one.Reason, one.Level, one.SinceUtc, one.UntilUtc ?? "", one.Text ?? "" })
                text.Append(',').Append(Quoted(field));
            text.Append("\r\n");
        }

        return text.ToString();
    }

    static string Quoted(string field)
    {
        field = string.Join('\n', field.Split('\n').Select(line => InputException.OneLine(line, int.MaxValue)));
        var safe = field.Length > 0 && FormulaStarts.Contains(field[0]) ? "'" + field : field;
        return $"\"{safe.Replace("\"", "\"\"", StringComparison.Ordinal)}\"";
    }
}
